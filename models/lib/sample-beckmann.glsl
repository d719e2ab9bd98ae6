// Sampling of Beckmann's distribution: h with the density D(h) (n.h).
// B. Walter et al., 2007, "Microfacet Models for Refraction through Rough Surfaces",
// equations 28 and 29: tan^2(theta) = -r^2 log(1 - u).
::include lib/beckmann.glsl

// A microfacet normal in the local frame. u in 0..1; circle = (cos, sin) of the azimuth.
vec3 sampleBeckmann(float u, vec2 circle, float r) {
    // The clamp only matters for u = 1, where the logarithm has no value.
    float tanSquared = -r * r * log(max(1.0 - u, 1e-30));
    float cosTheta = inversesqrt(1.0 + tanSquared);
    return vec3(circle * (cosTheta * sqrt(tanSquared)), cosTheta);
}
