// What this rough mirror does not give back, for want of the light that bounces from facet to facet:
// gtr2.glsl, isotropic, with the masking of l and of v independent.
// Derived by tools/microfacet-albedo.ts; do not edit. A polynomial in alpha and y = mu/(mu + alpha), fitted to a
// quadrature; it errs by at most 0.0045, root mean square 0.0009.

// 1 - E, E the directional albedo at the cosine mu in 0..1 of facets that absorb nothing; alpha in .001..1.
float missingGTR2(float mu, float alpha) {
    float y = mu / (mu + alpha);
    float c0 = 0.061932171 + y * (0.22088514 + y * (0.87339522 + y * (-2.8581188 + y * (12.621408 + y * (-10.93078)))));
    float c1 = 0.051208345 + y * (-0.35086683 + y * (1.570744 + y * (2.6079206 + y * (-24.377402 + y * (23.566939)))));
    float c2 = 0.50010289 + y * (3.0328136 + y * (-4.4912765 + y * (22.431127 + y * (-1.6223195 + y * (29.36398)))));
    float c3 = -0.23489511 + y * (-1.1079983 + y * (-2.0660684 + y * (21.771964 + y * (-90.808508 + y * (71.934875)))));
    return max((1.0 - y) * (1.0 - y) * (c0 + alpha * (c1 + alpha * (c2 + alpha * (c3)))), 0.0);
}

// Its mean over the hemisphere, 2 times the integral of (1 - E) mu.
float missingMeanGTR2(float alpha) {
    return alpha * alpha * (3.7782683 + alpha * (-12.512494 + alpha * (29.453472 + alpha * (-43.052673 + alpha * (33.055972 + alpha * (-10.10287))))) + 0.0074858955 * log(alpha));
}
