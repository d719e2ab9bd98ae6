// Burley's GTR1 distribution: as GGX with an exponent of 1, hence a longer tail.
// B. Burley, 2012, "Physically-Based Shading at Disney", appendix B.2:
// D = (a^2 - 1) / (pi log(a^2) (1 + (a^2 - 1) (n.h)^2)).
::include lib/constants.glsl

// Its two factors, D(h) = GTR1_scale / GTR1_shape: one depends on the surface alone. h is a unit vector in the
// local frame; 0 < alpha < 1.
float GTR1_scale(float alpha) {
    float a2 = alpha * alpha;
    return (a2 - 1.0) / (PI * log(a2));
}

// 1 + (a^2 - 1)(n.h)^2 is written as sin^2 + a^2 cos^2: the textbook's form loses all its digits
// in float32 where alpha is small.
float GTR1_shape(vec3 h, float alpha) {
    return dot(h.xy, h.xy) + alpha * alpha * h.z * h.z;
}

// D(h)/divisor in one division beside the scale's.
float D_GTR1(vec3 h, float alpha, float divisor) {
    return GTR1_scale(alpha) / (GTR1_shape(h, alpha) * divisor);
}

// The divisor of Smith's masking for an isotropic GGX surface of roughness alpha, as in gtr2.glsl.
float G_SmithIsotropic(float NdotW, float alpha) {
    float a2 = alpha * alpha;
    return NdotW + sqrt(a2 + (1.0 - a2) * NdotW * NdotW);
}
