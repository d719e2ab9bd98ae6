// Refraction through a rough boundary of GGX facets.
// B. Walter et al., 2007, "Microfacet Models for Refraction through Rough Surfaces", equations 16, 17 and 21.
// Directions are in the local frame: v.z > 0, l.z < 0; ior is that of the far side over the near side.
::include lib/gtr2.glsl
::include lib/fresnel-dielectric.glsl

// The facets' normal that refracts v into l, on the side of v; 0 if there is none.
vec3 refractingNormal(vec3 l, vec3 v, float ior) {
    vec3 h = v + ior * l;
    float length2 = dot(h, h);
    if (length2 < 1e-12) return vec3(0.0);
    h *= inversesqrt(length2);
    h = h.z < 0.0 ? -h : h;
    // Both directions must see the facet from their own side.
    return dot(v, h) > 0.0 && dot(l, h) < 0.0 ? h : vec3(0.0);
}

// |v.h| |l.h| / (v.h + ior l.h)^2: how facets near h spread the light. Of radiance: it is ior^2 times less dense on the
// side of v, which takes the ior^2 of equation 21 away.
float refractionSpread(float VdotH, float LdotH, float ior) {
    float s = VdotH + ior * LdotH;
    return -VdotH * LdotH / max(s * s, 1e-12);
}

// f in 1/sr of light that comes through, with the masking of l and v taken as independent; without colour.
float refractedGTR2(vec3 l, vec3 v, float ior, vec2 alpha) {
    vec3 h = refractingNormal(l, v, ior);
    if (h.z <= 0.0) return 0.0;
    float VdotH = dot(v, h);
    float LdotH = dot(l, h);
    float smith = G_SmithGTR2(vec3(l.xy, -l.z), alpha) * G_SmithGTR2(v, alpha);
    // D G (v.h)(l.h)/((n.v)(n.l)) with G = 4 (n.l)(n.v)/smith.
    return 4.0 * (1.0 - F_Dielectric(VdotH, ior)) * refractionSpread(VdotH, LdotH, ior) * D_GTR2(h, alpha, smith);
}

// v refracted by a facet of normal h, or 0 where it is reflected totally.
vec3 refractAt(vec3 v, vec3 h, float ior) {
    float VdotH = dot(v, h);
    float t = refractedCosine(VdotH, ior);
    if (t <= 0.0) return vec3(0.0);
    return (VdotH / ior - t) * h - v / ior;
}

// The density in 1/sr of refractAt() with h drawn from the normals that v sees (sample-gtr2.glsl).
float pdfRefractedGTR2(vec3 l, vec3 v, float ior, vec2 alpha) {
    vec3 h = refractingNormal(l, v, ior);
    if (h.z <= 0.0) return 0.0;
    // G1(v) D(h) (v.h)/(n.v) dh/dl with G1(v) = 2 (n.v)/smith and dh/dl = ior^2 |l.h|/(v.h + ior l.h)^2.
    return 2.0 * ior * ior * refractionSpread(dot(v, h), dot(l, h), ior) * D_GTR2(h, alpha, G_SmithGTR2(v, alpha));
}
