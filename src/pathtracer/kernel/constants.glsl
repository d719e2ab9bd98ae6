// Numbers that the whole kernel shares.
const float PI = 3.14159265358979;
const float INV_PI = 0.318309886183791;
const float INFINITY = 1e30;
const uint NONE = 0xffffffffu;

// Luminance of linear Rec. 709, ITU-R BT.709.
float luminance(vec3 color) {
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

float largest(vec3 color) {
  return max(color.x, max(color.y, color.z));
}

// A unit vector orthogonal to the unit vector N. T. Duff et al., 2017, "Building an Orthonormal Basis,
// Revisited", JCGT 6(1), listing 3.
vec3 anyTangent(vec3 N) {
  float s = N.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (s + N.z);
  return vec3(1.0 + s * N.x * N.x * a, s * N.x * N.y * a, -s * N.x);
}

// The density of one of two estimators over that of both: the balance heuristic (E. Veach, 1997, section 9.2.2).
float balance(float density, float other) {
  return density / (density + other);
}
