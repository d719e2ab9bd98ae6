/**
 * Small pictures of materials with patterns. What is reflected changes evenly with a colour, and nearly so with the roughness
 * in the range that a pattern has of it: two pictures are made, below and above the mean, and each pixel is between them.
 */
import type { ParameterValue } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import type { Rgb } from '../plots/curve.ts';
import type { Vec3 } from '../vector.ts';
import { type PatternSampler, type PatternUse, patternSampler } from './pattern-sampler.ts';
import type { ThumbnailSubject } from './thumbnail.ts';

export type Bend = (n: Vec3) => Vec3;

/** How far below and above the mean the two pictures are. */
const AWAY = 0.4;

/**
 * @param picture of plain values, whose normals `bend` turns
 * @param normalAt of a pixel, on the ball
 */
export function patternedRadiance(
  { model, parameters }: ThumbnailSubject,
  patterns: readonly PatternUse[],
  radius: number,
  picture: (parameters: Readonly<Record<string, ParameterValue>>, bend: Bend | null) => Float32Array,
  normalAt: (pixel: number) => Vec3,
): Float32Array {
  const values: Record<string, ParameterValue> = { ...parameters };
  const usual = resolveParameters(model.file, parameters);
  let shown: { name: string; whole: Amount; sampler: PatternSampler; channel: number } | null = null;
  let bend: Bend | null = null;
  for (const use of patterns) {
    const sampler = patternSampler(use, radius);
    const whole = usual[use.place];
    if (use.place === 'normalMap') bend = bendBy(sampler, use.scale);
    if (whole === undefined || typeof whole === 'boolean') continue;
    const channel = Math.max(0, 'rgb'.indexOf(use.ref.channel ?? 'r'));
    values[use.place] = times(whole, sampler.mean, channel);
    // One at a time, and rather a colour: more would take a picture for each of their combinations.
    if (shown === null || typeof whole === 'object') shown = { name: use.place, whole, sampler, channel };
  }
  if (shown === null) return picture(values, bend);
  const { name, whole, sampler, channel } = shown;
  const mean = times(whole, sampler.mean, channel);
  const [low, high] = [times(mean, 1 - AWAY), capped(times(mean, 1 + AWAY))];
  const [below, above] = [low, high].map((value) => picture({ ...values, [name]: value }, bend)) as [
    Float32Array,
    Float32Array,
  ];
  return below.map((from, i) => {
    const pixel = Math.floor(i / 3);
    const texel = times(whole, sampler.at(normalAt(pixel)), channel);
    const c = i % 3;
    const width = part(high, c) - part(low, c);
    const t = width > 0 ? (part(texel, c) - part(low, c)) / width : 0;
    return Math.max(0, from + (above[i]! - from) * t);
  });
}

type Amount = number | Rgb;

const part = (value: Amount, c: number): number => (typeof value === 'number' ? value : value[c as 0]);

/** A value times a texel: all of it for a colour, one channel for a number. */
function times(value: Amount, by: Amount, channel = 0): Amount {
  if (typeof value === 'number') return value * part(by, channel);
  return [value[0] * part(by, 0), value[1] * part(by, 1), value[2] * part(by, 2)];
}

const capped = (value: Amount): Amount =>
  typeof value === 'number' ? Math.min(1, value) : (value.map((c) => Math.min(1, c)) as unknown as Rgb);

/** Normals as a normal map gives them, in the frame of a ball's texture coordinates. */
function bendBy(sampler: PatternSampler, scale: number): Bend {
  return (n) => {
    const texel = sampler.at(n);
    const [tx, ty, tz] = [scale * (2 * texel[0] - 1), scale * (2 * texel[1] - 1), 2 * texel[2] - 1];
    const level = Math.max(1e-6, Math.hypot(n[0], n[2]));
    const x: Vec3 = [n[2] / level, 0, -n[0] / level];
    const y: Vec3 = [n[1] * x[2], n[2] * x[0] - n[0] * x[2], -n[1] * x[0]];
    const bent = [0, 1, 2].map((i) => tx * x[i as 0] + ty * y[i as 0] + tz * n[i as 0]) as unknown as Vec3;
    const length = Math.hypot(...bent);
    return [bent[0] / length, bent[1] / length, bent[2] / length];
  };
}
