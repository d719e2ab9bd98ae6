import { Lighting } from 'three/webgpu';
import { describe, expect, test, vi } from 'vitest';
import { material, scene } from '../pathtracer/scenes.ts';
import { type FrameOptions, frameMaker, meanRadiance, type Picture } from '../realtime/effects/frames.ts';

/** Many lamps in one loop are what they are one by one. */

const size: FrameOptions = { width: 48, height: 32 };
const many = await frameMaker(size);
const single = await frameMaker(size);
single.renderer.three.lighting = new Lighting();

/** Lamps over a floor, coloured, with ranges or without. */
function lamps(count: number, range: (i: number) => number): Record<string, object> {
  const one = (i: number) => {
    const position = [
      6 * Math.cos(2.4 * i) * Math.sqrt(i / count),
      0.4 + 0.3 * (i % 4),
      6 * Math.sin(2.4 * i) * Math.sqrt(i / count),
    ];
    const common = {
      position,
      intensity: 0.6,
      color: [1, (i % 3) / 2, (i % 5) / 4],
      range: range(i),
      castShadow: false,
    };
    return i % 3 === 0
      ? {
          type: 'spot',
          ...common,
          target: [position[0]! + 0.5, 0, position[2]],
          cutoff: 20 + 10 * (i % 6),
          penumbra: 0.4,
          exponent: i % 4,
        }
      : {
          type: 'point',
          ...common,
          falloff: (['inverse-square', 'linear', 'constant'] as const)[i % 7 === 0 ? 1 : 0],
        };
  };
  return Object.fromEntries(Array.from({ length: count }, (_, i) => [`l${i}`, one(i)]));
}

const stage = (lights: object, effects: object = {}) =>
  scene({
    camera: { fov: 55, position: [0, 2.5, 6], target: [0, 0.3, 0], near: 0.05, far: 100 },
    background: { type: 'color', color: [0, 0, 0] },
    objects: {
      floor: {
        name: 'floor',
        material: 'm',
        rotation: [-90, 0, 0],
        geometry: { type: 'plane', width: 14, height: 14 },
      },
      ball: { name: 'ball', material: 'm', position: [0, 0.6, 1], geometry: { type: 'sphere', radius: 0.6 } },
    },
    materials: { m: material('cook-torrance') },
    lights,
    effects,
  });

function mostApart(a: Picture, b: Picture): number {
  const mean = b.pixels.reduce((sum, x) => sum + x, 0) / b.pixels.length;
  return a.pixels.reduce(
    (most, x, i) => Math.max(most, Math.abs(x - b.pixels[i]!) / (b.pixels[i]! + mean)),
    0,
  );
}

describe('one loop over many lamps', () => {
  test.each([
    ['without ranges', 9, () => 0],
    ['with ranges or without', 16, (i: number) => (i % 4) * 1.2],
  ] as const)('%s', async (_name, count, range) => {
    const document = stage(lamps(count, range));
    const shown = await many.draw(document);
    expect(meanRadiance(shown)[0]).toBeGreaterThan(0.01);
    expect(mostApart(shown, await single.draw(document))).toBeLessThan(1e-3);
  });
});

test('a lamp more compiles nothing and is in the next frame, though nothing else has changed', async () => {
  const { renderer } = many;
  const mirror = await many.mirror(stage(lamps(20, () => 3)));
  const { lighting } = renderer.three as unknown as {
    lighting: { getNode(scene: object): { setupLightsNode(builder: unknown): unknown } };
  };
  const draw = (count: number) => {
    const document = stage(lamps(count, () => 3));
    mirror.apply(document);
    renderer.render(mirror, document, size);
  };
  draw(20);
  const setUp = vi.spyOn(lighting.getNode(mirror.scene), 'setupLightsNode');
  draw(20);
  draw(30);
  draw(60);
  expect(setUp).not.toHaveBeenCalled();
  const shown = await renderer.readRadiance();
  mirror.dispose();
  expect(mostApart(shown, await many.draw(stage(lamps(60, () => 3))))).toBe(0);
});
