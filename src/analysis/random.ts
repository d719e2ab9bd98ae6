const MULTIPLIER = 6364136223846793005n;
const INCREMENT = 1442695040888963407n;
const halves = (x: bigint): [high: number, low: number] => [Number(x >> 32n), Number(x & 0xffffffffn)];
const [MULTIPLIER_HIGH, MULTIPLIER_LOW] = halves(MULTIPLIER);
const [INCREMENT_HIGH, INCREMENT_LOW] = halves(INCREMENT);
const [LOW_HIGH, LOW_LOW] = [MULTIPLIER_LOW >>> 16, MULTIPLIER_LOW & 0xffff];

/**
 * A stream of numbers in [0, 1), the same for the same seed on every machine.
 *
 * PCG32 (M. E. O'Neill, 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms
 * for Random Number Generation"), the variant XSH-RR with 64 bits of state; two outputs make the 53 bits
 * of a number, so that samplers see the tails that 32 bits cannot express.
 */
export function createRandom(seed: number): () => number {
  const mask = 0xffffffffffffffffn;
  const step = (state: bigint) => (state * MULTIPLIER + INCREMENT) & mask;
  const first = step(step(0n) + (BigInt(seed) & mask));
  // In halves: integers of any length take ten times as long.
  let [high, low] = halves(first);

  const next32 = (): number => {
    const shifted = ((high ^ (high >>> 18)) << 5) | ((low ^ ((high << 14) | (low >>> 18))) >>> 27);
    const rotation = high >>> 27;
    // The product of the low halves, of which numbers hold 53 bits, by halves of theirs.
    const [a, b] = [low & 0xffff, low >>> 16];
    const middle = b * LOW_LOW + a * LOW_HIGH + Math.floor((a * LOW_LOW) / 65536);
    const carried = b * LOW_HIGH + Math.floor(middle / 65536);
    const sum = (Math.imul(low, MULTIPLIER_LOW) >>> 0) + INCREMENT_LOW;
    high =
      (carried +
        Math.imul(high, MULTIPLIER_LOW) +
        Math.imul(low, MULTIPLIER_HIGH) +
        INCREMENT_HIGH +
        (sum >= 2 ** 32 ? 1 : 0)) >>>
      0;
    low = sum >>> 0;
    return ((shifted >>> rotation) | (shifted << (-rotation & 31))) >>> 0;
  };
  return () => (next32() * 2 ** 21 + (next32() >>> 11)) / 2 ** 53;
}
