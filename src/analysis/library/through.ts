/** Light that comes through a clear sphere: followed from the viewer by the model's own sampler, as the path tracer does. */
import type { ParameterValue } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import { createEvaluator, type Evaluator } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import { createRandom } from '../random.ts';
import type { Vec3 } from '../vector.ts';
import type { Lobe } from './lobe.ts';
import { blurLevel } from './studio.ts';

type Values = Readonly<Record<string, ParameterValue>>;

/** In metres: as large as a hand holds. */
const RADIUS = 0.05;
/** Paths for each distance from the middle: so many where they all leave alike, and where they are spread. */
const FEW_PATHS = 12;
const MANY_PATHS = 144;
/** In radians: less is no spread. */
const SPREAD = 0.04;
const MOST_BOUNCES = 6;

/** Null for a model that lets no light through, or that has no sampler. */
export function createThrough(model: Model, values: Values): ((v: Vec3) => Lobe) | null {
  const { transmission } = model.file;
  if (!transmission || !model.hasSampling) return null;
  const outside = createEvaluator(model, values);
  const set = resolveParameters(model.file, values);
  const isThin = transmission.thin !== null && set[transmission.thin] === true;
  const ior = Number(set[transmission.ior]);
  const inside = isThin ? outside : createEvaluator(model, { ...values, [transmission.ior]: 1 / ior });
  const left = transmittance(model, set);

  const trace = (v: Vec3, paths: number): number[] => {
    const random = createRandom(1);
    const exits: number[] = [];
    for (let path = 0; path < paths; path++) {
      // The local frame is the whole sphere's: its middle is below the origin of it.
      let at: Vec3 = [0, 0, 1];
      let weight: Vec3 = [1 / paths, 1 / paths, 1 / paths];
      let u: [number, number] = [(path + random()) / paths, random()];
      let step = scatter(outside, v, u);
      if (!step || step.l[2] >= 0) continue;
      weight = product(weight, step.weight);
      let way = step.l;
      for (let bounce = 0; bounce < MOST_BOUNCES; bounce++) {
        const length = -2 * dot(at, way);
        at = [at[0] + length * way[0], at[1] + length * way[1], at[2] + length * way[2]];
        weight = product(weight, left(isThin ? 0 : RADIUS * length));
        // Seen from inside, the normal points to the middle.
        const n: Vec3 = [-at[0], -at[1], -at[2]];
        const frame = frameOf(n);
        u = [random(), random()];
        step = scatter(inside, toLocal([-way[0], -way[1], -way[2]], frame), u);
        if (!step) break;
        weight = product(weight, step.weight);
        way = toWorld(step.l, frame);
        if (step.l[2] < 0) {
          exits.push(...way, ...weight);
          break;
        }
      }
    }
    return exits;
  };
  return (v) => {
    const few = trace(v, FEW_PATHS);
    const isSpread = spreadOf(few) > SPREAD;
    const exits = isSpread ? trace(v, MANY_PATHS) : few;
    const blur = blurLevel(isSpread ? 0.18 : 0.05);
    const count = exits.length / 6;
    return { count, values: Float32Array.from(exits), levels: new Uint8Array(count).fill(blur) };
  };
}

/** How far apart most of the light leaves: the median of the angles between one way out and the next, in radians. */
function spreadOf(exits: readonly number[]): number {
  const angles: number[] = [];
  for (let i = 6; i < exits.length; i += 6) {
    const [a, b] = [exits.slice(i - 6, i - 3), exits.slice(i, i + 3)] as unknown as [Vec3, Vec3];
    angles.push(Math.acos(Math.min(1, dot(a, b))));
  }
  return angles.sort((a, b) => a - b)[angles.length >> 1] ?? 0;
}

/** A sampled direction, and f |cos| over the density of it. */
function scatter(evaluator: Evaluator, v: Vec3, u: [number, number]): { l: Vec3; weight: Vec3 } | null {
  if (v[2] <= 0) return null;
  const l = evaluator.sampleL(u, v);
  const density = l && evaluator.pdf(l, v);
  if (!l || !(density && density > 0)) return null;
  const scale = Math.abs(l[2]) / density;
  const [r, g, b] = evaluator.f(l, v);
  return { l, weight: [r * scale, g * scale, b * scale] };
}

/** What is left of white light after a way in metres inside. What is scattered is not followed: it counts as lost. */
function transmittance({ file }: Model, set: Values): (way: number) => Vec3 {
  const medium = file.transmission?.medium;
  const depth = medium ? Number(set[medium.depth]) : 0;
  if (!medium || depth <= 0) return () => [1, 1, 1];
  const color = set[medium.color] as Vec3;
  return (way) => color.map((value) => value ** (way / depth)) as unknown as Vec3;
}

interface Axes {
  readonly n: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
}

/** J. R. Frisvad, 2012, "Building an Orthonormal Basis from a 3D Unit Vector Without Normalization". */
function frameOf(n: Vec3): Axes {
  if (n[2] < -0.9999999) return { n, x: [0, -1, 0], y: [-1, 0, 0] };
  const a = 1 / (1 + n[2]);
  const b = -n[0] * n[1] * a;
  return { n, x: [1 - n[0] * n[0] * a, b, -n[0]], y: [b, 1 - n[1] * n[1] * a, -n[1]] };
}

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const product = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
const toLocal = (d: Vec3, { n, x, y }: Axes): Vec3 => [dot(d, x), dot(d, y), dot(d, n)];
const toWorld = (l: Vec3, { n, x, y }: Axes): Vec3 => [
  l[0] * x[0] + l[1] * y[0] + l[2] * n[0],
  l[0] * x[1] + l[1] * y[1] + l[2] * n[1],
  l[0] * x[2] + l[1] * y[2] + l[2] * n[2],
];
