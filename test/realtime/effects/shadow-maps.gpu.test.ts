import { describe, expect, test } from 'vitest';
import { MASKED_LAMPS } from '../../../src/realtime/effects/shadows/mask.ts';
import { material, scene } from '../../pathtracer/scenes.ts';
import { trace } from '../../pathtracer/tracer.ts';
import { frameMaker, shareThatDiffers } from './frames.ts';
import {
  ball,
  grey,
  HEIGHT,
  kinds,
  lights,
  materials,
  off,
  plane,
  settings,
  stage,
  WIDTH,
  white,
} from './shadow-stage.ts';

/** What maps may do wrong: acne, crawling, maps of what was, shadows where none are. */

const maker = await frameMaker({ width: WIDTH, height: HEIGHT });

describe('a surface alone does not shade itself', () => {
  const sizes = [0.01, 100];
  const alone = (object: object, light: Record<string, unknown>, size: number, effects: object) => {
    const scaled = (v: unknown) => (v as number[]).map((x) => x * size);
    return scene({
      camera: {
        fov: 40,
        position: [0, 2.4 * size, 2.4 * size],
        target: [0, 0, 0],
        near: size / 50,
        far: size * 50,
      },
      background: { type: 'color', color: [0, 0, 0] },
      objects: { object },
      materials,
      lights: {
        light: {
          ...light,
          position: scaled(light.position),
          ...('target' in light && { target: scaled(light.target) }),
          ...('radius' in light && { radius: 0 }),
          ...('angularDiameter' in light && { angularDiameter: 0 }),
          ...('falloff' in light && { falloff: 'constant' }),
          ...('width' in light && { width: size / 4, height: size / 8 }),
        },
      },
      effects,
    });
  };
  test.each(kinds)('%s', async (kind) => {
    const cases = sizes.flatMap((size) =>
      [plane(4 * size), ball(size / 2)].map((object) => ({ object, size })),
    );
    const drawn = async (effects: object) => {
      const pictures = [];
      for (const { object, size } of cases)
        pictures.push(grey(await maker.draw(alone(object, lights[kind], size, effects))));
      return pictures;
    };
    // One after the other: with shadows materials are compiled anew.
    const [plain, shadowed] = [await drawn(off), await drawn(settings)];
    for (const [at, { object, size }] of cases.entries()) {
      const brightest = Math.max(...plain[at]!);
      let darkest = 1;
      // Facets that the lamp sees edge on are dark, though interpolated normals are not.
      for (const [i, value] of plain[at]!.entries())
        if (value > 0.12 * brightest) darkest = Math.min(darkest, shadowed[at]![i]! / value);
      expect(darkest, `size ${size}, ${object.name}`).toBeGreaterThan(0.995);
    }
  });
});

describe('maps', () => {
  test('of a directional light stand still while the camera moves: shadows do not crawl', async () => {
    // From straight above the floor is moved by a pixel when the camera is, and a texel is as large as two.
    const height = 8;
    const pixel = (2 * height * Math.tan(Math.PI / 12)) / HEIGHT;
    const above = (pixels: number) =>
      scene({
        camera: {
          fov: 30,
          position: [pixels * pixel, height, 1e-3],
          target: [pixels * pixel, 0, 0],
          near: 1,
          far: 20,
        },
        objects: {
          floor: plane(40),
          ball: ball(0.6, { position: [0, 0.7, 0] }),
          far: ball(0.3, { position: [9, 0.3, 9] }),
        },
        materials,
        lights: { light: { ...lights.sun, angularDiameter: 0 } },
        // As many samples as leave no noise, which does move with the camera.
        effects: { shadows: { enabled: true, resolution: 64, samples: 128, cascades: 2 } },
      });
    const [a, b] = [grey(await maker.draw(above(0))), grey(await maker.draw(above(1)))];
    const lit = Math.max(...a);
    let [worst, edge] = [0, 0];
    for (let y = 0; y < HEIGHT; y++)
      for (let x = 1; x < WIDTH; x++) {
        worst = Math.max(worst, Math.abs(a[y * WIDTH + x]! - b[y * WIDTH + x - 1]!) / lit);
        edge = Math.max(edge, Math.abs(a[y * WIDTH + x]! - a[y * WIDTH + x - 1]!) / lit);
      }
    expect(edge).toBeGreaterThan(0.25);
    // What is left is the pattern of samples, which stays on the screen.
    expect(worst).toBeLessThan(0.1);
  });

  test('are drawn when something has moved, and then alone', async () => {
    const { renderer } = maker;
    const beside = ball(0.2, { position: [4, 3, 1] });
    const one = stage(lights.point);
    const before = scene({ ...JSON.parse(JSON.stringify(one)), objects: { ...one.objects, beside } });
    const after = scene({
      ...JSON.parse(JSON.stringify(before)),
      objects: { ...before.objects, ball: { ...before.objects.ball!, position: [0.5, 0.5, 0.2] } },
    });
    const mirror = await maker.mirror(before);
    const size = { width: WIDTH, height: HEIGHT };
    const draws = (document: typeof before) => {
      mirror.apply(document);
      renderer.render(mirror, document, size);
      return renderer.three.info.render.drawCalls;
    };
    const [first, still] = [draws(before), draws(before)];
    expect(first).toBeGreaterThan(still);
    const changed = draws(after);
    // The face of the cube that shows the other ball alone is as it was.
    expect(changed).toBeGreaterThan(still);
    expect(changed).toBeLessThan(first);
    const moved = await renderer.readRadiance();
    mirror.dispose();
    expect(moved.pixels).toEqual((await maker.draw(after)).pixels);
  });
});

test('another effect beside them is switched on and off, and shadows stay as they are', async () => {
  const before = stage(lights.spot);
  const occluded = {
    ...before,
    effects: { ...before.effects, ambientOcclusion: { ...before.effects.ambientOcclusion, enabled: true } },
  };
  const mirror = await maker.mirror(before);
  const pictures = [];
  for (const document of [before, occluded, before]) {
    mirror.apply(document);
    maker.renderer.render(mirror, document, { width: WIDTH, height: HEIGHT });
    pictures.push((await maker.renderer.readRadiance()).pixels);
  }
  mirror.dispose();
  // Only lamps light the stage.
  expect(pictures[1]).toEqual(pictures[0]);
  expect(pictures[2]).toEqual(pictures[0]);
});

test('a lamp inside a body lights nothing outside', async () => {
  const inside = await maker.draw(stage({ ...lights.point, position: [0, 0.7, 0], radius: 0 }));
  expect(Math.max(...grey(inside))).toBe(0);
});

test('of lamps that are too many for the mask, materials find the shadows themselves: the same ones', async () => {
  const dark = { ...lights.spot, intensity: 0 };
  const others = Object.fromEntries(Array.from({ length: MASKED_LAMPS }, (_, i) => [`dark${i}`, dark]));
  const withLamps = (lamps: object) => ({
    ...stage(lights.spot),
    lights: scene({ lights: lamps }).lights,
  });
  const masked = await maker.draw(withLamps({ lamp: lights.spot, ...others }));
  const beyond = await maker.draw(withLamps({ ...others, lamp: lights.spot }));
  // Along edges: a point of the mask is lifted a little, and a pixel may have its neighbour’s number.
  expect(shareThatDiffers(masked, beyond, 0.01)).toBeLessThan(0.02);
});

test('switched off, or of lights that cast none, shadows change no bit', async () => {
  const plain = await maker.draw(stage(lights.spot, off));
  const dark = await maker.draw(stage(lights.spot));
  expect(dark.pixels).not.toEqual(plain.pixels);
  const { pixels } = await maker.draw(stage({ ...lights.spot, castShadow: false }));
  expect(pixels).toEqual(plain.pixels);
  const film = await trace(stage({ ...lights.spot, castShadow: false }), {
    samples: 8,
    width: WIDTH,
    height: HEIGHT,
    maxDepth: 1,
  });
  const sum = (values: ArrayLike<number>) => Array.from(values).reduce((a, b) => a + b, 0);
  expect(sum(film.mean()) / sum(pixels.filter((_, i) => i % 4 < 3))).toBeCloseTo(1, 1);
});

test('what is seen through a hole has shadows of its own', async () => {
  const document = stage(lights.sun);
  const through = scene({
    ...document,
    materials: {
      ...materials,
      hole: material('lambert', white, { alphaMode: 'mask', alphaCutoff: 0.6, opacity: 0.5 }),
    },
    objects: {
      ...document.objects,
      hole: { ...plane(1.5, { position: [0, 1.8, 1.2], rotation: [0, 0, 0] }), material: 'hole' },
    },
  });
  const [a, b] = [await maker.draw(through), await maker.draw(document)];
  expect(shareThatDiffers(a, b)).toBeLessThan(0.001);
});

test('what is cut out casts no shadow, and what is blended a part of it', async () => {
  const sheet = (more: object) =>
    scene({
      camera: { fov: 20, position: [0, 2, 4], target: [0, 0, 0] },
      background: { type: 'color', color: [0, 0, 0] },
      objects: {
        floor: plane(6),
        sheet: { ...plane(1.5, { position: [0, 3, 0] }), material: 'sheet' },
      },
      materials: { ...materials, sheet: material('lambert', white, { doubleSided: true, ...more }) },
      lights: { light: { ...lights.sun, position: [0, 4, 0], angularDiameter: 0 } },
      effects: settings,
    });
  const centre = async (more: object) => {
    const picture = grey(await maker.draw(sheet(more)));
    let sum = 0;
    for (let y = -3; y < 3; y++) for (let x = -3; x < 3; x++) sum += picture[(20 + y) * WIDTH + 30 + x]! / 36;
    return sum;
  };
  const lit = await centre({ alphaMode: 'mask', alphaCutoff: 0.6, opacity: 0.5 });
  expect(lit).toBeGreaterThan(0.5);
  expect(await centre({ alphaMode: 'mask', alphaCutoff: 0.4, opacity: 0.5 })).toBe(0);
  expect(await centre({ alphaMode: 'opaque' })).toBe(0);
  expect((await centre({ alphaMode: 'blend', opacity: 0.25 })) / lit).toBeCloseTo(0.75, 1);
});
