// What this rough mirror does not give back, for want of the light that bounces from facet to facet:
// beckmann.glsl with the masking of v-cavity.glsl.
// Derived by tools/microfacet-albedo.ts; do not edit. A polynomial in alpha and y = mu/(mu + alpha), fitted to a
// quadrature; it errs by at most 0.0118, root mean square 0.0019.

// 1 - E, E the directional albedo at the cosine mu in 0..1 of facets that absorb nothing; alpha in .001..1.
float missingBeckmann(float mu, float alpha) {
    float y = mu / (mu + alpha);
    float c0 = 0.011315957 + y * (-0.41770011 + y * (7.2451587 + y * (-39.746994 + y * (108.27942 + y * (-125.14696 + y * (49.225152))))));
    float c1 = -0.12113135 + y * (2.4918366 + y * (-14.57218 + y * (65.258774 + y * (-215.43595 + y * (312.87322 + y * (-150.54024))))));
    float c2 = 0.71682425 + y * (-10.053517 + y * (3.6039436 + y * (99.068154 + y * (-91.968538 + y * (179.72191 + y * (-257.46341))))));
    float c3 = -1.7600669 + y * (22.757344 + y * (4.8798564 + y * (-173.48851 + y * (-170.76429 + y * (154.48247 + y * (63.792259))))));
    float c4 = 1.9020911 + y * (-25.224749 + y * (19.738279 + y * (82.644455 + y * (136.46839 + y * (242.90623 + y * (170.42452))))));
    float c5 = -0.75897241 + y * (11.284932 + y * (-27.898825 + y * (33.625447 + y * (-41.898566 + y * (-177.48263 + y * (-260.35719))))));
    return max((1.0 - y) * (1.0 - y) * (c0 + alpha * (c1 + alpha * (c2 + alpha * (c3 + alpha * (c4 + alpha * (c5)))))), 0.0);
}

// Its mean over the hemisphere, 2 times the integral of (1 - E) mu.
float missingMeanBeckmann(float alpha) {
    return alpha * alpha * (0.61948186 + alpha * (-0.34913761 + alpha * (-1.2923501 + alpha * (5.506283 + alpha * (-7.1286864 + alpha * (2.9850436))))) + 0.013537176 * log(alpha));
}
