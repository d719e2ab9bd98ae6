/**
 * Photometric units, and the colour of heated bodies.
 *
 * A light's own unit is what the shading equation wants: cd for point and spot lights, lx for directional
 * ones, nits (cd/m^2) for surfaces. People know lamps by their luminous flux in lm.
 */
import { transform } from '../color/matrix.ts';
import { luminance, XYZ_TO_RGB } from '../color/rec709.ts';

/** Luminous flux in lm of a point light of this intensity in cd: it shines into 4 pi sr. */
export function pointFlux(intensity: number): number {
  return 4 * Math.PI * intensity;
}

/** Intensity in cd of a point light of this flux in lm. */
export function pointIntensity(flux: number): number {
  return flux / (4 * Math.PI);
}

/**
 * The solid angle in sr that a spot light's beam I_max cos^s would fill at I_max: the integral of cos^s
 * over theta <= angle, 2 pi (1 - cos^(s+1)(angle)) / (s + 1). The penumbra is not counted.
 *
 * @param angle the cut-off in radians, up to pi/2
 */
export function spotSolidAngle(angle: number, exponent: number): number {
  return (2 * Math.PI * (1 - Math.max(Math.cos(angle), 0) ** (exponent + 1))) / (exponent + 1);
}

/** Luminous flux in lm of a spot light of this I_max in cd. */
export function spotFlux(intensity: number, angle: number, exponent: number): number {
  return intensity * spotSolidAngle(angle, exponent);
}

/** I_max in cd of a spot light of this flux in lm. */
export function spotIntensity(flux: number, angle: number, exponent: number): number {
  return flux / spotSolidAngle(angle, exponent);
}

/** Luminous flux in lm of a one-sided Lambertian surface of this luminance in nits and area in m^2. */
export function surfaceFlux(luminance: number, area: number): number {
  return Math.PI * area * luminance;
}

/** Luminance in nits of such a surface of this flux in lm. */
export function surfaceLuminance(flux: number, area: number): number {
  return flux / (Math.PI * area);
}

/** The range of temperatureColor(), in K. */
export const TEMPERATURE_RANGE = [1667, 25000] as const;

/**
 * Linear Rec. 709 of a black body, with its luminance Y = .2126 R + .7152 G + .0722 B scaled to 1, so that
 * a light keeps its photometric strength when its temperature changes.
 *
 * The chromaticity is the cubic spline of B. Kang et al., 2002, "Design of Advanced Color Temperature
 * Control System for HDTV Applications", J. Korean Physical Society 41(6), equations 8 and 9, whose range is
 * 1667 to 25000 K; other temperatures are clamped. Components outside Rec. 709 are clipped at 0.
 */
export function temperatureColor(kelvin: number): [number, number, number] {
  const t = Math.min(Math.max(kelvin, TEMPERATURE_RANGE[0]), TEMPERATURE_RANGE[1]);
  const x =
    t <= 4000
      ? -0.2661239e9 / t ** 3 - 0.2343589e6 / t ** 2 + 0.8776956e3 / t + 0.17991
      : -3.0258469e9 / t ** 3 + 2.1070379e6 / t ** 2 + 0.2226347e3 / t + 0.24039;
  const y =
    t <= 2222
      ? -1.1063814 * x ** 3 - 1.3481102 * x ** 2 + 2.18555832 * x - 0.20219683
      : t <= 4000
        ? -0.9549476 * x ** 3 - 1.37418593 * x ** 2 + 2.09137015 * x - 0.16748867
        : 3.081758 * x ** 3 - 5.8733867 * x ** 2 + 3.75112997 * x - 0.37001483;
  const rgb = transform(XYZ_TO_RGB, [x / y, 1, (1 - x - y) / y]).map((c) => Math.max(0, c));
  const [r, g, b] = rgb as [number, number, number];
  const Y = luminance([r, g, b]);
  return [r / Y, g / Y, b / Y];
}
