/** The directional albedo over theta_v, one angle at a time, so that who asks can draw what is there. */
import { directionalAlbedo } from '../albedo.ts';
import { direction } from '../vector.ts';
import { type Curve, type CurvePoint, type Reflectance, type Rgb, radians } from './curve.ts';

/** At 90 degrees n.v is 0 and most models are 0/0 or 0; 89 is where the curve ends. */
const LAST = 89;
const STEP = 3;

/** Estimated absolute error: what a plot can show. */
const TOLERANCE = 5e-4;
const MOST_EVALUATIONS = 10_000;

export const albedoAngles: readonly number[] = [
  ...Array.from({ length: Math.ceil(LAST / STEP) }, (_, i) => i * STEP),
  LAST,
];

export function albedoAt(f: Reflectance, thetaV: number, phiV: number): CurvePoint {
  const v = direction(Math.cos(radians(thetaV)), radians(phiV));
  const { value } = directionalAlbedo(f, v, { tolerance: TOLERANCE, maxEvaluations: MOST_EVALUATIONS });
  return { angle: thetaV, rgb: value as unknown as Rgb };
}

/** The points so far, in the order of their angles; first far apart, then between. */
export function* albedoCurve(f: Reflectance, phiV: number): Generator<Curve> {
  const points: CurvePoint[] = [];
  for (const angle of coarseFirst(albedoAngles)) {
    points.push(albedoAt(f, angle, phiV));
    points.sort((a, b) => a.angle - b.angle);
    yield [...points];
  }
}

function coarseFirst<T>(items: readonly T[]): T[] {
  const ordered = new Set<T>([items.at(-1) as T]);
  for (let stride = 16; stride >= 1; stride /= 2) {
    for (let i = 0; i < items.length; i += stride) ordered.add(items[i] as T);
  }
  return [...ordered];
}
