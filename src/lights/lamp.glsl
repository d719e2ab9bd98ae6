// A point or spot light as a row of numbers (lamp-row.ts): its irradiance on what faces it, E = I(l) f_dist(r).
// @param L a unit vector to the lamp
vec3 lampIrradiance(vec3 L, float inverseDistance, vec4 power, vec4 axis, vec4 edge) {
  float r2 = 1.0 / (inverseDistance * inverseDistance);
  float window = max(1.0 - r2 * r2 * power.w, 0.0);
  float falloff = (edge.w * inverseDistance + edge.z) * inverseDistance + (1.0 - edge.z - edge.w);
  float cosTheta = -dot(axis.xyz, L);
  float t = clamp((cosTheta - axis.w) * edge.y, 0.0, 1.0);
  // The least positive base keeps pow(0, 0) out, which is undefined.
  float beam = pow(max(cosTheta, 1e-6), edge.x) * t * t * (3.0 - 2.0 * t);
  return power.xyz * (falloff * window * window * beam);
}
