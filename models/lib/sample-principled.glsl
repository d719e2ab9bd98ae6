// Sampling of the principled model, both forms: one of three lobes is drawn, then a direction from it.
// weights = (diffuse with sheen, specular, clearcoat), adding up to 1, specular > 0;
// directions are in the local frame; coatAlpha = clearcoatAlpha(clearcoatGloss).
::include lib/half-vector.glsl
::include lib/principled-model.glsl
::include lib/sample-cosine.glsl
::include lib/sample-gtr1.glsl
::include lib/sample-gtr2.glsl
::include lib/gtr1.glsl

// A direction; its z is negative or 0 where the sample went below the surface, and is lost.
vec3 samplePrincipled(vec2 u, vec3 v, vec3 weights, vec2 alpha, float coatAlpha) {
    vec2 circle = unitCircle(u.y);
    // u.x chooses the lobe and, stretched back to 0..1, serves a second time. Specular is last,
    // because its weight alone is never 0.
    float t = u.x;
    if (t < weights.x) return sampleCosine(t / weights.x, circle);
    t -= weights.x;
    vec3 h;
    if (t < weights.z) {
        h = sampleGTR1(t / weights.z, circle, coatAlpha);
    } else {
        h = sampleVisibleGTR2(min((t - weights.z) / weights.y, 1.0), circle, v, alpha);
    }
    float VdotH = dot(v, h);
    if (VdotH <= 0.0) return vec3(0.0);
    return 2.0 * VdotH * h - v;
}

// The density in 1/sr with which samplePrincipled gives l: the mean of the three lobes' own.
float pdfPrincipled(vec3 l, vec3 v, vec3 weights, vec2 alpha, float coatAlpha) {
    float LdotH = halfCosine(l, v);
    vec3 h = halfVector(l, v, LdotH);
    float density = weights.x * l.z * INV_PI + weights.y * pdfVisibleGTR2(h, v, alpha);
    if (weights.z > 0.0) density += weights.z * h.z * D_GTR1(h, coatAlpha, 4.0 * LdotH);
    return density;
}

// The mean of the three channels of a colour.
float meanOf(vec2 weights) {
    return weights.x + weights.y * dot(baseColor, vec3(1.0 / 3.0));
}

// The probabilities of the lobes (diffuse with sheen, specular, clearcoat): by their estimated
// albedos. The 1e-6 keeps a surface that is black in every way from dividing by 0.
vec3 lobeWeights(float NdotV) {
    float weight = F_SchlickWeight(NdotV) + F_SCHLICK_MEAN;
    vec3 albedo = vec3(
        meanOf(vec2(0.0, PI * baseWeight()) + sheenColor() * weight),
        meanOf(specularFresnel(weight)) + 1e-6,
        CLEARCOAT_STRENGTH * clearcoat * F_Schlick(CLEARCOAT_R0, weight));
    return albedo / (albedo.x + albedo.y + albedo.z);
}

vec3 sampleL(vec2 u, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 v = toFrame(V, N, X, Y);
    if (v.z < HORIZON) return vec3(0.0);
    vec3 l = samplePrincipled(u, v, lobeWeights(v.z),
        principledAlpha(roughness, anisotropic), clearcoatAlpha(clearcoatGloss));
    return sampledDirection(l, N, X, Y);
}

float pdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (belowHorizon(l, v)) return 0.0;
    return pdfPrincipled(l, v, lobeWeights(v.z),
        principledAlpha(roughness, anisotropic), clearcoatAlpha(clearcoatGloss));
}
