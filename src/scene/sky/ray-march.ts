/** Sunlight on its way through the air, and what is scattered along a line of sight. */
import {
  type Atmosphere,
  BANDS,
  EARTH_RADIUS,
  hazeDensity,
  ozoneDensity,
  rayleighDensity,
} from './atmosphere.ts';
import {
  type Columns,
  columnsToSpace,
  distanceToGround,
  distanceToTop,
  sunAboveHorizon,
} from './optical-depth.ts';

/** What comes through all the air between a place and space. */
function transmittanceToSpace(air: Atmosphere, radius: number, cosine: number, out: Float64Array): void {
  columnsToSpace(radius, cosine, columns);
  const [r, h, o] = columns;
  for (let b = 0; b < BANDS; b += 1)
    out[b] = Math.exp(-(air.rayleigh[b]! * r + air.hazeDimming[b]! * h + air.ozone[b]! * o));
}
const columns: Columns = [0, 0, 0];

/** What the sun sends to a place, of each band 1 outside the air. */
export function sunlightAt(air: Atmosphere, radius: number, cosine: number, out: Float64Array): void {
  const visible = sunAboveHorizon(radius, cosine);
  if (visible <= 0) {
    out.fill(0);
    return;
  }
  transmittanceToSpace(air, radius, cosine, out);
  for (let b = 0; b < BANDS; b += 1) out[b] = out[b]! * visible;
}

/** Points along a ray with what reaches its beginning of what is scattered there. */
export interface March {
  readonly distance: number;
  readonly radius: number;
  /** Scattering there times the way's transmittance times the length of the step, by band. */
  readonly rayleigh: Float64Array;
  readonly haze: Float64Array;
}

/** @returns the points, and the transmittance of the whole ray */
export function march(
  air: Atmosphere,
  radius: number,
  cosine: number,
  steps: number,
): { points: March[]; transmittance: Float64Array; length: number; meetsGround: boolean } {
  const ground = distanceToGround(radius, cosine);
  const meetsGround = ground < Number.POSITIVE_INFINITY;
  const length = meetsGround ? ground : distanceToTop(radius, cosine);
  const transmittance = new Float64Array(BANDS).fill(1);
  const points: March[] = [];
  for (let i = 0; i < steps; i += 1) {
    const [from, to] = [i, i + 1].map((k) => length * (k / steps) ** 2) as [number, number];
    const distance = (from + to) / 2;
    const at = Math.sqrt(radius * radius + distance * distance + 2 * radius * cosine * distance);
    const height = at - EARTH_RADIUS;
    const [r, h, o] = [rayleighDensity(height), hazeDensity(height), ozoneDensity(height)];
    const rayleigh = new Float64Array(BANDS);
    const haze = new Float64Array(BANDS);
    for (let b = 0; b < BANDS; b += 1) {
      const extinction = air.rayleigh[b]! * r + air.hazeDimming[b]! * h + air.ozone[b]! * o;
      const through = Math.exp(-extinction * (to - from));
      // The integral of the transmittance over the step, the air within it being even.
      const reach = transmittance[b]! * (extinction > 1e-12 ? (1 - through) / extinction : to - from);
      rayleigh[b] = air.rayleigh[b]! * r * reach;
      haze[b] = air.hazeTurning[b]! * h * reach;
      transmittance[b] = transmittance[b]! * through;
    }
    points.push({ distance, radius: at, rayleigh, haze });
  }
  return { points, transmittance, length, meetsGround };
}
