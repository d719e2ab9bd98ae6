// The half vector h = (l + v)/|l + v| of two unit vectors that are not opposite.

// l.h = v.h = |l + v|/2: never negative, unlike the dot product, which loses its digits where l is
// close to -v.
float halfCosine(vec3 L, vec3 V) {
    return 0.5 * length(L + V);
}

// h, given l.h.
vec3 halfVector(vec3 L, vec3 V, float LdotH) {
    return (L + V) * (0.5 / LdotH);
}
