// Light that bounces from facet to facet before it leaves: what D F G leaves out.
// C. Kulla and A. Conty, 2017, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH course: a lobe that gives
// back what is missing, spread so that it is reciprocal.
::include lib/constants.glsl
::include lib/schlick.glsl

// f in 1/sr of facets with Schlick's reflectance f0. missingL, missingV: 1 - E at the cosines of l and v; missingMean
// > 0: the mean of 1 - E over the hemisphere. At f0 = 1 nothing is lost any more; the colour deepens with each bounce.
vec3 multipleScattering(float missingL, float missingV, float missingMean, vec3 f0) {
    vec3 F = F_Schlick(f0, F_SCHLICK_MEAN);
    vec3 share = F * F * ((1.0 - missingMean) / (vec3(1.0) - F * missingMean));
    return share * (missingL * missingV * INV_PI / missingMean);
}
