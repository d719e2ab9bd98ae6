// Burley's diffuse reflection and its subsurface variant, both without the factor baseColor/pi.
// B. Burley, 2012, "Physically-Based Shading at Disney", section 5.3.
// weightL, weightV = (1 - n.l)^5, (1 - n.v)^5; LdotH = l.h; roughness in 0..1.

// The product of two Fresnel-like factors that both laws share: from 1 at normal incidence to
// f90 at grazing incidence.
float Fd_GrazingFactor(float weightL, float weightV, float f90) {
    return (1.0 + (f90 - 1.0) * weightL) * (1.0 + (f90 - 1.0) * weightV);
}

// Diffuse reflection: .5 at grazing angles when smooth, up to 2.5 for a rough
// surface that is seen from the light (retro-reflection).
float Fd_Burley(float weightL, float weightV, float LdotH, float roughness) {
    return Fd_GrazingFactor(weightL, weightV, 0.5 + 2.0 * LdotH * LdotH * roughness);
}

// Light that was scattered below the surface, after the Hanrahan-Krueger model of an isotropic
// medium (the paper names it, disney.brdf has it): 1.25 roughly preserves the albedo.
// shape is what the two forms of the model differ in: 1/(n.l + n.v) for Burley's.
float Fd_Subsurface(float weightL, float weightV, float LdotH, float roughness, float shape) {
    float fss = Fd_GrazingFactor(weightL, weightV, LdotH * LdotH * roughness);
    return 1.25 * (fss * (shape - 0.5) + 0.5);
}
