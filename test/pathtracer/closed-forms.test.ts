import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { spotFactor } from '../../src/lights/spot-light.ts';
import { evenLight, material, meanOf, narrowCamera, scene, wall } from './scenes.ts';
import { trace } from './tracer.ts';

/** Renderings against what is known without rendering. */

describe('in an even light', () => {
  const surfaces: readonly (readonly [model: string, parameters: Record<string, unknown>])[] = [
    ['lambert', {}],
    ['cook-torrance', { kd: 0.3, roughness: 0.4 }],
    ['principled', { roughness: 0.4, clearcoat: 1, sheen: 0.5 }],
    ['principled', { metallic: 1, roughness: 0.3, anisotropic: 0.7 }],
    ['principled-thesis', { roughness: 0.6, subsurface: 0.5 }],
    ['principled-bsdf', { roughness: 0.5, metallic: 0.5 }],
  ];
  it.each(surfaces)('%s %j reflects its directional albedo within 0.5 per cent', async (name, parameters) => {
    const model = shippedModels.get(name) as Model;
    for (const cosine of [0.9, 0.35]) {
      const document = scene({
        ...evenLight,
        camera: narrowCamera(cosine),
        objects: { wall: wall() },
        materials: { m: material(name, parameters) },
      });
      const film = await trace(document, { samples: 128, maxDepth: 1, width: 24, height: 24 });
      // The wall's tangent is +x.
      const v: Vector3 = [Math.sqrt(1 - cosine * cosine), 0, cosine];
      const evaluator = createEvaluator(model, parameters);
      const { value } = directionalAlbedo((l) => evaluator.f(l, v), v, { tolerance: 1e-3 });
      for (const [c, traced] of meanOf(film.mean()).entries())
        expect(Math.abs(traced - value[c]!)).toBeLessThan(0.005 * Math.max(...value));
    }
  });

  it('a sphere of Lambert shows its albedo everywhere, whatever the depth', async () => {
    const document = scene({
      ...evenLight,
      camera: { fov: 20, position: [0, 0, 10], target: [0, 0, 0] },
      objects: { s: { name: 's', material: 'm', geometry: { type: 'sphere', radius: 3 } } },
      materials: { m: material('lambert', { albedo: [0.6, 0.5, 0.4] }) },
    });
    const film = await trace(document, { samples: 64, maxDepth: 8, width: 12, height: 12 });
    const albedo = [0.6, 0.5, 0.4];
    for (const [c, traced] of meanOf(film.mean()).entries()) expect(traced).toBeCloseTo(albedo[c]!, 2);
  });

  it.each([
    ['glass', material('dielectric', { roughness: 0 })],
    ['milk', material('dielectric', { ...milk(), roughness: 0 })],
    [
      'a sheet of glass',
      material('principled-bsdf', { thin: true, specTrans: 1, roughness: 0, baseColor: [1, 1, 1] }),
    ],
  ])('a body of %s in glass in water cannot be seen: all light comes back', async (_name, inner) => {
    const ball = (radius: number, m: string) => ({
      name: m,
      material: m,
      geometry: { type: 'sphere', radius },
    });
    const document = scene({
      ...evenLight,
      camera: { fov: 40, position: [0, 0, 4], target: [0, 0, 0] },
      objects: { a: ball(1, 'water'), b: ball(0.7, 'glass'), c: ball(0.4, 'inner') },
      materials: {
        water: material('dielectric', { ior: 1.33, roughness: 0 }),
        glass: material('dielectric', { ior: 1.6, roughness: 0 }),
        inner,
      },
    });
    const film = await trace(document, { samples: 64, maxDepth: 64, width: 16, height: 16 });
    for (const traced of meanOf(film.mean())) expect(Math.abs(traced - 1)).toBeLessThan(0.01);
  });

  function milk() {
    const scatter = -Math.log(0.1);
    // As much is scattered as is lost on the way: no absorption.
    return {
      transmissionColor: [0.1, 0.1, 0.1],
      transmissionDepth: 0.3,
      scatter: [scatter, scatter, scatter],
    };
  }
});

it('a body that absorbs follows Beer and Lambert', async () => {
  // Through 2 m of it, with an index of 1: half is left of each metre.
  const document = scene({
    ...evenLight,
    camera: { fov: 0.5 * 2, position: [0, 0, 40], target: [0, 0, 0] },
    objects: {
      box: { name: 'box', material: 'm', geometry: { type: 'box', width: 4, height: 4, depth: 2 } },
    },
    materials: {
      m: material('dielectric', {
        ior: 1,
        roughness: 0,
        transmissionColor: [0.5, 0.25, 1],
        transmissionDepth: 1,
      }),
    },
  });
  const film = await trace(document, { samples: 64, maxDepth: 8 });
  const [r, g, b] = meanOf(film.mean());
  expect(r).toBeCloseTo(0.25, 2);
  expect(g).toBeCloseTo(0.0625, 2);
  expect(b).toBeCloseTo(1, 2);
});

describe('direct light equals the shading equation', () => {
  const lights: Record<string, object> = {
    directional: { type: 'directional', illuminance: 3, position: [1, 2, 3], color: [1, 0.5, 0.2] },
    point: { type: 'point', intensity: 20, position: [1, 2, 3] },
    'point with linear falloff and range': {
      type: 'point',
      intensity: 20,
      position: [1, 2, 3],
      falloff: 'linear',
      range: 6,
    },
    spot: {
      type: 'spot',
      intensity: 30,
      position: [1, 2, 3],
      target: [0.2, 0.1, 0],
      cutoff: 20,
      exponent: 5,
      penumbra: 0.9,
    },
  };
  // E(p) l for a wall at the origin, written from THESIS.md.
  const r = Math.hypot(1, 2, 3);
  const l: Vector3 = [1 / r, 2 / r, 3 / r];
  const irradiance: Record<string, readonly number[]> = {
    directional: [3, 1.5, 0.6],
    point: [20 / r ** 2, 20 / r ** 2, 20 / r ** 2],
    'point with linear falloff and range': new Array(3).fill((20 / r) * (1 - (r / 6) ** 4) ** 2),
    spot: new Array(3).fill((30 / r ** 2) * spotFactor(spotCosine(), Math.PI / 9, 5, 0.9)),
  };
  function spotCosine(): number {
    const axis = [-0.8, -1.9, -3];
    return (0.8 * 1 + 1.9 * 2 + 3 * 3) / (Math.hypot(...axis) * r);
  }

  it.each(Object.keys(lights))('%s', async (name) => {
    for (const [model, parameters] of [
      ['cook-torrance', { roughness: 0.5 }],
      ['principled', { roughness: 0.5, anisotropic: 0.5 }],
    ] as const) {
      const document = scene({
        camera: { ...narrowCamera(0.8), fov: 1 },
        lights: { light: lights[name] },
        objects: { wall: wall() },
        materials: { m: material(model, parameters) },
      });
      const film = await trace(document, { samples: 64, maxDepth: 1, width: 4, height: 4 });
      const f = createEvaluator(shippedModels.get(model) as Model, parameters).f(l, [0.6, 0, 0.8]);
      for (const [c, traced] of meanOf(film.mean()).entries()) {
        const expected = f[c]! * irradiance[name]![c]! * l[2];
        // The camera sees 17 cm of the wall.
        expect(Math.abs(traced / expected - 1)).toBeLessThan(5e-3);
      }
    }
  });
});

it('a rectangle light above a parallel surface gives the form factor of its four quarters', async () => {
  // The irradiance at a point below a corner of an a x b rectangle at height c (J. R. Howell, "A Catalog of Radiation Heat
  // Transfer Configuration Factors", B-4), with X = a/c, Y = b/c.
  const quarter = (X: number, Y: number) =>
    ((X / Math.hypot(1, X)) * Math.atan(Y / Math.hypot(1, X)) +
      (Y / Math.hypot(1, Y)) * Math.atan(X / Math.hypot(1, Y))) /
    (2 * Math.PI);
  const document = scene({
    camera: { ...narrowCamera(0.8), fov: 1 },
    lights: {
      light: {
        type: 'rectangle',
        luminance: 5,
        position: [0, 0, 1.5],
        target: [0, 0, 0],
        width: 2,
        height: 1,
      },
    },
    objects: { wall: wall() },
    materials: { m: material('lambert', { albedo: [1, 1, 1] }) },
  });
  const expected = 5 * 4 * quarter(1 / 1.5, 0.5 / 1.5);
  for (const strategy of ['mis', 'light', 'brdf'] as const) {
    const film = await trace(document, { samples: 256, maxDepth: 1, width: 16, height: 16, strategy });
    expect(Math.abs(meanOf(film.mean())[0] / expected - 1), strategy).toBeLessThan(0.01);
  }
});

it('in a closed room of albedo 1/2 that glows with 1 the sum of all bounces is 2', async () => {
  const document = scene({
    camera: { fov: 60, position: [0.1, 0.2, 0.3], target: [1, 0.1, -0.2] },
    objects: {
      room: { name: 'room', material: 'm', geometry: { type: 'box', width: 2, height: 2, depth: 2 } },
    },
    materials: {
      m: material('lambert', { albedo: [0.5, 0.5, 0.5] }, { emissive: [1, 1, 1], doubleSided: true }),
    },
  });
  for (const strategy of ['mis', 'brdf'] as const) {
    const film = await trace(document, { samples: 64, maxDepth: 60, width: 16, height: 16, strategy });
    for (const traced of meanOf(film.mean())) expect(Math.abs(traced - 2), strategy).toBeLessThan(0.01);
  }
});
