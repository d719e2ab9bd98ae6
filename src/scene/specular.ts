/**
 * What a dielectric reflects head-on, as reflectance, as index of refraction, and as `specular` of Burley's model and of the
 * thesis's.
 */

/** `specular` 1 is a reflectance of 8 % at normal incidence (B. Burley, 2012, section 5.2). */
const SPECULAR_SCALE = 0.08;

/** @param reflectance at normal incidence, 0..1 */
export const specularOfReflectance = (reflectance: number): number => reflectance / SPECULAR_SCALE;

/** At normal incidence. */
export const reflectanceOfSpecular = (specular: number): number => SPECULAR_SCALE * specular;

/** At normal incidence, of a smooth boundary of air and a body of that index of refraction (Fresnel). */
export const reflectanceOfIor = (ior: number): number => ((ior - 1) / (ior + 1)) ** 2;

/** `specular` of such a body. */
export const specularOf = (ior: number): number => specularOfReflectance(reflectanceOfIor(ior));

/** The index of refraction of a dielectric with that `specular`, the inverse of specularOf(). */
export function iorOf(specular: number): number {
  const amplitude = Math.sqrt(reflectanceOfSpecular(specular));
  return (1 + amplitude) / (1 - amplitude);
}

/** The index of refraction that `specular` stands for in models/principled-thesis.brdf. */
export const iorOfThesisSpecular = (specular: number): number => 1 + 0.8 * specular;
