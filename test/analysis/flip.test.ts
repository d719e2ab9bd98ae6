import { describe, expect, it } from 'vitest';
import { featureFilters, sensitivityFilters } from '../../src/analysis/flip/filters.ts';
import { flip, PIXELS_PER_DEGREE, type ScreenImage } from '../../src/analysis/flip/flip.ts';
import { magma } from '../../src/analysis/flip/magma.ts';

type Rgb = readonly [number, number, number];

function image(width: number, height: number, at: (x: number, y: number) => Rgb): ScreenImage {
  const pixels = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; i++) pixels.set([...at(i % width, Math.floor(i / width)), 255], 4 * i);
  return { width, height, pixels };
}

const plain = (color: Rgb) => image(24, 16, () => color);

/** The same numbers in every run. */
function noise(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

describe('flip', () => {
  it('is 0 for equal pictures', () => {
    const random = noise(1);
    const picture = image(31, 20, () => [255 * random(), 255 * random(), 255 * random()]);
    expect(flip(picture, picture).mean).toBe(0);
  });

  it('is 1 for green against blue, the largest difference', () => {
    const { values, mean } = flip(plain([0, 255, 0]), plain([0, 0, 255]));
    expect(mean).toBeCloseTo(1, 5);
    expect(Math.min(...values)).toBeCloseTo(1, 5);
  });

  // By hand from the paper's equations: black to white is 100 in L*, green to blue 203.3 in HyAB with the Hunt effect.
  it('is 0.967 for black against white', () => {
    const largest = 203.3 ** 0.7;
    const expected = 0.95 + ((100 ** 0.7 - 0.4 * largest) / (0.6 * largest)) * 0.05;
    expect(flip(plain([0, 0, 0]), plain([255, 255, 255])).mean).toBeCloseTo(expected, 3);
    expect(expected).toBeCloseTo(0.967, 3);
  });

  it('is symmetric, between 0 and 1, and grows with the difference', () => {
    const random = noise(2);
    const grey = image(40, 30, () => [128, 128, 128]);
    const noisy = (amount: number) =>
      image(40, 30, () => {
        const value = 128 + amount * (random() - 0.5);
        return [value, value, value];
      });
    const means = [10, 40, 120, 250].map((amount) => {
      const other = noisy(amount);
      const there = flip(grey, other);
      const back = flip(other, grey);
      expect(back.mean).toBeCloseTo(there.mean, 6);
      expect(Math.min(...there.values)).toBeGreaterThanOrEqual(0);
      expect(Math.max(...there.values)).toBeLessThanOrEqual(1);
      return there.mean;
    });
    expect(means).toEqual([...means].sort((a, b) => a - b));
  });

  it('forgives what an eye cannot resolve, and the more so the farther it is', () => {
    const checker = image(48, 48, (x, y) => ((x + y) % 2 ? [150, 150, 150] : [106, 106, 106]));
    const inverted = image(48, 48, (x, y) => ((x + y) % 2 ? [106, 106, 106] : [150, 150, 150]));
    const [near, far] = [
      flip(checker, inverted, 10).mean,
      flip(checker, inverted, 2 * PIXELS_PER_DEGREE).mean,
    ];
    expect(far).toBeLessThan(0.02);
    expect(near).toBeGreaterThan(0.2);
  });

  it('weighs a lone bright pixel more than its smoothed colour alone', () => {
    const grey = image(41, 41, () => [110, 110, 110]);
    const speck = image(41, 41, (x, y) => (x === 20 && y === 20 ? [255, 255, 255] : [110, 110, 110]));
    const blurred = flip(grey, speck).values[20 * 41 + 20]!;
    const flat = flip(plain([110, 110, 110]), plain([116, 116, 116])).values[0]!;
    expect(blurred).toBeGreaterThan(2 * flat);
  });

  it('is the same turned by a quarter, and refuses pictures of different size', () => {
    const random = noise(3);
    const colors = Array.from(
      { length: 20 * 20 },
      (): Rgb => [255 * random(), 255 * random(), 255 * random()],
    );
    const other = Array.from(
      { length: 20 * 20 },
      (): Rgb => [255 * random(), 255 * random(), 255 * random()],
    );
    const upright = flip(
      image(20, 20, (x, y) => colors[20 * y + x]!),
      image(20, 20, (x, y) => other[20 * y + x]!),
    );
    const turned = flip(
      image(20, 20, (x, y) => colors[20 * x + y]!),
      image(20, 20, (x, y) => other[20 * x + y]!),
    );
    expect(turned.mean).toBeCloseTo(upright.mean, 6);
    expect(() =>
      flip(
        plain([0, 0, 0]),
        image(3, 3, () => [0, 0, 0]),
      ),
    ).toThrow('cannot be compared');
  });
});

describe('its filters', () => {
  const total = (kernel: Float32Array) => kernel.reduce((sum, weight) => sum + weight, 0);

  it('leave an even picture as it is', () => {
    for (const terms of sensitivityFilters(PIXELS_PER_DEGREE)) {
      expect(terms.reduce((sum, { weight, kernel }) => sum + weight * total(kernel) ** 2, 0)).toBeCloseTo(
        1,
        5,
      );
    }
    const { gaussian, edge, point } = featureFilters(PIXELS_PER_DEGREE);
    expect(total(gaussian)).toBeCloseTo(1, 5);
    expect(total(edge)).toBeCloseTo(0, 5);
    expect(total(point)).toBeCloseTo(0, 5);
  });

  // The sum of two Gaussians in x and y is no product; a filter in two dimensions, as the paper writes it, is.
  it('equal the two-dimensional filter of the paper for yellow against blue', () => {
    const ppd = PIXELS_PER_DEGREE;
    const [, , terms] = sensitivityFilters(ppd);
    const radius = (terms![0]!.kernel.length - 1) / 2;
    expect(radius).toBe(10);
    const direct = (x: number, y: number) =>
      [
        [34.1, 0.04],
        [13.5, 0.025],
      ].reduce(
        (sum, [a, b]) =>
          sum + a! * Math.sqrt(Math.PI / b!) * Math.exp((-(Math.PI ** 2) * (x * x + y * y)) / ppd ** 2 / b!),
        0,
      );
    let all = 0;
    for (let y = -radius; y <= radius; y++) for (let x = -radius; x <= radius; x++) all += direct(x, y);
    for (const [x, y] of [
      [0, 0],
      [3, -2],
      [10, 10],
    ] as const) {
      const separable = terms!.reduce(
        (sum, { weight, kernel }) => sum + weight * kernel[x + radius]! * kernel[y + radius]!,
        0,
      );
      expect(separable).toBeCloseTo(direct(x, y) / all, 7);
    }
  });
});

describe('magma', () => {
  it('goes from black to pale yellow, ever lighter', () => {
    expect(magma(0)).toEqual([0, 0, 4]);
    expect(magma(1)).toEqual([252, 253, 191]);
    expect(magma(7)).toEqual(magma(1));
    const light = Array.from({ length: 65 }, (_, i) => {
      const [r, g, b] = magma(i / 64);
      return 0.2126 * r ** 2.2 + 0.7152 * g ** 2.2 + 0.0722 * b ** 2.2;
    });
    expect(light).toEqual([...light].sort((a, b) => a - b));
  });
});
