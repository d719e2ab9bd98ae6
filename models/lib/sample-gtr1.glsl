// Sampling of GTR1: h with the density D(h) (n.h).
// B. Burley, 2012, "Physically-Based Shading at Disney", appendix B.2, equation 5:
//   cos^2(theta) = (1 - (a^2)^(1-u)) / (1 - a^2)

// A microfacet normal in the local frame. u in 0..1; circle = (cos, sin) of the azimuth; 0 < alpha < 1.
// The sine comes first: 1 - cos^2 has no digits left where alpha is small.
vec3 sampleGTR1(float u, vec2 circle, float alpha) {
    float a2 = alpha * alpha;
    float sinSquared = clamp((exp(log(a2) * (1.0 - u)) - a2) / (1.0 - a2), 0.0, 1.0);
    return vec3(circle * sqrt(sinSquared), sqrt(1.0 - sinSquared));
}
