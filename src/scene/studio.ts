/** A studio as an image: soft boxes on a plain dome. */
import { temperatureColor } from '../lights/units.ts';
import type { EnvironmentMap } from './environment-map.ts';
import type { SoftBox, SourceOf } from './environment-schema.ts';

type Vec3 = [number, number, number];

const WIDTH = 512;
const HEIGHT = 256;
/** Samples along each side of a texel, so that edges are even. */
const SUBSAMPLES = 3;

/** Unit vectors: to the box' middle, and along its width and its height. */
export function softBoxFrame({ azimuth, elevation, roll }: Pick<SoftBox, 'azimuth' | 'elevation' | 'roll'>): {
  middle: Vec3;
  right: Vec3;
  up: Vec3;
} {
  const [a, e, r] = [azimuth, elevation, roll].map((degrees) => (degrees * Math.PI) / 180) as Vec3;
  const middle: Vec3 = [Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)];
  const level: Vec3 = [Math.cos(a), 0, Math.sin(a)];
  const upright: Vec3 = [-Math.sin(a) * Math.sin(e), Math.cos(e), Math.cos(a) * Math.sin(e)];
  const mix = (u: Vec3, s: number, v: Vec3, t: number) => u.map((x, i) => s * x + t * v[i]!) as Vec3;
  return {
    middle,
    right: mix(level, Math.cos(r), upright, Math.sin(r)),
    up: mix(upright, Math.cos(r), level, -Math.sin(r)),
  };
}

/** How much of a box is seen in a direction, 0 to 1: angles about its axes against its own. */
export function softBoxCoverage(box: SoftBox): (direction: Vec3) => number {
  const { middle, right, up } = softBoxFrame(box);
  const [w, h] = [box.width, box.height].map((degrees) => (degrees * Math.PI) / 360) as [number, number];
  const along = (d: Vec3, axis: Vec3) => d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
  const fade = (angle: number, half: number) => {
    const part = Math.abs(angle) / half;
    if (part >= 1) return 0;
    const t = box.softness > 0 ? Math.min(1, (1 - part) / box.softness) : 1;
    return t * t * (3 - 2 * t);
  };
  return (d) => {
    const z = along(d, middle);
    if (z <= 0) return 0;
    return fade(Math.atan(along(d, right) / z), w) * fade(Math.atan(along(d, up) / z), h);
  };
}

export function studioMap({ dome, domeColor, boxes }: SourceOf<'studio'>): EnvironmentMap {
  const texels = new Float32Array(4 * WIDTH * HEIGHT);
  for (let i = 0; i < texels.length; i += 4) {
    for (const c of [0, 1, 2] as const) texels[i + c] = dome * domeColor[c];
    texels[i + 3] = 1;
  }
  for (const box of boxes) paint(texels, box);
  return { texels, width: WIDTH, height: HEIGHT };
}

/** A box covers what was there before it. */
function paint(texels: Float32Array, box: SoftBox): void {
  const tint = box.temperature === null ? [1, 1, 1] : temperatureColor(box.temperature);
  const light = box.color.map((value, c) => value * tint[c]! * box.luminance) as Vec3;
  const coverage = softBoxCoverage(box);
  const { middle } = softBoxFrame(box);
  // No corner is farther from the middle than both halves together.
  const reach = Math.min(Math.PI / 2, ((box.width + box.height) * Math.PI) / 360);
  const texel = Math.PI / HEIGHT;
  for (let y = 0; y < HEIGHT; y += 1) {
    const latitude = ((y + 0.5) / HEIGHT - 0.5) * Math.PI;
    if (Math.abs(latitude - (box.elevation * Math.PI) / 180) > reach + texel) continue;
    for (let x = 0; x < WIDTH; x += 1) {
      const [cx, cy, cz] = directionAt(x + 0.5, y + 0.5);
      if (cx * middle[0] + cy * middle[1] + cz * middle[2] < Math.cos(Math.min(Math.PI, reach + texel)))
        continue;
      let sum = 0;
      for (let j = 0; j < SUBSAMPLES; j += 1)
        for (let i = 0; i < SUBSAMPLES; i += 1)
          sum += coverage(directionAt(x + (i + 0.5) / SUBSAMPLES, y + (j + 0.5) / SUBSAMPLES));
      const part = sum / SUBSAMPLES ** 2;
      if (part === 0) continue;
      const at = 4 * (y * WIDTH + x);
      for (const c of [0, 1, 2] as const) texels[at + c] = texels[at + c]! * (1 - part) + light[c] * part;
    }
  }
}

/** @param x @param y in texels */
function directionAt(x: number, y: number): Vec3 {
  const latitude = (y / HEIGHT - 0.5) * Math.PI;
  const longitude = (x / WIDTH - 0.5) * 2 * Math.PI;
  const level = Math.cos(latitude);
  return [Math.cos(longitude) * level, Math.sin(latitude), Math.sin(longitude) * level];
}
