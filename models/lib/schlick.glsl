// Fresnel reflectance after Schlick.
// Christophe Schlick, 1994, "An Inexpensive BRDF Model for Physically-based Rendering",
// Computer Graphics Forum 13(3), equation 15: F = R0 + (1 - R0) (1 - u)^5, u = l.h.
::include lib/constants.glsl

// The mean of (1 - u)^5 over the cosine-weighted hemisphere:
// 2 * integral of (1 - u)^5 u du over 0..1 = 2 B(2, 6) = 1/21.
const float F_SCHLICK_MEAN = 1.0 / 21.0;

// (1 - u)^5, from 1 at u = 0 (grazing) to 0 at u = 1. The clamp keeps a cosine that rounding
// took just above 1 from giving a negative weight.
float F_SchlickWeight(float u) {
    float m = max(1.0 - u, 0.0);
    float m2 = m * m;
    return m2 * m2 * m;
}

// The reflectance, from r0 at weight 0 to 1 at weight 1; weight = F_SchlickWeight(l.h).
float F_Schlick(float r0, float weight) {
    return r0 + (1.0 - r0) * weight;
}

vec3 F_Schlick(vec3 r0, float weight) {
    return r0 + (vec3(1.0) - r0) * weight;
}

// R0, the reflectance at normal incidence, of the boundary between air and a dielectric with
// the index of refraction ior >= 1 (Fresnel's equations at angle 0): 0 at 1, .04 at 1.5, .11 at 2.
float F_R0(float ior) {
    return sqr((ior - 1.0) / (ior + 1.0));
}
