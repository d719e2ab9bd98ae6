import { normalView, positionView, tangentView, vec4 } from 'three/tsl';
import * as THREE from 'three/webgpu';
import { shippedModels } from '../../models/index.ts';
import { parseBrdf } from '../../src/brdf/parse.ts';
import { createEvaluator, type Frame, type Vector3 } from '../../src/glsl/evaluator.ts';
import { compileModel, type Model } from '../../src/glsl/model.ts';
import { falloffAt } from '../../src/lights/falloff.ts';
import { BrdfPointLight } from '../../src/lights/point-light.ts';
import { BrdfSpotLight, spotFactor } from '../../src/lights/spot-light.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';

/**
 * A unit sphere under one light, drawn by the renderer and worked out on the CPU, pixel by pixel, from
 * the shading equation and the model's float64 evaluation.
 */

export const SIZE = 96;

/** A light of three.js, and what it sends to a point: direction l and irradiance E. Null: in darkness. */
interface LightCase {
  readonly create: () => THREE.Light[];
  readonly arrives: (point: Vector3) => { l: Vector3; E: number } | null;
  /** Whether the irradiance jumps near this point, so that float32 may decide otherwise. */
  readonly jumps?: (point: Vector3) => boolean;
}

const LIGHT_POSITION: Vector3 = [1.2, 1.5, 2.2];

function toLight(point: Vector3): { l: Vector3; r: number } {
  const d = LIGHT_POSITION.map((x, i) => x - (point[i] as number));
  const r = Math.hypot(...d);
  return { l: d.map((x) => x / r) as unknown as Vector3, r };
}

function pointCase(falloff: 'inverse-square' | 'linear' | 'constant', range = 0): LightCase {
  return {
    create: () => {
      const light = new BrdfPointLight(0xffffff, 7);
      light.falloff = falloff;
      light.distance = range;
      light.position.set(...LIGHT_POSITION);
      return [light];
    },
    arrives: (point) => {
      const { l, r } = toLight(point);
      return { l, E: 7 * falloffAt(r, falloff, range) };
    },
  };
}

function spotCase(angle: number, exponent: number, penumbra: number): LightCase {
  const axis = LIGHT_POSITION.map((x) => x / Math.hypot(...LIGHT_POSITION));
  const cosine = (l: Vector3) => l.reduce((sum, x, i) => sum + x * (axis[i] as number), 0);
  return {
    create: () => {
      const light = new BrdfSpotLight(0xffffff, 9, angle, exponent);
      light.penumbra = penumbra;
      light.position.set(...LIGHT_POSITION);
      return [light];
    },
    arrives: (point) => {
      const { l, r } = toLight(point);
      return { l, E: 9 * spotFactor(cosine(l), angle, exponent, penumbra) * falloffAt(r, 'inverse-square') };
    },
    jumps: (point) => Math.abs(cosine(toLight(point).l) - Math.cos(angle)) < 1e-4,
  };
}

export const LIGHT_CASES: Readonly<Record<string, LightCase>> = {
  directional: {
    create: () => {
      const light = new THREE.DirectionalLight(0xffffff, 3);
      light.position.set(2, 1, 2);
      return [light];
    },
    arrives: () => ({ l: [2 / 3, 1 / 3, 2 / 3], E: 3 }),
  },
  'point, inverse square': pointCase('inverse-square'),
  'point, linear': pointCase('linear'),
  'point, constant': pointCase('constant'),
  'point with a range': pointCase('inverse-square', 3),
  'spot, even': spotCase(0.3, 0, 0),
  'spot, cos^40': spotCase(0.5, 40, 0),
  'spot with a penumbra': spotCase(0.35, 2, 0.6),
};

export const MATERIAL_CASES: Readonly<Record<string, { model: string; values: Record<string, unknown> }>> = {
  lambert: { model: 'lambert', values: {} },
  'cook-torrance': { model: 'cook-torrance', values: { roughness: 0.35, ior: 1.7, kd: 0.4 } },
  'cook-torrance, metallic': { model: 'cook-torrance', values: { metallic: 1, roughness: 0.3 } },
  principled: { model: 'principled', values: {} },
  'principled, every lobe': {
    model: 'principled',
    values: { subsurface: 0.5, sheen: 1, clearcoat: 1, clearcoatGloss: 0.2, metallic: 0.3, roughness: 0.4 },
  },
  'principled, anisotropic': {
    model: 'principled',
    values: { anisotropic: 0.8, roughness: 0.5, metallic: 1 },
  },
  'principled-thesis': { model: 'principled-thesis', values: { roughness: 0.4, subsurface: 0.3 } },
  'measured data': { model: '', values: {} },
};

/** A model whose values are measured: RGB triples by the half vector's cosine, interpolated in its GLSL. */
const measured = compileModel(
  parseBrdf(
    `analytic
::begin parameters
float strength 0 2 1
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  float x = max(dot(N, normalize(L + V)), 0.) * 4095.;
  int i = int(x);
  return strength * mix(fetchData(i), fetchData(i + 1), x - float(i));
}
::end shader`,
    'measured.brdf',
  ),
  Float32Array.from({ length: 4096 * 3 }, (_, i) => 0.2 + Math.sin(i / 4096) ** 2),
);

function materialNamed(name: string): { model: Model; values: Record<string, unknown> } {
  if (name === 'measured data') return { model: measured, values: { strength: 0.7 } };
  const { model, values } = MATERIAL_CASES[name] as (typeof MATERIAL_CASES)[string];
  return { model: modelNamed(model), values };
}

export function modelNamed(name: string): Model {
  return shippedModels.get(name) as Model;
}

const CAMERA_Z = 3.2;
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 10);
camera.position.set(0, 0, CAMERA_Z);
camera.updateMatrixWorld();

export function sphereGeometry(): THREE.BufferGeometry {
  const geometry = new THREE.SphereGeometry(1, 96, 64);
  geometry.computeTangents();
  return geometry;
}

/** The frame's linear radiance: RGBA floats, rows from the top. */
export async function drawSphere(
  renderer: THREE.WebGPURenderer,
  geometry: THREE.BufferGeometry,
  material: THREE.Material,
  lights: readonly THREE.Light[],
  environment: THREE.Texture | null = null,
): Promise<Float32Array> {
  const scene = new THREE.Scene();
  scene.environment = environment;
  scene.add(new THREE.Mesh(geometry, material), ...lights);
  return drawScene(renderer, scene);
}

/** The same for any scene, seen from where the sphere is seen. */
export async function drawScene(renderer: THREE.WebGPURenderer, scene: THREE.Scene): Promise<Float32Array> {
  const target = new THREE.RenderTarget(SIZE, SIZE, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.setRenderTarget(null);
  const pixels = (await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIZE, SIZE)) as Float32Array;
  target.dispose();
  // WebGPU's rows start at the top, WebGL's at the bottom.
  const { backend } = renderer as unknown as { backend: { isWebGPUBackend?: boolean } };
  if (backend.isWebGPUBackend) return pixels;
  const rows = Array.from({ length: SIZE }, (_, y) =>
    pixels.slice((SIZE - 1 - y) * SIZE * 4, (SIZE - y) * SIZE * 4),
  );
  return Float32Array.from(rows.flatMap((row) => [...row]));
}

/** The points, normals and tangents that the rasteriser interpolates for every pixel, in view space. */
export interface SurfaceBuffers {
  readonly position: Float32Array;
  readonly normal: Float32Array;
  readonly tangent: Float32Array;
}

/**
 * Read back rather than worked out: the facets of the mesh and the rasteriser's grid (SwiftShader snaps
 * vertices to 1/16 of a pixel) move them by up to 1e-3, which is no affair of the shading.
 */
export async function drawSurface(
  renderer: THREE.WebGPURenderer,
  geometry: THREE.BufferGeometry,
): Promise<SurfaceBuffers> {
  const draw = (node: THREE.Node) => {
    const material = new THREE.NodeMaterial();
    // Shifted by a constant: the output is clamped at 0.
    material.fragmentNode = vec4(node as THREE.Node<'vec3'>, 1).add(SHIFT);
    return drawSphere(renderer, geometry, material, []);
  };
  const position = await draw(positionView);
  const normal = await draw(normalView);
  const tangent = await draw(tangentView);
  return { position, normal, tangent };
}

const SHIFT = 8;

/** The surface in one pixel; null off the sphere. */
export function surfaceAt(
  buffers: SurfaceBuffers,
  x: number,
  y: number,
): { point: Vector3; V: Vector3; frame: Frame } | null {
  const i = (y * SIZE + x) * 4;
  if (buffers.position[i + 3] !== 1 + SHIFT) return null;
  const read = (buffer: Float32Array) =>
    [0, 1, 2].map((c) => (buffer[i + c] as number) - SHIFT) as unknown as Vector3;
  const unit = (v: readonly number[]) => v.map((c) => c / Math.hypot(...v)) as unknown as Vector3;
  const view = read(buffers.position);
  const N = unit(read(buffers.normal));
  const T = read(buffers.tangent);
  const along = T[0] * N[0] + T[1] * N[1] + T[2] * N[2];
  const X = unit(T.map((c, k) => c - along * (N[k] as number)));
  const Y: Vector3 = [N[1] * X[2] - N[2] * X[1], N[2] * X[0] - N[0] * X[2], N[0] * X[1] - N[1] * X[0]];
  // The camera looks along -z from (0, 0, CAMERA_Z) and is not turned.
  return { point: [view[0], view[1], view[2] + CAMERA_Z], V: unit(view.map((c) => -c)), frame: { N, X, Y } };
}

export interface Comparison {
  /** Pixels that were compared. */
  readonly count: number;
  /** Those among them that are next to a jump of the equation, and on one of its sides. */
  readonly jumps: number;
  /** The largest difference, relative to the value or, where that is less, to 1e-3. */
  readonly worst: number;
  readonly where: string;
}

export type Surface = NonNullable<ReturnType<typeof surfaceAt>>;

/** Of every pixel, rows from the top: the same for all pictures of a sphere. */
const surfacesOf = new WeakMap<SurfaceBuffers, readonly (Surface | null)[]>();

function allSurfaces(buffers: SurfaceBuffers): readonly (Surface | null)[] {
  const known = surfacesOf.get(buffers);
  if (known) return known;
  const all = Array.from({ length: SIZE * SIZE }, (_, i) =>
    surfaceAt(buffers, i % SIZE, Math.floor(i / SIZE)),
  );
  surfacesOf.set(buffers, all);
  return all;
}

export interface Expectation {
  /** What the pixel should be; null where it cannot be said. */
  readonly at: (surface: Surface) => readonly number[] | null;
  /** The same for inputs that differ by float32's rounding: a value between them will do, where it jumps. */
  readonly near?: (surface: Surface) => readonly (readonly number[])[];
  /** Every how many rows and columns a pixel is looked at. */
  readonly stride?: number;
}

/** Compares every pixel whose view is at least 0.25 (cosine) off the silhouette. */
export function comparePixels(
  pixels: Float32Array,
  surfaces: SurfaceBuffers,
  { at, near, stride = 1 }: Expectation,
): Comparison {
  let [count, jumps, worst, where] = [0, 0, 0, ''];
  const all = allSurfaces(surfaces);
  for (let y = 0; y < SIZE; y += stride) {
    for (let x = 0; x < SIZE; x += stride) {
      const surface = all[y * SIZE + x];
      if (!surface || dot(surface.V, surface.frame.N) < 0.25) continue;
      const expected = at(surface);
      if (!expected) continue;
      count++;
      const got = [0, 1, 2].map((c) => pixels[(y * SIZE + x) * 4 + c] as number);
      const differences = got.map((value, c) => difference(value, expected[c] as number));
      const most = Math.max(...differences.map((d) => (Number.isNaN(d) ? Number.POSITIVE_INFINITY : d)));
      if (most > 1e-3 && near && isBetween(got, near(surface))) {
        jumps++;
      } else if (most > worst) {
        worst = most;
        where = `pixel ${x}, ${y}: ${got} is not ${expected}`;
      }
    }
  }
  return { count, jumps, worst, where };
}

const difference = (got: number, expected: number) => Math.abs(got - expected) / Math.max(expected, 1e-3);

/** Whether every component is between those of the values, or within 1e-3 of that. */
const isBetween = (got: readonly number[], values: readonly (readonly number[])[]) =>
  got.every((value, c) => {
    const all = values.map((v) => v[c] as number);
    return value >= Math.min(...all) * (1 - 1e-3) && value <= Math.max(...all) * (1 + 1e-3);
  });

export const dot = (a: Vector3, b: Vector3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Draws a case and compares it with the shading equation for a light from one direction. */
export async function compareSphere(
  renderer: THREE.WebGPURenderer,
  geometry: THREE.BufferGeometry,
  surfaces: SurfaceBuffers,
  materialCase: string,
  lightCase: string,
): Promise<Comparison> {
  const { model, values } = materialNamed(materialCase);
  const light = LIGHT_CASES[lightCase] as LightCase;
  const material = new BrdfMaterial(model, values);
  const pixels = await drawSphere(renderer, geometry, material, light.create());
  material.dispose();
  const evaluator = createEvaluator(model, values);
  return comparePixels(pixels, surfaces, {
    at: ({ point, V, frame }) => {
      if (light.jumps?.(point)) return null;
      const arriving = light.arrives(point);
      const cosTheta = arriving ? dot(arriving.l, frame.N) : 0;
      if (!arriving || cosTheta <= 0) return [0, 0, 0];
      return evaluator.f(arriving.l, V, frame).map((f) => f * arriving.E * cosTheta);
    },
  });
}
