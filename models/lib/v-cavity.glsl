// Shadowing and masking by V-shaped grooves.
// K. E. Torrance and E. M. Sparrow, 1967, "Theory for Off-Specular Reflection From Roughened
// Surfaces"; as in R. L. Cook and K. E. Torrance, 1982, "A Reflectance Model for Computer
// Graphics", ACM TOG 1(1), the equation for G.

// G in 0..1: the share of a facet that is both lit and seen. All cosines > 0; v.h = l.h.
float G_VCavity(float NdotL, float NdotV, float NdotH, float VdotH) {
    return min(1.0, 2.0 * NdotH * min(NdotV, NdotL) / VdotH);
}
