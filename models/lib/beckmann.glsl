// Beckmann's distribution of microfacet normals.
// P. Beckmann and A. Spizzichino, 1963, "The Scattering of Electromagnetic Waves from Rough
// Surfaces"; as in R. L. Cook and K. E. Torrance, 1982, "A Reflectance Model for Computer
// Graphics", ACM TOG 1(1), the equation for D, with the 1/pi that makes it a density (B. Walter
// et al., 2007, "Microfacet Models for Refraction through Rough Surfaces", equation 25):
//   D(h) = exp(-tan^2 / r^2) / (pi r^2 cos^4)
// r is the root mean square slope of the facets, > 0: .001 is a mirror, 1 is very rough.
::include lib/constants.glsl

// D(h)/divisor. NdotH > 0 is the cosine of the angle between h and n, sinSquared the square of its
// sine: taken apart, because cos^2 - 1 of the textbook's exponent loses all its digits in float32
// where r is small.
float D_Beckmann(float NdotH, float sinSquared, float r, float divisor) {
    // The clamp keeps 0/0 away where h is almost tangent: there D is 0 anyway, for any r up to 100.
    float cosSquared = max(NdotH * NdotH, 1e-8);
    float slopeSquared = r * r;
    return exp(-sinSquared / (cosSquared * slopeSquared))
        / (PI * slopeSquared * cosSquared * cosSquared * divisor);
}
