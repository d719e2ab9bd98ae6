/**
 * A stream of numbers in [0, 1), the same for the same seed on every machine.
 *
 * PCG32 (M. E. O'Neill, 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms
 * for Random Number Generation"), the variant XSH-RR with 64 bits of state; two outputs make the 53 bits
 * of a number, so that samplers see the tails that 32 bits cannot express.
 */
export function createRandom(seed: number): () => number {
  const mask = 0xffffffffffffffffn;
  const increment = 1442695040888963407n;
  const step = (state: bigint) => (state * 6364136223846793005n + increment) & mask;
  let state = step(step(0n) + (BigInt(seed) & mask));

  const next32 = (): number => {
    const shifted = Number((((state >> 18n) ^ state) >> 27n) & 0xffffffffn);
    const rotation = Number(state >> 59n);
    state = step(state);
    return ((shifted >>> rotation) | (shifted << (-rotation & 31))) >>> 0;
  };
  return () => (next32() * 2 ** 21 + (next32() >>> 11)) / 2 ** 53;
}
