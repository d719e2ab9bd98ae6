/** White light by its spectrum: what a reflectance is looked at under. */
import { CIE_1931, WAVELENGTHS } from './cie-1931.ts';

/**
 * D65: daylight, the white of Rec. 709. E: the same power at all wavelengths. A: a tungsten lamp, as a black body
 * of 2856 K.
 */
export const LIGHTS = ['D65', 'E', 'A'] as const;
export type WhiteLight = (typeof LIGHTS)[number];

/** Relative power per nm at each of WAVELENGTHS. */
export function lightSpectrum(light: WhiteLight): readonly number[] {
  switch (light) {
    case 'D65':
      return CIE_1931.map(([, , , power]) => power);
    case 'E':
      return CIE_1931.map(() => 1);
    case 'A':
      return WAVELENGTHS.map(illuminantA);
  }
}

/** CIE standard illuminant A, 100 at 560 nm: CIE 015:2018. Its 2848 K belong to the constant c2 of 1931. */
function illuminantA(nm: number): number {
  const planck = (length: number) => 1 / (length ** 5 * Math.expm1(1.435e7 / (2848 * length)));
  return (100 * planck(nm)) / planck(560);
}
