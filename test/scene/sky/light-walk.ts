/**
 * Skylight by chance, to check the sky's table against: paths of light from the ground backwards through round air, however
 * often they are scattered, found by delta tracking (E. Woodcock et al., 1965).
 */
import { createRandom } from '../../../src/analysis/random.ts';
import { luminance } from '../../../src/color/rec709.ts';
import {
  type Atmosphere,
  bands,
  EARTH_RADIUS,
  HAZE_ANISOTROPY,
  hazeDensity,
  hazePhase,
  ozoneDensity,
  rayleighDensity,
  rayleighPhase,
  TOP_RADIUS,
} from '../../../src/scene/sky/atmosphere.ts';

type Vec3 = [number, number, number];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (o: Vec3, d: Vec3, t: number): Vec3 => [o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]];

/** Distance to a sphere about the Earth's middle; infinite where it is missed. */
function toSphere(o: Vec3, d: Vec3, radius: number, far: boolean): number {
  const b = dot(o, d);
  const root = b * b - dot(o, o) + radius * radius;
  if (root < 0) return Number.POSITIVE_INFINITY;
  const t = -b + (far ? 1 : -1) * Math.sqrt(root);
  return t > 0 ? t : Number.POSITIVE_INFINITY;
}

/** Optical depth to space by 60 steps, close together where it begins; infinite through the ground. */
function depthToSpace(air: Atmosphere, band: number, o: Vec3, d: Vec3): number {
  if (toSphere(o, d, EARTH_RADIUS - 0.5, false) < Number.POSITIVE_INFINITY) return Number.POSITIVE_INFINITY;
  const length = toSphere(o, d, TOP_RADIUS, true);
  let depth = 0;
  const steps = 60;
  for (let i = 0; i < steps; i++) {
    const [from, to] = [(i / steps) ** 2 * length, ((i + 1) / steps) ** 2 * length];
    const height = Math.sqrt(dot(along(o, d, (from + to) / 2), along(o, d, (from + to) / 2))) - EARTH_RADIUS;
    depth += extinctionAt(air, band, height) * (to - from);
  }
  return depth;
}

const extinctionAt = (air: Atmosphere, b: number, height: number): number =>
  air.rayleigh[b]! * rayleighDensity(height) +
  air.hazeExtinction[b]! * hazeDensity(height) +
  air.ozone[b]! * ozoneDensity(height);

/**
 * What the sky, without the sun's disc, gives a level plane on the ground, in lx.
 *
 * @param elevation of the sun in radians
 */
export function skylightByChance(air: Atmosphere, elevation: number, paths: number): number {
  const random = createRandom(7);
  const sun: Vec3 = [Math.cos(elevation), Math.sin(elevation), 0];
  const power = bands.map(({ sun: rgb }) => luminance(rgb));
  let sum = 0;
  for (let i = 0; i < paths; i++) {
    const band = i % bands.length;
    const [u, v] = [random(), 2 * Math.PI * random()];
    let d: Vec3 = [Math.sqrt(u) * Math.cos(v), Math.sqrt(1 - u), Math.sqrt(u) * Math.sin(v)];
    let o: Vec3 = [0, EARTH_RADIUS + 2, 0];
    // Extinction is nowhere greater than on the ground, but for the ozone above.
    const most = extinctionAt(air, band, 0) + air.ozone[band]!;
    let weight = Math.PI * power[band]!;
    let found = 0;
    for (let bounces = 0; bounces < 60; ) {
      const ground = toSphere(o, d, EARTH_RADIUS, false);
      const end = Math.min(ground, toSphere(o, d, TOP_RADIUS, true));
      // Rays climb out of dense air: the bound falls with them, layer by layer.
      let t = 0;
      let hit = false;
      for (;;) {
        t -= Math.log(1 - random()) / most;
        if (t >= end) break;
        const p = along(o, d, t);
        if (random() * most < extinctionAt(air, band, Math.sqrt(dot(p, p)) - EARTH_RADIUS)) {
          hit = true;
          break;
        }
      }
      if (!hit && ground === Number.POSITIVE_INFINITY) break;
      bounces++;
      o = along(o, d, hit ? t : end);
      const radius = Math.sqrt(dot(o, o));
      if (!hit) {
        const n = o.map((x) => x / radius) as Vec3;
        o = along([0, 0, 0], n, EARTH_RADIUS + 0.1);
        weight *= air.ground[band]!;
        if (weight === 0) break;
        const cosine = dot(n, sun);
        if (cosine > 0) found += (weight * cosine * Math.exp(-depthToSpace(air, band, o, sun))) / Math.PI;
        d = cosineDirection(n, random);
        continue;
      }
      const height = radius - EARTH_RADIUS;
      const rayleigh = air.rayleigh[band]! * rayleighDensity(height);
      const haze = air.hazeScattering[band]! * hazeDensity(height);
      weight *= (rayleigh + haze) / extinctionAt(air, band, height);
      const isHaze = random() * (rayleigh + haze) < haze;
      const cosine = dot(d, sun);
      const phase = (rayleigh * rayleighPhase(cosine) + haze * hazePhase(cosine)) / (rayleigh + haze);
      found += weight * phase * Math.exp(-depthToSpace(air, band, o, sun));
      // Half of haze's directions by Henyey and Greenstein, which is close to it, and half evenly.
      const next = isHaze && random() < 0.5 ? hgDirection(d, random) : evenDirection(random);
      const c = dot(d, next);
      weight *= isHaze
        ? hazePhase(c) / (0.5 * hgPhase(c) + 0.5 / (4 * Math.PI))
        : rayleighPhase(c) * 4 * Math.PI;
      d = next;
      if (bounces > 8) {
        const survival = Math.min(0.9, weight / (Math.PI * power[band]!));
        if (random() >= survival) break;
        weight /= survival;
      }
    }
    sum += found;
  }
  return (sum / paths) * bands.length;
}

function hgPhase(cosine: number): number {
  const g = HAZE_ANISOTROPY;
  return (1 - g * g) / (4 * Math.PI * (1 + g * g - 2 * g * cosine) ** 1.5);
}

function hgDirection(d: Vec3, random: () => number): Vec3 {
  const g = HAZE_ANISOTROPY;
  const s = (1 - g * g) / (1 - g + 2 * g * random());
  return about(d, (1 + g * g - s * s) / (2 * g), 2 * Math.PI * random());
}

const evenDirection = (random: () => number): Vec3 =>
  about([0, 1, 0], 1 - 2 * random(), 2 * Math.PI * random());
const cosineDirection = (n: Vec3, random: () => number): Vec3 =>
  about(n, Math.sqrt(random()), 2 * Math.PI * random());

/** The direction at this cosine to an axis. */
function about(axis: Vec3, cosine: number, angle: number): Vec3 {
  const sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
  const helper: Vec3 = Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const x: Vec3 = [
    helper[1] * axis[2] - helper[2] * axis[1],
    helper[2] * axis[0] - helper[0] * axis[2],
    helper[0] * axis[1] - helper[1] * axis[0],
  ];
  const length = Math.sqrt(dot(x, x));
  const u = x.map((value) => value / length) as Vec3;
  const v: Vec3 = [
    axis[1] * u[2] - axis[2] * u[1],
    axis[2] * u[0] - axis[0] * u[2],
    axis[0] * u[1] - axis[1] * u[0],
  ];
  return axis.map(
    (value, i) => cosine * value + sine * (Math.cos(angle) * u[i]! + Math.sin(angle) * v[i]!),
  ) as Vec3;
}
