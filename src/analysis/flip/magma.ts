/**
 * The colour map magma of S. van der Walt and N. Smith (matplotlib, 2015, CC0), which rises evenly in lightness, by
 * linear interpolation of nine of its colours. sRGB bytes.
 */
const STOPS = ['000004', '1d1147', '51127c', '832681', 'b63679', 'e65164', 'fb8861', 'fec287', 'fcfdbf'].map(
  (hex) => [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)),
);

/** @param value 0 to 1; beyond, the colours of the ends */
export function magma(value: number): [r: number, g: number, b: number] {
  const place = Math.min(1, Math.max(0, value)) * (STOPS.length - 1);
  const i = Math.min(STOPS.length - 2, Math.floor(place));
  const [a, b] = [STOPS[i]!, STOPS[i + 1]!];
  const mix = (c: number) => Math.round(a[c]! + (b[c]! - a[c]!) * (place - i));
  return [mix(0), mix(1), mix(2)];
}
