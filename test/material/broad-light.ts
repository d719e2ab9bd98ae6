import * as THREE from 'three/webgpu';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createEvaluator, type Evaluator, type Frame, type Vector3 } from '../../src/glsl/evaluator.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { rectangleCase } from './lit-rectangle.ts';
import {
  type Comparison,
  comparePixels,
  dot,
  drawSphere,
  type Expectation,
  modelNamed,
  type SurfaceBuffers,
} from './lit-sphere.ts';

/**
 * The sphere under lights that are wider than a point, drawn by the renderer and worked out on the CPU from
 * what docs/decisions/environment-light.md says that the renderer computes.
 */

export const BROAD_MATERIALS: Readonly<Record<string, { model: string; values: Record<string, unknown> }>> = {
  lambert: { model: 'lambert', values: { albedo: [0.8, 0.5, 0.2] } },
  'cook-torrance': { model: 'cook-torrance', values: { roughness: 0.35, ior: 1.7, kd: 0.4 } },
  'principled, smooth': { model: 'principled', values: { roughness: 0.2 } },
  'principled, rough': { model: 'principled', values: { roughness: 0.8, sheen: 0.5 } },
};

/** R(v) of a material over n.v in 0.2..1: its values at Chebyshev's points. */
export type AlbedoCurve = readonly (readonly number[])[];

const [LEAST, NODES] = [0.2, 10];
const nodeAt = (k: number) => Math.cos(((k + 0.5) * Math.PI) / NODES);

/** By adaptive quadrature. R is smooth: a polynomial of degree 9 through it errs by less than 1e-4, and float32 by far less. */
export function albedoCurve(name: string): AlbedoCurve {
  const { model, values } = BROAD_MATERIALS[name] as (typeof BROAD_MATERIALS)[string];
  const f = createQuickEvaluator(modelNamed(model), values).term('BRDF');
  return Array.from({ length: NODES }, (_, k) => {
    const cosine = LEAST + ((1 - LEAST) * (1 + nodeAt(k))) / 2;
    const v: Vector3 = [Math.sqrt(1 - cosine * cosine), 0, cosine];
    return directionalAlbedo(f, v, { tolerance: 3e-5, maxEvaluations: 40_000 }).value;
  });
}

/** The polynomial through a curve's values (J.-P. Berrut and L. N. Trefethen, 2004, equations 4.2 and 5.4). */
function albedoAt(curve: AlbedoCurve, cosine: number): number[] {
  const x = (2 * (cosine - LEAST)) / (1 - LEAST) - 1;
  const weights = curve.map(
    (_, k) => ((-1) ** k * Math.sin(((k + 0.5) * Math.PI) / NODES)) / (x - nodeAt(k)),
  );
  const total = weights.reduce((sum, w) => sum + w, 0);
  return [0, 1, 2].map(
    (c) => weights.reduce((sum, w, k) => sum + w * ((curve[k] as readonly number[])[c] as number), 0) / total,
  );
}

interface Scene {
  readonly lights?: readonly THREE.Light[];
  readonly environment?: THREE.Texture;
  readonly expectation: (evaluator: Evaluator, curve: AlbedoCurve) => Expectation;
}

/** Reflected light where `irradiance` comes from everywhere: R(v) E(n)/pi. */
const everywhere =
  (irradiance: (N: Vector3) => readonly number[]) =>
  (_: Evaluator, curve: AlbedoCurve): Expectation => ({
    at: ({ V, frame }) => {
      const E = irradiance(frame.N);
      return albedoAt(curve, dot(V, frame.N)).map((r, c) => (r * (E[c] as number)) / Math.PI);
    },
  });

const [SKY, GROUND] = [
  [0.5, 0.9, 1.6],
  [0.7, 0.4, 0.2],
] as const;

export const BROAD_LIGHTS: Readonly<Record<string, () => Scene>> = {
  'ambient light': () => ({
    lights: [new THREE.AmbientLight(0xffffff, Math.PI / 2)],
    expectation: everywhere(() => [Math.PI / 2, Math.PI / 2, Math.PI / 2]),
  }),

  // Sky and ground mix by the share of the hemisphere about n that each fills, as for a Lambertian surface;
  // every other model reflects that irradiance as if it came evenly from everywhere.
  'a hemisphere light': () => ({
    lights: [
      new THREE.HemisphereLight(new THREE.Color().setRGB(...SKY), new THREE.Color().setRGB(...GROUND), 2),
    ],
    expectation: everywhere((N) => SKY.map((sky, c) => 2 * mix(GROUND[c] as number, sky, (1 + N[1]) / 2))),
  }),

  'an even environment': () => ({
    environment: cubeOf(Array.from({ length: 6 }, () => [1.5, 1.5, 1.5])),
    expectation: everywhere(() => [1.5 * Math.PI, 1.5 * Math.PI, 1.5 * Math.PI]),
  }),

  'an environment of six colours': () => ({ environment: cubeOf(FACES), expectation: sampledEnvironment }),

  'a rectangle': () => rectangleCase(),
};

const mix = (a: number, b: number, t: number) => a + (b - a) * t;

/** Radiance from +x, -x, +y, -y, +z, -z, exact in half floats. */
const FACES: readonly (readonly number[])[] = [
  [4, 1, 0.5],
  [0.5, 3, 1],
  [1, 1.5, 6],
  [0.25, 0.5, 0.125],
  [2, 2, 1],
  [0.5, 0.25, 3],
];

/** An environment whose faces have one texel each: no filtering and no mip level can change it. */
function cubeOf(faces: readonly (readonly number[])[]): THREE.CubeTexture {
  // three.js sees cube textures mirrored in x.
  const seen = [1, 0, 2, 3, 4, 5].map((i) => faces[i] as readonly number[]);
  const images = seen.map((rgb) => {
    const half = Uint16Array.from([...rgb, 1], (x) => THREE.DataUtils.toHalfFloat(x));
    const image = new THREE.DataTexture(half, 1, 1, THREE.RGBAFormat, THREE.HalfFloatType);
    image.needsUpdate = true;
    return image;
  });
  const cube = new THREE.CubeTexture(images as unknown as HTMLImageElement[]);
  cube.format = THREE.RGBAFormat;
  cube.type = THREE.HalfFloatType;
  cube.minFilter = cube.magFilter = THREE.NearestFilter;
  cube.generateMipmaps = false;
  cube.needsUpdate = true;
  return cube;
}

function faceOf([x, y, z]: Vector3): readonly number[] {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const face = ax >= ay && ax >= az ? (x > 0 ? 0 : 1) : ay >= az ? (y > 0 ? 2 : 3) : z > 0 ? 4 : 5;
  return FACES[face] as readonly number[];
}

const GOLDEN = (Math.sqrt(5) - 1) / 2;
/** The i-th of n points of the renderer's lattice, and that point as far off as float32 may put it. */
export const lattice = (i: number, n: number, [x, y] = EXACT): [number, number] => [
  (i + 0.5) / n + x,
  ((i + 0.5) * GOLDEN + y) % 1,
];
export const EXACT: readonly [number, number] = [0, 0];
export const ROUNDED: readonly (readonly [number, number])[] = [
  [1e-6, 0],
  [-1e-6, 0],
  [0, 2e-6],
  [0, -2e-6],
];

/** The frame in which the renderer samples: T. Duff et al., 2017, "Building an Orthonormal Basis, Revisited". */
export function samplingFrame(N: Vector3): Frame {
  const [x, y, z] = N;
  const s = z < 0 ? -1 : 1;
  const a = -1 / (s + z);
  const X: Vector3 = [1 + s * x * x * a, s * x * y * a, -s * x];
  return {
    N,
    X,
    Y: [N[1] * X[2] - N[2] * X[1], N[2] * X[0] - N[0] * X[2], N[0] * X[1] - N[1] * X[0]],
  };
}

/** V turned by float32's rounding, many times over, in four directions. */
export function nearby(V: Vector3, { X, Y }: Frame): Vector3[] {
  return [X, Y].flatMap((axis) =>
    [-2e-5, 2e-5].map((t) => {
      const w = V.map((c, i) => c + t * (axis[i] as number));
      return w.map((c) => c / Math.hypot(...w)) as unknown as Vector3;
    }),
  );
}

/** How exactly a texture unit tells faces apart. */
const EDGES = [0, 1, 2].flatMap((axis) =>
  [-2e-4, 2e-4].map((x) => [0, 1, 2].map((k) => (k === axis ? x : 0))),
);

/** Every third pixel of every third row: of each, ten thousand samples are worked out in float64. */
export const STRIDE = 3;

/** Samples for each fragment, the renderer's default. */
const SAMPLES = 32;

/** R(v) times the mean radiance of the model's own samples, weighted by f (n.l)/pdf. */
function sampledEnvironment(evaluator: Evaluator, curve: AlbedoCurve): Expectation {
  const reflected = (V: Vector3, frame: Frame, rounding = EXACT, edge = [0, 0, 0]): number[] => {
    const sums = [0, 0, 0];
    const weights = [0, 0, 0];
    for (let i = 0; i < SAMPLES; i++) {
      const l = evaluator.sampleL(lattice(i, SAMPLES, rounding), V, frame);
      const density = l && dot(l, frame.N) > 0 ? evaluator.pdf(l, V, frame) : 0;
      if (!l || !(density > 0)) continue;
      const f = evaluator.f(l, V, frame);
      const color = faceOf(l.map((x, k) => x + (edge[k] as number)) as unknown as Vector3);
      for (const c of [0, 1, 2]) {
        const weight = ((f[c] as number) * dot(l, frame.N)) / density;
        weights[c] = (weights[c] as number) + weight;
        sums[c] = (sums[c] as number) + weight * (color[c] as number);
      }
    }
    return albedoAt(curve, dot(V, frame.N)).map((r, c) => (r * (sums[c] as number)) / (weights[c] as number));
  };
  return {
    stride: STRIDE,
    at: ({ V, frame }) => reflected(V, samplingFrame(frame.N)),
    // A sample may fall on either side of an edge between two faces, or into another lobe.
    near: ({ V, frame }) => [
      ...nearby(V, frame).map((w) => reflected(w, samplingFrame(frame.N))),
      ...ROUNDED.map((rounding) => reflected(V, samplingFrame(frame.N), rounding)),
      ...EDGES.map((edge) => reflected(V, samplingFrame(frame.N), EXACT, edge)),
    ],
  };
}

export async function compareBroad(
  renderer: THREE.WebGPURenderer,
  geometry: THREE.BufferGeometry,
  surfaces: SurfaceBuffers,
  materialCase: string,
  lightCase: string,
  curve: AlbedoCurve,
): Promise<Comparison> {
  const { model, values } = BROAD_MATERIALS[materialCase] as (typeof BROAD_MATERIALS)[string];
  const scene = (BROAD_LIGHTS[lightCase] as () => Scene)();
  const material = new BrdfMaterial(modelNamed(model), values);
  const pixels = await drawSphere(
    renderer,
    geometry,
    material,
    scene.lights ?? [],
    scene.environment ?? null,
  );
  material.dispose();
  const evaluator = createEvaluator(modelNamed(model), values);
  return comparePixels(pixels, surfaces, scene.expectation(evaluator, curve));
}
