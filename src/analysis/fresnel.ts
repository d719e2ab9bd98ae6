/** How much light a smooth boundary between air and a substance reflects. All unpolarised, shares of 0..1. */
import type { OpticalConstants } from './substances/substance.ts';

/**
 * Fresnel's equations for a complex index of refraction n + i k (M. Born and E. Wolf, 1999, "Principles of Optics",
 * 7th edition, section 14.2; in this real form S. Lagarde, 2013, "Memo on Fresnel equations").
 *
 * @param cosine of the angle of incidence, 0..1
 */
export function fresnel(cosine: number, [n, k]: OpticalConstants): number {
  const cos2 = cosine * cosine;
  const sin2 = 1 - cos2;
  const difference = n * n - k * k - sin2;
  // a^2 + b^2 of the refracted wave's component along the normal, a + i b.
  const sum = Math.hypot(difference, 2 * n * k);
  const a = Math.sqrt(Math.max(0, (sum + difference) / 2));
  // Without a boundary, n = 1, grazing light makes both sums 0.
  const perpendicular = (sum + cos2 - 2 * a * cosine) / (sum + cos2 + 2 * a * cosine || 1);
  const along = cos2 * sum + sin2 * sin2;
  const across = 2 * a * cosine * sin2;
  const parallel = (perpendicular * (along - across)) / (along + across);
  return (perpendicular + parallel) / 2;
}

/** C. Schlick, 1994, "An Inexpensive BRDF Model for Physically-based Rendering", equation 15. */
export function schlick(cosine: number, f0: number): number {
  return f0 + (1 - f0) * (1 - cosine) ** 5;
}
