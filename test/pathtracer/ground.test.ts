import { expect, it } from 'vitest';
import { denoise } from '../../src/pathtracer/denoise/denoise.ts';
import { denoiseAlpha } from '../../src/pathtracer/denoise/denoise-alpha.ts';
import { levelRadiance } from '../../src/scene/level-irradiance.ts';
import type { Document } from '../../src/scene/schema.ts';
import { evenLight, material, meanOf, scene } from './scenes.ts';
import { trace } from './tracer.ts';

/** The ground that shows shadows, against closed forms. */

const SIZE = 33;
const HEIGHT = 20;
/** Half of what the picture shows of the ground, in metres. */
const REACH = 4;
const RADIUS = 1;

/** Looks straight down from high above; the ball stands on the ground. */
function stage(parts: Record<string, unknown>, ground: Record<string, unknown> = {}): Document {
  return scene({
    camera: {
      fov: (2 * Math.atan(REACH / HEIGHT) * 180) / Math.PI,
      // Not from exactly above: up would have no direction.
      position: [0, HEIGHT + 0.5, 1e-4],
      target: [0, 0.5, 0],
      fStop: 0,
    },
    ground: { shadowCatcher: true, ...ground },
    objects: {
      ball: {
        name: 'ball',
        material: 'm',
        position: [0, RADIUS + 0.5, 0],
        geometry: { type: 'sphere', radius: RADIUS, widthSegments: 128, heightSegments: 96 },
      },
    },
    materials: { m: material('lambert', { albedo: [0, 0, 0] }) },
    background: { type: 'color', color: [1, 1, 1] },
    ...parts,
  });
}

/** Of every pixel whose middle is on the ground beside the ball as it is seen. */
function places(): { pixel: number; x: number; z: number; rho: number }[] {
  const found = [];
  for (let pixel = 0; pixel < SIZE * SIZE; pixel++) {
    const at = (i: number) => ((2 * (i + 0.5)) / SIZE - 1) * REACH;
    const [x, z] = [at(pixel % SIZE), at(Math.floor(pixel / SIZE))];
    const rho = Math.hypot(x, z);
    if (rho > 1.3 * RADIUS) found.push({ pixel, x, z, rho });
  }
  return found;
}

const render = (document: Document, samples: number) =>
  trace(document, { samples, width: SIZE, height: SIZE, maxDepth: 1 });

/** What a ball that touches the ground keeps off it of even light: r^2 c / D^3, c = r the height of its middle. */
const kept = (rho: number) => RADIUS ** 3 / (rho * rho + RADIUS * RADIUS) ** 1.5;

it('a ball under an even sky darkens the ground as its form factor says; the ground is where it stands', async () => {
  const film = await render(stage(evenLight), 256);
  const mean = film.mean();
  let [error, sum] = [0, 0];
  for (const { pixel, rho } of places()) {
    const difference = mean[3 * pixel]! - (1 - kept(rho));
    expect(Math.abs(difference)).toBeLessThan(0.03);
    error += difference;
    sum += kept(rho);
  }
  // As a part of the light that is kept off: without a bias.
  expect(Math.abs(error / sum)).toBeLessThan(0.004);
});

it('the shadow of a lamp without size is all or nothing, within its ellipse', async () => {
  const lamp = [3, 6.5, 1];
  const lights = { lamp: { type: 'point', intensity: 5, radius: 0, position: lamp } };
  const { ball } = stage({}).objects;
  // Behind the lamp, where the camera does not look: keeps nothing off.
  const behind = { ...ball, position: lamp.map((x) => 2.2 * x), scale: [3, 3, 3] };
  const film = await render(stage({ lights, objects: { ball, behind } }), 4);
  const mean = film.mean();
  const toBall = [-lamp[0]!, RADIUS + 0.5 - lamp[1]!, -lamp[2]!];
  const distance = Math.hypot(...toBall);
  let dark = 0;
  for (const { pixel, x, z } of places()) {
    const way = [x - lamp[0]!, 0.5 - lamp[1]!, z - lamp[2]!];
    const cosine = way.reduce((total, w, i) => total + w * toBall[i]!, 0) / (Math.hypot(...way) * distance);
    // By how much the place is outside the cone of tangents, in radians.
    const outside = Math.acos(Math.min(1, cosine)) - Math.asin(RADIUS / distance);
    if (Math.abs(outside) < 0.03) continue;
    expect(mean[3 * pixel]).toBe(outside > 0 ? 1 : 0);
    if (outside < 0) dark += 1;
  }
  expect(dark).toBeGreaterThan(10);
});

it('lamps and sky share the ratio by their light, by channel; what casts no shadow fills', async () => {
  // Half of the light each, on level ground; the ball would keep off some of the second.
  const fill = (x: number) => ({
    type: 'directional',
    illuminance: (Math.PI / 2) * Math.hypot(x, 1),
    position: [9 * x, 9, 0],
    castShadow: false,
    color: [1, 0.5, 0],
  });
  const lights = { above: fill(0), beside: fill(0.8) };
  const mean = (await render(stage({ ...evenLight, lights }), 256)).mean();
  const sky = [1 / 2, 1 / 1.5, 1];
  const [errors, sums] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (const { pixel, rho } of places())
    for (const [c, share] of sky.entries()) {
      errors[c]! += mean[3 * pixel + c]! - (1 - share * kept(rho));
      sums[c]! += share * kept(rho);
    }
  // As a part of the light that is kept off.
  for (const [c, error] of errors.entries()) expect(Math.abs(error / sums[c]!)).toBeLessThan(0.008);
});

it('a rectangle has all of its light on open ground, also where it reaches below it', async () => {
  const lights = {
    panel: {
      type: 'rectangle',
      luminance: 3,
      width: 3,
      height: 4,
      position: [-5, 1.2, 0],
      target: [0, 1, 0],
    },
  };
  const film = await render(stage({ lights }), 64);
  const mean = film.mean();
  const lit = places().filter(({ x, z }) => x < 0 && Math.abs(z) < 3);
  for (const { pixel } of lit) expect(mean[3 * pixel]).toBe(1);
  // Right behind the ball nothing of it is seen.
  const behind = places().filter(({ x, z, rho }) => rho < 1.6 && x > 1 && Math.abs(z) < 0.2);
  expect(behind.length).toBeGreaterThan(0);
  for (const { pixel } of behind) expect(mean[3 * pixel]).toBeLessThan(0.1);
});

it('in a closed room nothing is left: what is drawn of each light is what its closed form says', async () => {
  const room = {
    name: 'room',
    material: 'm',
    geometry: { type: 'box', width: 20, height: 20, depth: 20 },
  };
  const box = {
    azimuth: 70,
    elevation: 30,
    width: 60,
    height: 30,
    roll: 20,
    luminance: 9,
    color: [1, 0.4, 0.2],
  };
  const outside = {
    // Partly below the ground.
    panel: {
      type: 'rectangle',
      luminance: 4,
      width: 12,
      height: 9,
      position: [-15, 2, 3],
      target: [0, 1, 0],
    },
    sky: { type: 'hemisphere', luminance: 0.2, color: [0.3, 0.6, 1], groundColor: [1, 0, 0] },
  };
  for (const [name, lights] of Object.entries({
    panel: { panel: outside.panel },
    sky: { sky: outside.sky },
  })) {
    const film = await render(
      stage(
        {
          lights,
          objects: { room },
          materials: { m: { ...material('lambert'), doubleSided: true } },
          camera: { fov: 60, position: [0, 6, 1e-4], target: [0, 0, 0], fStop: 0 },
          ...(name === 'sky' && { environment: { source: { type: 'studio', dome: 0.1, boxes: [box] } } }),
        },
        { height: 0 },
      ),
      64,
    );
    for (const c of [0, 1, 2]) {
      const left = film.radiance.reduce((sum, x, i) => sum + (i % 3 === c ? x : 0), 0) / (64 * SIZE * SIZE);
      expect(Math.abs(left)).toBeLessThan(0.005);
    }
  }
});

it('strength, rim and a transparent background', async () => {
  const even = { ...evenLight, background: { type: 'transparent' } };
  const film = await render(stage(even, { strength: 0.5, radius: 3, fade: 0.5 }), 256);
  expect(meanOf(film.mean())).toEqual([0, 0, 0]);
  const alpha = film.meanAlpha();
  let [error, sum] = [0, 0];
  for (const { pixel, rho } of places()) {
    const t = Math.min(1, Math.max(0, (rho - 1.5) / 1.5));
    const rim = 1 - t * t * (3 - 2 * t);
    const difference = alpha[pixel]! - 0.5 * rim * kept(rho);
    expect(Math.abs(difference)).toBeLessThan(0.02);
    error += difference;
    sum += 0.5 * rim * kept(rho);
    if (rho > 3.2) expect(alpha[pixel]).toBe(0);
  }
  expect(Math.abs(error / sum)).toBeLessThan(0.01);
  expect(alpha[(SIZE * SIZE - 1) / 2]).toBe(1);
  // Adaptive sampling sees the noise that is in alpha alone.
  expect(film.shadowVariance(places().find(({ rho }) => rho < 1.5)!.pixel)).toBeGreaterThan(0);
});

it('the denoiser takes noise out of the alpha of shadows, and of their light before a colour', async () => {
  const errorOf = (value: (pixel: number) => number) =>
    Math.sqrt(places().reduce((sum, { pixel, rho }) => sum + (value(pixel) - kept(rho)) ** 2, 0));
  const clear = await render(stage({ ...evenLight, background: { type: 'transparent' } }), 16);
  const [noisy, alpha] = [clear.meanAlpha(), (await denoiseAlpha(clear))!];
  expect(errorOf((pixel) => alpha[pixel]!)).toBeLessThan(0.5 * errorOf((pixel) => noisy[pixel]!));
  const even = await render(stage(evenLight), 16);
  expect(await denoiseAlpha(even)).toBeNull();
  const [before, after] = [even.mean(), await denoise(even)];
  expect(errorOf((pixel) => 1 - after[3 * pixel]!)).toBeLessThan(
    0.5 * errorOf((pixel) => 1 - before[3 * pixel]!),
  );
});

it('the ground hides what is below it, but no floor that lies in it', async () => {
  const floor = {
    name: 'floor',
    material: 'm',
    position: [0, 0.5, 0],
    rotation: [-90, 0, 0],
    geometry: { type: 'plane', width: 4, height: 20 },
  };
  const document = stage(evenLight, { height: 0.5 });
  const mean = (
    await render(
      {
        ...document,
        objects: {
          ...document.objects,
          floor: { ...document.objects.ball!, ...floor } as (typeof document.objects)[string],
          below: { ...document.objects.ball!, position: [0, -3, 0] },
        },
      },
      16,
    )
  ).mean();
  for (const { pixel, x } of places()) {
    if (Math.abs(x) < 1.8) expect(mean[3 * pixel]).toBe(0);
    if (Math.abs(x) > 2.2) expect(mean[3 * pixel]).toBeGreaterThan(0.8);
  }
});

it('the light of an image on level ground is its integral', () => {
  // Radiance y above the horizon: the integral of cos^2 over the hemisphere, 2 pi / 3.
  const height = 64;
  const texels = new Float32Array(4 * 2 * height);
  for (let i = 0; i < texels.length / 4; i++)
    texels.fill(
      Math.max(0, Math.sin(Math.PI * ((Math.floor(i / 2) + 0.5) / height - 0.5))),
      4 * i,
      4 * i + 4,
    );
  for (const value of levelRadiance({ texels, width: 2, height }, false)) expect(value).toBeCloseTo(2 / 3, 3);
});
