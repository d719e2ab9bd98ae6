/** Ranges A:B of whole numbers: A, A + 1, ..., B - 1. */
export interface Range {
  readonly from: number;
  readonly to: number;
}

/** Numbers of samples and frames are below this. */
export const RANGE_LIMIT = 2 ** 31;

/** @returns null unless the text is A:B with A < B */
export function parseRange(text: string): Range | null {
  const [, from = Number.NaN, to = Number.NaN] = /^(\d{1,10}):(\d{1,10})$/.exec(text)?.map(Number) ?? [];
  return from < to && to <= RANGE_LIMIT ? { from, to } : null;
}

/** Ranges with spaces between, '0:16 32:48'. */
export const formatRanges = (ranges: readonly Range[]): string =>
  ranges.map(({ from, to }) => `${from}:${to}`).join(' ');

export function parseRanges(text: string): Range[] | null {
  const ranges = text.split(' ').map(parseRange);
  return ranges.every((range) => range !== null) ? ranges : null;
}

export const rangesLength = (ranges: readonly Range[]): number =>
  ranges.reduce((sum, { from, to }) => sum + to - from, 0);

/** What both have; null if they have nothing in common. */
export function overlap(a: readonly Range[], b: readonly Range[]): Range | null {
  for (const one of a) {
    for (const other of b) {
      const common = { from: Math.max(one.from, other.from), to: Math.min(one.to, other.to) };
      if (common.from < common.to) return common;
    }
  }
  return null;
}

/** All of them in order, those that touch as one. */
export function joined(ranges: readonly Range[]): Range[] {
  const out: Range[] = [];
  for (const range of ranges.toSorted((a, b) => a.from - b.from)) {
    const last = out.at(-1);
    if (last?.to === range.from) out[out.length - 1] = { from: last.from, to: range.to };
    else out.push(range);
  }
  return out;
}
