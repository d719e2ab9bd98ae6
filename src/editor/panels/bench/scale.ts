/** Axes of values: where a value lies between 0 and 1, and which values get a line. */
export interface Scale {
  readonly top: number;
  readonly ticks: readonly { readonly at: number; readonly label: string }[];
  /** 0 at the axis's beginning, 1 at its end; values below the beginning are at 0. */
  position(value: number): number;
}

/** Decades below the top that a logarithmic axis has at most. */
const MOST_DECADES = 6;

/** @param range where the axis ends; 0 for the largest value */
export function valueScale(values: readonly number[], log: boolean, range: number): Scale {
  const finite = values.filter((value) => Number.isFinite(value) && value > 0);
  const largest = range > 0 ? range : Math.max(0, ...finite) || 1;
  return log ? logScale(finite, largest) : linearScale(largest, range > 0);
}

function linearScale(largest: number, fixed: boolean): Scale {
  const power = 10 ** Math.floor(Math.log10(largest / 4));
  const step = [1, 2, 2.5, 5, 10].map((f) => f * power).find((s) => largest / s <= 4.001) ?? largest;
  const top = fixed ? largest : Math.max(largest * 1.04, step);
  const count = Math.floor(top / step + 1e-6);
  return {
    top,
    ticks: Array.from({ length: count + 1 }, (_, i) => ({
      at: (i * step) / top,
      label: shortNumber(i * step),
    })),
    position: (value) => Math.max(0, value / top),
  };
}

function logScale(values: readonly number[], largest: number): Scale {
  const end = Math.ceil(Math.log10(largest) - 1e-9);
  const smallest = values.reduce((least, value) => Math.min(least, value), largest);
  const begin = Math.max(end - MOST_DECADES, Math.min(end - 1, Math.floor(Math.log10(smallest))));
  const decades = end - begin;
  return {
    top: 10 ** end,
    ticks: Array.from({ length: decades + 1 }, (_, i) => ({
      at: i / decades,
      label: shortNumber(10 ** (begin + i)),
    })),
    position: (value) => (value > 0 ? Math.max(0, (Math.log10(value) - begin) / decades) : 0),
  };
}

/** Four digits: as many as one reads off a plot. */
export function shortNumber(value: number): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5)
    return value
      .toExponential(2)
      .replace(/\.?0+e/, 'e')
      .replace('e+', 'e');
  return String(Number(value.toPrecision(4)));
}
