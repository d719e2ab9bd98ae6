// The local frame: x along the tangent, y along the bitangent, z along the normal.
// N, X and Y must be orthonormal.

// The coordinates of the direction W in the frame.
vec3 toFrame(vec3 W, vec3 N, vec3 X, vec3 Y) {
    return vec3(dot(W, X), dot(W, Y), dot(W, N));
}

// The direction with the coordinates w in the frame.
vec3 fromFrame(vec3 w, vec3 N, vec3 X, vec3 Y) {
    return w.x * X + w.y * Y + w.z * N;
}
