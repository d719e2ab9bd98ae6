/** The van der Corput sequence: Halton's points have it in base 2 and 3. */
export function radicalInverse(index: number, base: number): number {
  let [result, digit, rest] = [0, 1 / base, index];
  while (rest > 0) {
    result += (rest % base) * digit;
    rest = Math.floor(rest / base);
    digit /= base;
  }
  return result;
}
