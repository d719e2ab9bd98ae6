/**
 * The roughness whose microfacets are spread as those of Phong's exponent s: alpha = sqrt(2 / (s + 2)), roughness = sqrt(alpha).
 * B. Walter et al., 2007, "Microfacet Models for Refraction through Rough Surfaces", below equation 32, for Blinn-Phong.
 */
export const phongRoughness = (exponent: number): number => (2 / (Math.max(0, exponent) + 2)) ** 0.25;
