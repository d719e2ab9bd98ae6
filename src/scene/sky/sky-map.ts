/** The sky as it is seen from the ground, in nits: an image of all directions, without the sun's disc. */

import type { EnvironmentMap } from '../environment-map.ts';
import {
  type Atmosphere,
  BANDS,
  EARTH_RADIUS,
  EYE_HEIGHT,
  rayleighPhase,
  rgbOfBands,
  straightPhase,
  turningPhase,
} from './atmosphere.ts';
import type { ScatteredLight } from './multiple-scattering.ts';
import { type Columns, columnsToSpace } from './optical-depth.ts';
import { march, sunlightAt } from './ray-march.ts';

const WIDTH = 512;
const HEIGHT = 256;
const STEPS = 32;
/** Nodes of the table: elevations above and below the horizon, close to it, and azimuths from the sun. */
const ABOVE = 40;
const BELOW = 12;
const AZIMUTHS = 18;
const PARTS = 12;

/**
 * Airglow and starlight, which do not set: 174 microcandela per square metre (F. Falchi et al., 2016, "The new world atlas of
 * artificial night sky brightness").
 */
const NIGHT_LUMINANCE = 174e-6;

/**
 * What scatters along a line of sight changes slowly with it, the phase functions need not: they come last.
 *
 * @param elevation of the sun @param azimuth of it, from north by east, both in radians
 */
export function skyImage(
  air: Atmosphere,
  scattered: ScatteredLight,
  elevation: number,
  azimuth: number,
): EnvironmentMap {
  const straightOn = straightOnOf(air, elevation);
  const lines = Array.from({ length: BELOW + ABOVE }, (_, i) =>
    lineOfSight(air, scattered, elevationOf(i), elevation, straightOn),
  );
  const nodes = new Float64Array(PARTS * AZIMUTHS);
  const texels = new Float32Array(4 * WIDTH * HEIGHT);
  const places = Float64Array.from({ length: WIDTH }, (_, x) => azimuthAt(x) - azimuth);
  const cosines = places.map(Math.cos);
  const columns = cosines.map((cosine) => (Math.acos(cosine) / Math.PI) * (AZIMUTHS - 1));
  const [sunSine, sunCosine] = [Math.sin(elevation), Math.cos(elevation)];
  for (let y = 0; y < HEIGHT; y += 1) {
    const latitude = ((y + 0.5) / HEIGHT - 0.5) * Math.PI;
    const [line, part] = placeOf(latitude);
    for (let i = 0; i < nodes.length; i += 1)
      nodes[i] = lines[line]![i]! * (1 - part) + lines[line + 1]![i]! * part;
    const [sine, cosine] = [Math.sin(latitude), Math.cos(latitude)];
    for (let x = 0; x < WIDTH; x += 1) {
      const c = Math.min(Math.floor(columns[x]!), AZIMUTHS - 2);
      const t = columns[x]! - c;
      const towards = sine * sunSine + cosine * sunCosine * cosines[x]!;
      const [pr, pt, ps] = [rayleighPhase(towards), turningPhase(towards), straightPhase(towards)];
      const at = 4 * (y * WIDTH + x);
      const [a, b] = [PARTS * c, PARTS * (c + 1)];
      for (let k = 0; k < 3; k += 1) {
        const near = pr * nodes[a + k]! + pt * nodes[a + 3 + k]! + ps * nodes[a + 6 + k]! + nodes[a + 9 + k]!;
        const far = pr * nodes[b + k]! + pt * nodes[b + 3 + k]! + ps * nodes[b + 6 + k]! + nodes[b + 9 + k]!;
        const light = near * (1 - t) + far * t;
        // Colours that Rec. 709 lacks are clipped.
        texels[at + k] = Math.max(0, light) + (latitude > 0 ? NIGHT_LUMINANCE : 0);
      }
      texels[at + 3] = 1;
    }
  }
  return { texels, width: WIDTH, height: HEIGHT };
}

/**
 * The glow about the sun is what haze scatters straight on. For sums over all directions that light has not left the sun's beam
 * (src/scene/sky/atmosphere.ts); here it is all that has: 1 - exp(-x) of it, x being its optical depth towards the sun, of
 * which single scattering makes x.
 *
 * @returns by band, over what haze scatters otherwise
 */
function straightOnOf(air: Atmosphere, elevation: number): Float64Array {
  const columns: Columns = [0, 0, 0];
  columnsToSpace(EARTH_RADIUS + EYE_HEIGHT, Math.sin(elevation), columns);
  return air.hazeScattering.map((scattering, b) => {
    const depth = (scattering - air.hazeTurning[b]!) * columns[1];
    return depth > 0 ? (scattering / air.hazeTurning[b]!) * (-Math.expm1(-depth) / depth) : 0;
  });
}

/** Of a column's middle, from north (-z) by east (+x). */
function azimuthAt(x: number): number {
  const longitude = ((x + 0.5) / WIDTH - 0.5) * 2 * Math.PI;
  return Math.atan2(Math.cos(longitude), -Math.sin(longitude));
}

/** Of line `i` of the table. */
function elevationOf(i: number): number {
  if (i >= BELOW) return (Math.PI / 2) * ((i - BELOW) / (ABOVE - 1)) ** 2;
  return (-Math.PI / 2) * ((BELOW - 1 - i + 0.5) / (BELOW - 0.5)) ** 2;
}

/** The line before this elevation, and how far it is towards the next. Nothing is between sky and ground. */
function placeOf(elevation: number): [line: number, part: number] {
  const root = Math.sqrt(Math.abs(elevation) / (Math.PI / 2));
  const place =
    elevation >= 0 ? BELOW + root * (ABOVE - 1) : Math.min(BELOW - 0.5 - root * (BELOW - 0.5), BELOW - 1);
  const line = Math.min(Math.floor(place), elevation >= 0 ? BELOW + ABOVE - 2 : BELOW - 2);
  return [line, place - line];
}

/** For each azimuth from the sun four parts of light, each RGB: by air, by haze, straight on by haze, and all others. */
function lineOfSight(
  air: Atmosphere,
  scattered: ScatteredLight,
  elevation: number,
  sunElevation: number,
  straightOn: Float64Array,
): Float64Array {
  const radius = EARTH_RADIUS + EYE_HEIGHT;
  const sine = Math.sin(elevation);
  const { points, transmittance, length, meetsGround } = march(air, radius, sine, STEPS);
  const line = new Float64Array(PARTS * AZIMUTHS);
  const [rayleigh, haze, rest, light, mean] = Array.from({ length: 5 }, () => new Float64Array(BANDS)) as [
    Float64Array,
    Float64Array,
    Float64Array,
    Float64Array,
    Float64Array,
  ];
  for (let a = 0; a < AZIMUTHS; a += 1) {
    for (const sum of [rayleigh, haze, rest]) sum.fill(0);
    // The cosine of the angle between this line and the sun.
    const cosine =
      sine * Math.sin(sunElevation) +
      Math.cos(elevation) * Math.cos(sunElevation) * Math.cos((Math.PI * a) / (AZIMUTHS - 1));
    const sunAt = (distance: number, at: number) =>
      (radius * Math.sin(sunElevation) + distance * cosine) / at;
    for (const point of points) {
      const sun = sunAt(point.distance, point.radius);
      sunlightAt(air, point.radius, sun, light);
      scattered.mean(point.radius, sun, mean);
      for (let b = 0; b < BANDS; b += 1) {
        rayleigh[b] = rayleigh[b]! + light[b]! * point.rayleigh[b]!;
        haze[b] = haze[b]! + light[b]! * point.haze[b]!;
        rest[b] = rest[b]! + mean[b]! * (point.rayleigh[b]! + point.haze[b]!);
      }
    }
    if (meetsGround) {
      scattered.groundIrradiance(sunAt(length, EARTH_RADIUS), light);
      for (let b = 0; b < BANDS; b += 1)
        rest[b] = rest[b]! + (light[b]! * air.ground[b]! * transmittance[b]!) / Math.PI;
    }
    const straight = haze.map((value, b) => value * straightOn[b]!);
    line.set(
      [...rgbOfBands(rayleigh), ...rgbOfBands(haze), ...rgbOfBands(straight), ...rgbOfBands(rest)],
      PARTS * a,
    );
  }
  return line;
}
