// Sampling of Lambert's law: l with the density (n.l)/pi (Malley's method: a point spread evenly
// over the unit disc, lifted to the hemisphere).
::include lib/constants.glsl

// A direction in the local frame. u in 0..1; circle = (cos, sin) of the azimuth.
vec3 sampleCosine(float u, vec2 circle) {
    return vec3(circle * sqrt(u), sqrt(1.0 - u));
}

// (cos, sin) of the azimuth 2 pi u: the second half of every sampling here.
vec2 unitCircle(float u) {
    float phi = 2.0 * PI * u;
    return vec2(cos(phi), sin(phi));
}
