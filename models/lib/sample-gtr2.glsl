// Sampling of the GGX normals that v sees, by spherical caps.
// J. Dupuy and A. Benyoub, 2023, "Sampling Visible GGX Normals with Spherical Caps",
// Computer Graphics Forum 42(8), listing 3; the density of E. Heitz, 2014, "Understanding the
// Masking-Shadowing Function", JCGT 3(2), equation 16.
::include lib/gtr2.glsl

// A microfacet normal. v and the result are in the local frame, v.z > 0; u in 0..1;
// circle = (cos, sin) of the azimuth.
vec3 sampleVisibleGTR2(float u, vec2 circle, vec3 v, vec2 alpha) {
    vec3 stretched = normalize(vec3(v.xy * alpha, v.z));
    float z = (1.0 - u) * (1.0 + stretched.z) - stretched.z;
    vec3 cap = vec3(circle * sqrt(max(1.0 - z * z, 0.0)), z) + stretched;
    return normalize(vec3(cap.xy * alpha, max(cap.z, 1e-6)));
}

// The density in 1/sr of the reflection of v about such a normal h:
// G1(v) (v.h) D(h) / (n.v) / (4 v.h) with G1(v) = 2 (n.v)/G_SmithGTR2(v).
float pdfVisibleGTR2(vec3 h, vec3 v, vec2 alpha) {
    return 0.5 * D_GTR2(h, alpha, G_SmithGTR2(v, alpha));
}
