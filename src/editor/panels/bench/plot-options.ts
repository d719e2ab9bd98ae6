/** The settings of a pane as each computation takes them: the same for the worker and for the probe. */
import type { AzimuthOptions } from '../../../analysis/plots/azimuth-slice.ts';
import type { ImageSliceOptions } from '../../../analysis/plots/image-slice.ts';
import type { LightSliceOptions } from '../../../analysis/plots/light-slice.ts';
import type { LitOptions } from '../../../analysis/plots/lit-picture.ts';
import type { BenchSettings } from './settings.ts';

export function lightOptions({ thetaV, phiV, cosine }: BenchSettings): LightSliceOptions {
  return { thetaV, phiV, cosine };
}

export function azimuthOptions(settings: BenchSettings): AzimuthOptions {
  const { turns, thetaL, thetaH, thetaD, thetaV, phiV, cosine } = settings;
  return { turns, thetaL, thetaH, thetaD, thetaV, phiV, cosine };
}

/** phi_d = 90 degrees: there l and v are above the surface for every theta_h and theta_d. */
export function imageOptions({ cosine, squareRoot }: BenchSettings): ImageSliceOptions {
  return { phiD: 90, cosine, squareRoot };
}

export function litOptions({ thetaV, phiV, thetaL, phiL, doubleTheta }: BenchSettings): LitOptions {
  return { thetaV, phiV, thetaL, phiL, doubleTheta };
}
