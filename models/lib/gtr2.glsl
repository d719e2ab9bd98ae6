// The anisotropic GGX (Trowbridge-Reitz) microfacet surface, which Burley calls GTR2.
// alpha = (alpha_x, alpha_y), both > 0: the roughness along the tangent and the bitangent.
// Directions are in the local frame (frame.glsl).
::include lib/constants.glsl

// D(h)/divisor in one division, h a unit vector.
// B. Burley, 2012, "Physically-Based Shading at Disney", appendix B.2:
//   D = 1 / (pi ax ay ((h.x/ax)^2 + (h.y/ay)^2 + (h.n)^2)^2)
// here with numerator and denominator times (ax ay)^4, so that nothing is divided by alpha.
float D_GTR2(vec3 h, vec2 alpha, float divisor) {
    float area = alpha.x * alpha.y;
    vec3 s = vec3(h.xy * alpha.yx, h.z * area);
    float t = dot(s, s);
    return (area * area * area * INV_PI) / (t * t * divisor);
}

// The divisor of Smith's masking for this surface: G1(w) = 2 (n.w) / G_SmithGTR2(w), so that
// G/(4 (n.l) (n.v)) = 1 / (G_SmithGTR2(l) G_SmithGTR2(v)): the masking of l and of v
// taken as independent. Between n.w and 2 for alpha <= 1.
// B. Walter et al., 2007, "Microfacet Models for Refraction through Rough Surfaces", equation
// 34; anisotropic in E. Heitz, 2014, "Understanding the Masking-Shadowing Function", JCGT 3(2),
// equations 72 and 86.
float G_SmithGTR2(vec3 w, vec2 alpha) {
    return w.z + length(vec3(w.xy * alpha, w.z));
}
