// Fresnel's equations for the boundary of two dielectrics, unpolarised light.
// A. Fresnel, 1823; as in M. Pharr, W. Jakob and G. Humphreys, 2023, "Physically Based Rendering", equation 9.6.
::include lib/constants.glsl

// The cosine of the refracted direction, by Snell's law; 0 where light is reflected totally.
// cosine: of the incident direction; ior: of the far side over the near side.
float refractedCosine(float cosine, float ior) {
    return sqrt(max(1.0 - (1.0 - cosine * cosine) / (ior * ior), 0.0));
}

// The share of light that is reflected, 0..1.
float F_Dielectric(float cosine, float ior) {
    float c = clamp(cosine, 0.0, 1.0);
    float t = refractedCosine(c, ior);
    if (t <= 0.0) return 1.0;
    // With ior = 1 there is no boundary; at a grazing angle both quotients would be 0/0.
    float parallel = (ior * c - t) / (ior * c + t);
    float perpendicular = (c - ior * t) / (c + ior * t);
    return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}
