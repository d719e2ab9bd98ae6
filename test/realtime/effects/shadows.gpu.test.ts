import { describe, expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { trace } from '../../pathtracer/tracer.ts';
import { frameMaker, type Picture } from './frames.ts';

/** Shadows against the path tracer, which means the same by a lamp's size (docs/decisions/light-sizes.md). */

const [WIDTH, HEIGHT] = [60, 40];
const maker = await frameMaker({ width: WIDTH, height: HEIGHT });

const settings = { shadows: { enabled: true, resolution: 256, samples: 32 } };
const off = { shadows: { enabled: false } };

const lights = {
  sun: { type: 'directional', illuminance: 3, position: [2, 4, 2], angularDiameter: 6 },
  point: { type: 'point', intensity: 30, position: [1.2, 3, 1], radius: 0.2 },
  spot: {
    type: 'spot',
    intensity: 40,
    position: [-1.5, 3, 1],
    target: [0, 0.3, 0],
    cutoff: 35,
    radius: 0.15,
  },
  'wide spot': {
    type: 'spot',
    intensity: 15,
    position: [-0.8, 1.8, 0.6],
    target: [0, 0, 0],
    cutoff: 85,
    radius: 0.06,
  },
  rectangle: {
    type: 'rectangle',
    luminance: 12,
    position: [1, 2.6, 1.5],
    target: [0, 0.3, 0],
    width: 1,
    height: 0.6,
  },
} as const;
const kinds = Object.keys(lights) as (keyof typeof lights)[];

const plane = (size: number, more: object = {}) => ({
  name: 'floor',
  material: 'floor',
  rotation: [-90, 0, 0],
  geometry: { type: 'plane', width: size, height: size },
  ...more,
});
const ball = (radius: number, more: object = {}) => ({
  name: 'ball',
  material: 'm',
  geometry: { type: 'sphere', radius, widthSegments: 192, heightSegments: 96 },
  ...more,
});
const white = { albedo: [0.8, 0.8, 0.8] };
const materials = {
  m: material('lambert', white),
  // Seen from both sides: it is drawn into the maps, too.
  floor: material('lambert', white, { doubleSided: true }),
};

/** A ball above a floor. */
const stage = (light: object, effects: object = settings) =>
  scene({
    camera: { fov: 40, position: [0, 3, 3], target: [0, 0.2, 0] },
    background: { type: 'color', color: [0, 0, 0] },
    objects: { floor: plane(40), ball: ball(0.4, { position: [0, 0.7, 0] }) },
    materials,
    lights: { light },
    effects,
  });

/** Luminance is the same in all channels here. */
const grey = ({ pixels }: Picture) =>
  Float64Array.from({ length: pixels.length / 4 }, (_, i) => pixels[4 * i]!);

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
  const scale = 3;
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

describe('a surface alone does not shade itself', () => {
  const sizes = [0.01, 1, 100];
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
    for (const size of sizes) {
      for (const object of [plane(4 * size), ball(size / 2)]) {
        const plain = grey(await maker.draw(alone(object, lights[kind], size, off)));
        const shadowed = grey(await maker.draw(alone(object, lights[kind], size, settings)));
        const brightest = Math.max(...plain);
        let darkest = 1;
        // Facets that the lamp sees edge on are dark, though interpolated normals are not.
        for (const [i, value] of plain.entries())
          if (value > 0.12 * brightest) darkest = Math.min(darkest, shadowed[i]! / value);
        expect(darkest, `size ${size}, ${(object as { name: string }).name}`).toBeGreaterThan(0.995);
      }
    }
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
    const before = stage(lights.point);
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
    expect(draws(after)).toBe(first);
    const moved = await renderer.readRadiance();
    mirror.dispose();
    expect(moved.pixels).toEqual((await maker.draw(after)).pixels);
  });
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
