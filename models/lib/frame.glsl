// The local frame: x along the tangent, y along the bitangent, z along the normal.
// N, X and Y must be orthonormal.
::include lib/constants.glsl

// The coordinates of the direction W in the frame.
vec3 toFrame(vec3 W, vec3 N, vec3 X, vec3 Y) {
    return vec3(dot(W, X), dot(W, Y), dot(W, N));
}

// The direction with the coordinates w in the frame.
vec3 fromFrame(vec3 w, vec3 N, vec3 X, vec3 Y) {
    return w.x * X + w.y * Y + w.z * N;
}

// What a sampler returns for the direction l of the frame: it, or 0 where it went below the surface.
vec3 sampledDirection(vec3 l, vec3 N, vec3 X, vec3 Y) {
    return l.z < HORIZON ? vec3(0.0) : fromFrame(l, N, X, Y);
}
