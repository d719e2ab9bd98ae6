/** The colour of what a smooth surface of a substance reflects, in linear Rec. 709. */
import type { WhiteLight } from '../../color/light.ts';
import { reflectanceColor } from '../../color/spectrum.ts';
import { fresnel, schlick } from '../fresnel.ts';
import type { Rgb } from '../plots/curve.ts';
import { opticalConstants, type Substance } from './substance.ts';

/** By Fresnel's equations at every wavelength; may leave 0..1 a little, as saturated colours do. */
export function reflectedColor(substance: Substance, cosine: number, light?: WhiteLight): Rgb {
  return reflectanceColor((nm) => fresnel(cosine, opticalConstants(substance, nm)), light);
}

/** The same by Schlick's approximation of each channel from the colour at normal incidence. */
export function schlickColor(f0: Rgb, cosine: number): Rgb {
  return f0.map((c) => schlick(cosine, c)) as unknown as Rgb;
}

export interface SchlickError {
  /** The largest absolute difference in any channel. */
  readonly error: number;
  /** Where it is, in degrees. */
  readonly angle: number;
}

/** The worst that Schlick's approximation does to a substance, of angles every half degree. */
export function worstSchlickError(substance: Substance, light?: WhiteLight): SchlickError {
  const f0 = reflectedColor(substance, 1, light);
  let worst: SchlickError = { error: 0, angle: 0 };
  for (let angle = 0; angle <= 90; angle += 0.5) {
    const cosine = Math.max(0, Math.cos((angle * Math.PI) / 180));
    const approximate = schlickColor(f0, cosine);
    const exact = reflectedColor(substance, cosine, light);
    const error = Math.max(...exact.map((c, i) => Math.abs(c - (approximate[i] as number))));
    if (error > worst.error) worst = { error, angle };
  }
  return worst;
}
