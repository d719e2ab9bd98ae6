/** How much air, haze and ozone is on the way out to space, from any height in any direction: tabulated once for all skies. */
import {
  EARTH_RADIUS,
  hazeDensity,
  ozoneDensity,
  rayleighDensity,
  SUN_ANGULAR_RADIUS,
  TOP_RADIUS,
} from './atmosphere.ts';

const HEIGHTS = 64;
const COSINES = 160;
const STEPS = 64;
/** From the ground to where a ray along it leaves the air. */
const TO_TOP = Math.sqrt(TOP_RADIUS ** 2 - EARTH_RADIUS ** 2);

/** Distance to the sphere of this radius from within. @param radius of the place @param cosine of the zenith angle */
export function distanceToTop(radius: number, cosine: number): number {
  return -radius * cosine + Math.sqrt(Math.max(0, TOP_RADIUS ** 2 - radius ** 2 * (1 - cosine * cosine)));
}

/** Distance to the ground; infinite where a ray misses it. */
export function distanceToGround(radius: number, cosine: number): number {
  const root = EARTH_RADIUS ** 2 - radius ** 2 * (1 - cosine * cosine);
  if (cosine >= 0 || root < 0) return Number.POSITIVE_INFINITY;
  return Math.max(0, -radius * cosine - Math.sqrt(root));
}

/** The cosine of the zenith angle of the horizon. */
const horizonCosine = (radius: number): number => -Math.sqrt(Math.max(0, 1 - (EARTH_RADIUS / radius) ** 2));

/** Metres of sea-level air, of haze as dense as at the ground, of ozone as dense as at its peak. */
export type Columns = [rayleigh: number, haze: number, ozone: number];

/** Of a ray that leaves the air, step by step. */
export function columnsAlong(radius: number, cosine: number): Columns {
  const length = distanceToTop(radius, cosine);
  const sum: Columns = [0, 0, 0];
  // Short steps where the ray begins: that is where the air is, but for rays that first go down a little.
  for (let i = 0; i < STEPS; i += 1) {
    const [from, to] = [i, i + 1].map((k) => length * (k / STEPS) ** 2) as [number, number];
    const t = (from + to) / 2;
    const height = Math.sqrt(radius * radius + t * t + 2 * radius * cosine * t) - EARTH_RADIUS;
    sum[0] += rayleighDensity(height) * (to - from);
    sum[1] += hazeDensity(height) * (to - from);
    sum[2] += ozoneDensity(height) * (to - from);
  }
  return sum;
}

let table: Float64Array | null = null;

/** Both coordinates as E. Bruneton and F. Neyret, 2008, "Precomputed Atmospheric Scattering": fine about the horizon. */
function fill(): Float64Array {
  const values = new Float64Array(HEIGHTS * COSINES * 3);
  for (let i = 0; i < HEIGHTS; i += 1) {
    const rho = (i / (HEIGHTS - 1)) * TO_TOP;
    const radius = Math.sqrt(rho * rho + EARTH_RADIUS ** 2);
    const least = TOP_RADIUS - radius;
    for (let j = 0; j < COSINES; j += 1) {
      const distance = least + (j / (COSINES - 1)) * (rho + TO_TOP - least);
      const cosine =
        distance === 0 ? 1 : (TOP_RADIUS ** 2 - radius ** 2 - distance ** 2) / (2 * radius * distance);
      values.set(columnsAlong(radius, Math.min(1, cosine)), 3 * (i * COSINES + j));
    }
  }
  return values;
}

/** Of a ray that leaves the air; one that meets the ground counts as the one along the horizon. */
export function columnsToSpace(radius: number, cosine: number, out: Columns): void {
  table ??= fill();
  const rho = Math.sqrt(Math.max(0, radius * radius - EARTH_RADIUS ** 2));
  const least = TOP_RADIUS - radius;
  const distance = distanceToTop(radius, Math.max(cosine, horizonCosine(radius)));
  const x = Math.min(rho / TO_TOP, 1) * (HEIGHTS - 1);
  const y = Math.min(Math.max((distance - least) / (rho + TO_TOP - least || 1), 0), 1) * (COSINES - 1);
  const i = Math.min(Math.floor(x), HEIGHTS - 2);
  const j = Math.min(Math.floor(y), COSINES - 2);
  const [u, v] = [x - i, y - j];
  const a = 3 * (i * COSINES + j);
  const b = a + 3 * COSINES;
  for (let k = 0; k < 3; k += 1) {
    const near = table[a + k]! * (1 - v) + table[a + 3 + k]! * v;
    const far = table[b + k]! * (1 - v) + table[b + 3 + k]! * v;
    out[k] = near * (1 - u) + far * u;
  }
}

/** The part of the sun's disc that is above the horizon. @param cosine of the zenith angle of its middle */
export function sunAboveHorizon(radius: number, cosine: number): number {
  const above = Math.acos(horizonCosine(radius)) - Math.acos(Math.min(1, Math.max(-1, cosine)));
  const x = Math.min(1, Math.max(-1, above / SUN_ANGULAR_RADIUS));
  return 0.5 + (x * Math.sqrt(1 - x * x) + Math.asin(x)) / Math.PI;
}
