/** A small picture of a material, without a renderer and without a GPU: a sphere in the light of a studio. */
import type { ParameterValue } from '../../brdf/model.ts';
import { displayPixels } from '../../color/tone-mapping.ts';
import { type Model, multipleScatteringModel } from '../../glsl/model.ts';
import type { Reflectance, Rgb } from '../plots/curve.ts';
import { createQuickEvaluator } from '../quick-evaluator.ts';
import { createRandom } from '../random.ts';
import { direction, type Vec3 } from '../vector.ts';
import { type Lobe, lobeOf } from './lobe.ts';
import type { PatternUse } from './pattern-sampler.ts';
import { type Bend, patternedRadiance } from './patterned.ts';
import { sparsely } from './sparse.ts';
import { studioMaps, studioTexel } from './studio.ts';
import { createThrough } from './through.ts';

export interface ThumbnailSubject {
  readonly model: Model;
  readonly parameters: Readonly<Record<string, ParameterValue>>;
  readonly multipleScattering: boolean;
  /** What the surface sends out by itself, in units of the studio's white; none if not given. */
  readonly emission?: Rgb;
  /** What of it has a pattern. */
  readonly patterns?: readonly PatternUse[];
}

/** Changes whenever pictures do, so that kept ones are made anew. */
export const THUMBNAIL_VERSION = 3;

/** The sphere's part of the square. */
const FILL = 0.94;
/** Distances from the middle for which a lobe is computed, of a surface without a grain. */
const DISTANCES = 96;
/** The outermost rim is seen about 4 degrees above the horizon, as the mean of its pixels is. */
const LOWEST = 0.06;
/** Pixels around the sphere that have the rim's colour, for what is between pixels. */
const BORDER = 6;
/** So that a white matte sphere is nearly white where it is brightest. */
const EXPOSURE = -0.25;

/** RGBA, sRGB, rows from the top; clear beside the sphere. Pixels are not multiplied by their alpha. */
export function thumbnail(subject: ThumbnailSubject, size: number): Uint8ClampedArray<ArrayBuffer> {
  const radius = (FILL * size) / 2;
  const { patterns = [] } = subject;
  const radiance =
    patterns.length > 0
      ? patternedRadiance(
          subject,
          patterns,
          radius,
          (parameters, bend) => radianceOf({ ...subject, parameters }, size, bend),
          (pixel) => normalAt(pixel % size, Math.floor(pixel / size), size).n,
        )
      : radianceOf(subject, size, null);
  const pixels = displayPixels(radiance, { exposure: EXPOSURE, toneMapping: 'neutral' });
  for (let i = 0; i < size * size; i++) {
    const x = (i % size) + 0.5 - size / 2;
    const y = Math.floor(i / size) + 0.5 - size / 2;
    pixels[4 * i + 3] = 255 * Math.min(1, Math.max(0, radius - Math.hypot(x, y) + 0.5));
  }
  return pixels as Uint8ClampedArray<ArrayBuffer>;
}

/** Beyond the edge the rim goes on; how much of a pixel is covered is its alpha. */
function normalAt(column: number, row: number, size: number): { n: Vec3; distance: number } {
  const radius = (FILL * size) / 2;
  const x = (column + 0.5 - size / 2) / radius;
  const y = (size / 2 - row - 0.5) / radius;
  const distance = Math.hypot(x, y);
  const z = Math.max(LOWEST, Math.sqrt(Math.max(0, 1 - distance * distance)));
  const scale = Math.sqrt(1 - z * z) / (distance || 1);
  return { n: [x * scale, y * scale, z], distance };
}

/** RGB, rows from the top. @param bend turns the normals of a surface without a grain */
function radianceOf(subject: ThumbnailSubject, size: number, bend: Bend | null): Float32Array {
  const { model, emission = [0, 0, 0] } = subject;
  const whole = subject.multipleScattering ? multipleScatteringModel(model) : model;
  const f = createQuickEvaluator(whole, subject.parameters).term(whole.main);
  const isGrained = hasGrain(f);
  const lobeAt = isGrained ? grainedLobes(f) : roundLobes(subject, f);
  const radius = (FILL * size) / 2;
  const turned = bend && !isGrained ? (n: Vec3) => towardsViewer(bend(n)) : null;
  const at = (column: number, row: number): Rgb => {
    const { n, distance } = normalAt(column, row, size);
    if (distance * radius > radius + BORDER) return [0, 0, 0];
    const [r, g, b] = shade(lobeAt(turned ? turned(n) : n));
    return [r + emission[0], g + emission[1], b + emission[2]];
  };
  if (!turned) return sparsely(size, at);
  const radiance = new Float32Array(3 * size * size);
  for (let i = 0; i < size * size; i++) radiance.set(at(i % size, Math.floor(i / size)), 3 * i);
  return radiance;
}

/** What is turned away would not be seen. */
function towardsViewer([x, y, z]: Vec3): Vec3 {
  if (z >= LOWEST) return [x, y, z];
  const scale = Math.sqrt(1 - LOWEST * LOWEST) / Math.hypot(x, y);
  return [x * scale, y * scale, LOWEST];
}

/** A lobe, and the axes of its frame in the studio. */
interface Placed {
  readonly lobes: readonly Lobe[];
  readonly n: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
}

/** The viewer is far away along z. */
export function shade({ lobes, n, x, y }: Placed, maps = studioMaps()): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  for (const { count, values, levels } of lobes) {
    for (let i = 0; i < count; i++) {
      const [a, b, c] = [values[6 * i]!, values[6 * i + 1]!, values[6 * i + 2]!];
      const texel = studioTexel(
        a * x[0] + b * y[0] + c * n[0],
        a * x[1] + b * y[1] + c * n[1],
        a * x[2] + b * y[2] + c * n[2],
      );
      const map = maps[levels[i]!]!;
      sum[0] += values[6 * i + 3]! * map[texel]!;
      sum[1] += values[6 * i + 4]! * map[texel + 1]!;
      sum[2] += values[6 * i + 5]! * map[texel + 2]!;
    }
  }
  return sum;
}

/** Without a grain a lobe depends on the distance from the middle alone, and is turned about the line of sight. */
export function roundLobes({ model, parameters }: ThumbnailSubject, f: Reflectance): (n: Vec3) => Placed {
  const through = createThrough(model, parameters);
  const known = new Map<number, readonly Lobe[]>();
  return (n) => {
    const distance = Math.hypot(n[0], n[1]);
    const step = Math.min(DISTANCES - 1, Math.floor(distance * DISTANCES));
    const lobes = known.get(step) ?? lobesAt((step + 0.5) / DISTANCES);
    known.set(step, lobes);
    // The viewer is in the plane of x and n.
    const [ox, oy] = distance > 0 ? [n[0] / distance, n[1] / distance] : [1, 0];
    return { lobes, n, x: [-ox * n[2], -oy * n[2], distance], y: [oy, -ox, 0] };
  };
  function lobesAt(sine: number): readonly Lobe[] {
    const v: Vec3 = [sine, 0, Math.max(LOWEST, Math.sqrt(1 - sine * sine))];
    return through ? [lobeOf(f, v), through(v)] : [lobeOf(f, v)];
  }
}

/** Tangents run around the sphere, as its texture coordinates do. */
function grainedLobes(f: Reflectance): (n: Vec3) => Placed {
  return (n) => {
    const level = Math.hypot(n[0], n[2]);
    const x: Vec3 = [n[2] / level, 0, -n[0] / level];
    const y: Vec3 = [n[1] * x[2], n[2] * x[0] - n[0] * x[2], -n[1] * x[0]];
    return { lobes: [lobeOf(f, [x[2], y[2], n[2]])], n, x, y };
  };
}

/** Whether it matters how the surface lies under the same light and viewer. */
export function hasGrain(f: Reflectance): boolean {
  const random = createRandom(7);
  for (let i = 0; i < 24; i++) {
    const [a, b, phi, turn] = [0.2 + 0.75 * random(), 0.2 + 0.75 * random(), 7 * random(), 7 * random()];
    const [here, there] = [0, turn].map((by) => f(direction(a, phi + by), direction(b, by)));
    for (let c = 0; c < 3; c++) {
      const [p, q] = [here![c as 0], there![c as 0]];
      if (Math.abs(p - q) > 1e-3 * Math.max(p, q) + 1e-6) return true;
    }
  }
  return false;
}
