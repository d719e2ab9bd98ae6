import { describe, expect, test } from 'vitest';
import { scene } from '../../pathtracer/scenes.ts';
import { trace } from '../../pathtracer/tracer.ts';
import { frameMaker } from './frames.ts';
import { grey, HEIGHT, kinds, lights, materials, plane, settings, stage, WIDTH } from './shadow-stage.ts';

/** Shadows against the path tracer, which means the same by a lamp's size (docs/decisions/light-sizes.md). */

const maker = await frameMaker({ width: WIDTH, height: HEIGHT });

/** Means over 3 x 3 pixels: of what the two do not have in common, noise is most. */
function smooth(values: ArrayLike<number>): Float64Array {
  return Float64Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
    const [x, y] = [i % WIDTH, Math.floor(i / WIDTH)];
    let [sum, count] = [0, 0];
    for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, HEIGHT - 1); v++)
      for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, WIDTH - 1); u++) {
        sum += values[v * WIDTH + u]!;
        count++;
      }
    return sum / count;
  });
}

async function supersampled(document: ReturnType<typeof stage>): Promise<Float64Array> {
  const scale = 2;
  const { pixels } = await maker.draw({ ...document, view: { ...document.view, resolutionScale: scale } });
  return Float64Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
    let sum = 0;
    for (let k = 0; k < scale * scale; k++) {
      const [x, y] = [
        (i % WIDTH) * scale + (k % scale),
        Math.floor(i / WIDTH) * scale + Math.floor(k / scale),
      ];
      sum += pixels[4 * (y * WIDTH * scale + x)]!;
    }
    return sum / scale / scale;
  });
}

describe('soft shadows are those of the path tracer', () => {
  test.each(kinds)('%s', async (kind) => {
    const document = stage(lights[kind]);
    const shown = await supersampled(document);
    const film = await trace(document, { samples: 96, width: WIDTH, height: HEIGHT, maxDepth: 1 });
    const traced = Float64Array.from({ length: WIDTH * HEIGHT }, (_, i) => film.mean()[3 * i]!);
    const [a, b] = [smooth(shown), smooth(traced)];
    const brightest = Math.max(...b);
    let [error, bias, sum, worst] = [0, 0, 0, 0];
    for (let i = 0; i < a.length; i++) {
      error += Math.abs(a[i]! - b[i]!);
      bias += a[i]! - b[i]!;
      sum += b[i]!;
      worst = Math.max(worst, Math.abs(a[i]! - b[i]!) / brightest);
    }
    expect(error / sum).toBeLessThan(0.02);
    expect(Math.abs(bias) / sum).toBeLessThan(0.005);
    // Nowhere in the penumbra is it far off.
    expect(worst).toBeLessThan(0.12);
  });
});

describe('a box on the floor', () => {
  /** Hard light, so that the path traced picture is either lit or dark. */
  const document = (light: object) =>
    scene({
      camera: { fov: 30, position: [-1.5, 1.6, 0.8], target: [-0.3, 0.1, 0], near: 0.1 },
      background: { type: 'color', color: [0, 0, 0] },
      objects: {
        floor: plane(40),
        box: {
          name: 'box',
          material: 'm',
          position: [0, 0.25, 0],
          geometry: { type: 'box', width: 0.5, height: 0.5, depth: 0.5 },
        },
      },
      materials,
      lights: { light },
      effects: settings,
    });
  test.each([
    ['sun', { ...lights.sun, angularDiameter: 0 }],
    ['point', { ...lights.point, radius: 0 }],
  ])('is not parted from its shadow: %s', async (_, light) => {
    const shown = grey(await maker.draw(document(light)));
    const film = await trace(document(light), { samples: 16, width: WIDTH, height: HEIGHT, maxDepth: 1 });
    const traced = Float64Array.from({ length: WIDTH * HEIGHT }, (_, i) => film.mean()[3 * i]!);
    const isDark = (i: number) => traced[i]! === 0;
    let [dark, leaks] = [0, 0];
    for (let y = 1; y < HEIGHT - 1; y++)
      for (let x = 1; x < WIDTH - 1; x++) {
        const i = y * WIDTH + x;
        // A pixel that the box and the floor share is neither.
        if (![i, i - 1, i + 1, i - WIDTH, i + WIDTH].every(isDark)) continue;
        dark++;
        if (shown[i]! > 0.05) leaks++;
      }
    expect(dark).toBeGreaterThan(100);
    expect(leaks).toBe(0);
  });
});
