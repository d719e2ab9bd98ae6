// Homogeneous fog, which fills the scene's bounding sphere.

// Where a ray is in the fog: from x to y, y < x if nowhere.
vec2 fogSegment(vec3 o, vec3 d, float far) {
  vec4 sphere = loadFloat4(6);
  vec3 toCentre = sphere.xyz - o;
  float along = dot(toCentre, d);
  float half2 = sphere.w * sphere.w - dot(toCentre, toCentre) + along * along;
  if (half2 <= 0.0) return vec2(1.0, 0.0);
  float half1 = sqrt(half2);
  return vec2(max(along - half1, 0.0), min(along + half1, far));
}

float fogTransmittance(vec3 o, vec3 d, float far) {
  float extinction = loadFloat4(7).x;
  if (extinction == 0.0) return 1.0;
  vec2 segment = fogSegment(o, d, far);
  return exp(-extinction * max(segment.y - segment.x, 0.0));
}

// L. G. Henyey and J. L. Greenstein, 1941: the density in 1/sr of scattering by an angle. g > 0 is forward.
float phase(float cosine, float g) {
  float base = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (4.0 * PI * base * sqrt(base));
}

vec3 samplePhase(vec2 u, vec3 d, float g) {
  float s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u.x);
  float cosine = abs(g) < 1e-3 ? 1.0 - 2.0 * u.x : clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 X = anyTangent(d);
  vec3 Y = cross(d, X);
  return X * (sine * cos(2.0 * PI * u.y)) + Y * (sine * sin(2.0 * PI * u.y)) + d * cosine;
}
