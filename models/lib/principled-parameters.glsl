// From the principled model's parameters, all 0..1, to the widths of its lobes.
// B. Burley, 2012, "Physically-Based Shading at Disney", sections 5.4 to 5.6 and appendix B.
::include lib/schlick.glsl
::include lib/gtr1.glsl

// (alpha_x, alpha_y) of the specular lobe. alpha = roughness^2 makes the slider even to the eye;
// .9 limits the highlight's aspect ratio to 10:1; .001 keeps the lobe wider than a float32 unit
// vector's rounding. Values of anisotropic above 1 act as 1.
vec2 principledAlpha(float roughness, float anisotropic) {
    float aspectSquared = max(1.0 - 0.9 * anisotropic, 0.1);
    float inverseAspect = inversesqrt(aspectSquared);
    float alpha = roughness * roughness;
    return max(alpha * vec2(inverseAspect, aspectSquared * inverseAspect), vec2(0.001));
}

// alpha of the clearcoat's distribution: .1 (satin) to .001 (gloss). Far outside 0..1 gloss would
// leave the range in which GTR1 has a value.
float clearcoatAlpha(float gloss) {
    return clamp(mix(0.1, 0.001, gloss), 0.001, 0.9);
}

// alpha of the clearcoat's masking, and its reflectance at normal incidence (ior 1.5); fixed.
const float CLEARCOAT_MASKING_ALPHA = 0.25;
const float CLEARCOAT_R0 = 0.04;
// The most that the clearcoat weighs.
const float CLEARCOAT_STRENGTH = 0.25;

// The clearcoat's D F G/(4 (n.l) (n.v)) times its strength, from local directions.
float clearcoatReflectance(float strength, vec3 l, vec3 v, vec3 h, float weightH, float gloss) {
    float divisor = G_SmithIsotropic(l.z, CLEARCOAT_MASKING_ALPHA)
        * G_SmithIsotropic(v.z, CLEARCOAT_MASKING_ALPHA);
    float alpha = clearcoatAlpha(gloss);
    return strength * GTR1_scale(alpha) * (F_Schlick(CLEARCOAT_R0, weightH) / (GTR1_shape(h, alpha) * divisor));
}
