import { expect, test } from 'vitest';
import { createRandom } from '../../src/analysis/random.ts';

/** PCG32 as O'Neill defines it (2014, section 6.3, XSH RR), in integers of any length; two outputs make a number. */
function* defined(seed: number): Generator<number, never> {
  const mod64 = (x: bigint) => BigInt.asUintN(64, x);
  const step = (state: bigint) => mod64(state * 6364136223846793005n + 1442695040888963407n);
  let state = step(step(0n) + BigInt(seed));
  const output = () => {
    const word = BigInt.asUintN(32, (state ^ (state >> 18n)) >> 27n);
    const turn = state >> 59n;
    state = step(state);
    return BigInt.asUintN(32, (word >> turn) | (word << ((32n - turn) % 32n)));
  };
  for (;;) {
    const high = output() << 21n;
    yield Number(high | (output() >> 11n)) / 2 ** 53;
  }
}

test.each([0, 1, 7, -3, 2 ** 31, 2 ** 32 - 1, 123456789012345, Number.MAX_SAFE_INTEGER])(
  'seed %d gives what the definition gives',
  (seed) => {
    const [random, reference] = [createRandom(seed), defined(seed)];
    const expected = Array.from({ length: 3000 }, () => reference.next().value);
    expect(expected.map(random)).toEqual(expected);
  },
);
