// The principled model, but for what its two forms differ in. The file that includes this one has
// the model's parameters and three functions of its own:
//   vec2 tinted(float amount)                         white that turns into the tint, amount in 0..1
//   float subsurfaceShape(float NdotL, float NdotV)   the term of f_subsurface that depends on it
//   vec2 specularFresnel(float weight)                F of the specular lobe, with its colours
// B. Burley, 2012, "Physically-Based Shading at Disney", section 5, and disney.brdf by the same author.
//
// Every colour of the model lies between white and baseColor. So a colour is computed as a pair of
// numbers, (the weight of white, the weight of baseColor), and only the sum of all lobes is made RGB.
//
// No lobe is skipped where its weight is 0: the few operations that a branch would save cost less
// than the branch (a software GPU took 67 ns for BRDF() without, 89 ns with the four that were here).
::include lib/constants.glsl
::include lib/frame.glsl
::include lib/half-vector.glsl
::include lib/schlick.glsl
::include lib/diffuse-burley.glsl
::include lib/gtr2.glsl
::include lib/missing-gtr2.glsl
::include lib/multiple-scattering.glsl
::include lib/principled-parameters.glsl

vec3 toColor(vec2 weights) {
    return vec3(weights.x) + weights.y * baseColor;
}

// The factor of the base, beside baseColor.
float baseWeight() {
    return INV_PI * (1.0 - metallic);
}

float diffuse(float weightL, float weightV, float LdotH) {
    return baseWeight() * Fd_Burley(weightL, weightV, LdotH, roughness);
}

float scattering(vec3 l, vec3 v, float weightL, float weightV, float LdotH) {
    return baseWeight() * Fd_Subsurface(weightL, weightV, LdotH, roughness, subsurfaceShape(l.z, v.z));
}

vec2 sheenColor() {
    return ((1.0 - metallic) * sheen) * tinted(sheenTint);
}

// D G / (4 (n.l)(n.v)).
float reflection(vec3 l, vec3 v, vec3 h) {
    vec2 alpha = principledAlpha(roughness, anisotropic);
    return D_GTR2(h, alpha, G_SmithGTR2(l, alpha) * G_SmithGTR2(v, alpha));
}

float coat(vec3 l, vec3 v, vec3 h, float weightH) {
    return clearcoatReflectance(CLEARCOAT_STRENGTH * clearcoat, l, v, h, weightH, clearcoatGloss);
}

bool belowHorizon(vec3 l, vec3 v) {
    return min(l.z, v.z) < HORIZON;
}

vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    float LdotH = halfCosine(l, v);
    vec3 h = halfVector(l, v, LdotH);
    float weightL = F_SchlickWeight(l.z);
    float weightV = F_SchlickWeight(v.z);
    float weightH = F_SchlickWeight(LdotH);

    float base = mix(diffuse(weightL, weightV, LdotH), scattering(l, v, weightL, weightV, LdotH), subsurface);
    return toColor(vec2(coat(l, v, h, weightH), base)
        + specularFresnel(weightH) * reflection(l, v, h)
        + sheenColor() * weightH);
}

// What the specular facets reflect to one another before it leaves. An anisotropic surface counts as the round one
// of the same area of facets.
vec3 facetToFacet(vec3 l, vec3 v) {
    vec2 alpha = principledAlpha(roughness, anisotropic);
    float mean = sqrt(alpha.x * alpha.y);
    return multipleScattering(missingGTR2(l.z, mean), missingGTR2(v.z, mean), missingMeanGTR2(mean),
        toColor(specularFresnel(0.0)));
}

vec3 multipleScatteringLobe(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    return facetToFacet(l, v);
}

// BRDF() and that: a white metal gives back all light, however rough.
vec3 withMultipleScattering(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    return BRDF(L, V, N, X, Y) + multipleScatteringLobe(L, V, N, X, Y);
}

vec3 diffuseLobe(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    float base = diffuse(F_SchlickWeight(l.z), F_SchlickWeight(v.z), halfCosine(l, v));
    return toColor(vec2(0.0, (1.0 - subsurface) * base));
}

vec3 subsurfaceLobe(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    float base = scattering(l, v, F_SchlickWeight(l.z), F_SchlickWeight(v.z), halfCosine(l, v));
    return toColor(vec2(0.0, subsurface * base));
}

vec3 specularLobe(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    float LdotH = halfCosine(l, v);
    return toColor(specularFresnel(F_SchlickWeight(LdotH)) * reflection(l, v, halfVector(l, v, LdotH)));
}

vec3 sheenLobe(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    if (belowHorizon(toFrame(L, N, X, Y), toFrame(V, N, X, Y))) return vec3(0.0);
    return toColor(sheenColor() * F_SchlickWeight(halfCosine(L, V)));
}

vec3 clearcoatLobe(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    float LdotH = halfCosine(l, v);
    return vec3(coat(l, v, halfVector(l, v, LdotH), F_SchlickWeight(LdotH)));
}

// D(h) in 1/sr: how many facets look along h.
vec3 distribution(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    return vec3(D_GTR2(halfVector(l, v, halfCosine(l, v)), principledAlpha(roughness, anisotropic), 1.0));
}

// F(l.h) in 0..1: the share of light that a facet reflects.
vec3 fresnel(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    if (belowHorizon(toFrame(L, N, X, Y), toFrame(V, N, X, Y))) return vec3(0.0);
    return toColor(specularFresnel(F_SchlickWeight(halfCosine(L, V))));
}

// G(l, v) in 0..1: the share of the facets that is both lit and seen.
vec3 masking(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    vec2 alpha = principledAlpha(roughness, anisotropic);
    return vec3(4.0 * l.z * v.z / (G_SmithGTR2(l, alpha) * G_SmithGTR2(v, alpha)));
}

// G1(v, h) in 0..1, L being h: the share of the facets along h that is seen. Smith's is the same for all of them.
vec3 viewMasking(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(toFrame(L, N, X, Y), v)) return vec3(0.0);
    return vec3(2.0 * v.z / G_SmithGTR2(v, principledAlpha(roughness, anisotropic)));
}

// The clearcoat's D(h) in 1/sr.
vec3 clearcoatDistribution(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return vec3(0.0);
    return vec3(D_GTR1(halfVector(l, v, halfCosine(l, v)), clearcoatAlpha(clearcoatGloss), 1.0));
}
