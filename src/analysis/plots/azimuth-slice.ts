/**
 * Over the azimuth: flat for an isotropic model under a half vector that turns, and what an anisotropic one does
 * along and across its scratches. The light turns at a fixed theta_l, or the half vector at fixed theta_h, theta_d.
 */
import { direction, type Vec3 } from '../vector.ts';
import {
  type Curve,
  type CurvePoint,
  HORIZON,
  type Reflectance,
  type Rgb,
  radians,
  reflected,
} from './curve.ts';
import { directionsFrom } from './half-difference.ts';

/** What turns about the normal. */
export const turning = ['light', 'half'] as const;
export type Turning = (typeof turning)[number];

/** Degrees. */
export interface AzimuthOptions {
  readonly turns: Turning;
  readonly thetaL: number;
  readonly thetaH: number;
  readonly thetaD: number;
  readonly thetaV: number;
  readonly phiV: number;
  readonly cosine: boolean;
}

const STEP = 1.5;

function azimuthDirections(phi: number, options: AzimuthOptions): { l: Vec3; v: Vec3 } {
  const { turns, thetaL, thetaH, thetaD, thetaV, phiV } = options;
  if (turns === 'half') {
    return directionsFrom({
      thetaH: radians(thetaH),
      phiH: radians(phi),
      thetaD: radians(thetaD),
      phiD: Math.PI / 2,
    });
  }
  return {
    l: direction(Math.cos(radians(thetaL)), radians(phi)),
    v: direction(Math.cos(radians(thetaV)), radians(phiV)),
  };
}

/** @param phi degrees */
export function azimuthSliceAt(f: Reflectance, phi: number, options: AzimuthOptions): CurvePoint {
  const { l, v } = azimuthDirections(phi, options);
  return { angle: phi, rgb: reflected(f, l, v, options.cosine) };
}

export function azimuthSlice(f: Reflectance, options: AzimuthOptions): Curve {
  return Array.from({ length: 360 / STEP + 1 }, (_, i) => azimuthSliceAt(f, i * STEP, options));
}

/** The map's value: phi to the right from 0 to 360 degrees, theta of the light or the half vector upwards. */
export function azimuthMapAt(f: Reflectance, x: number, y: number, options: AzimuthOptions): Rgb {
  const theta = HORIZON * y;
  const at = options.turns === 'half' ? { ...options, thetaH: theta } : { ...options, thetaL: theta };
  return azimuthSliceAt(f, 360 * x, at).rgb;
}
