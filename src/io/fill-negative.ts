/**
 * Gives RGB triples on a grid that are negative, which means unknown, the value of the nearest known one on the same
 * line: first along the first of the given axes, then what is left along the next.
 *
 * @param shape numbers of bins, the last varies fastest
 * @returns false if nothing is known at all
 */
export function fillNegative(
  triples: Float32Array,
  shape: readonly number[],
  axes: readonly number[],
): boolean {
  if (!triples.some((value, i) => i % 3 === 0 && value >= 0)) return false;
  for (const axis of axes) {
    const length = shape[axis] as number;
    const step = 3 * shape.slice(axis + 1).reduce((product, n) => product * n, 1);
    for (let outer = 0; outer < triples.length; outer += length * step)
      for (let start = outer; start < outer + step; start += 3) fillLine(triples, start, step, length);
  }
  return true;
}

function fillLine(triples: Float32Array, start: number, step: number, length: number): void {
  const known: number[] = [];
  for (let i = 0; i < length; i++) if ((triples[start + i * step] as number) >= 0) known.push(i);
  if (known.length === 0 || known.length === length) return;
  let next = 0;
  for (let i = 0; i < length; i++) {
    while (next < known.length - 1 && (known[next] as number) < i) next++;
    const [before, after] = [known[next - 1] ?? known[next]!, known[next]!];
    const nearest = Math.abs(before - i) <= Math.abs(after - i) ? before : after;
    const from = start + nearest * step;
    if (nearest !== i) triples.copyWithin(start + i * step, from, from + 3);
  }
}
