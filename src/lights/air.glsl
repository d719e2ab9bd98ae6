// Fog: how much of it is on a way, and how it scatters. The interactive renderer and the path tracer share this text.
// All of it is within a sphere about the scene. Its density is even, or falls by e with every `scale` metres above its
// base; lengths through it are in metres of fog as dense as at the base.

// Where a ray is in the sphere (xyz, radius): from x to y, y < x if nowhere.
vec2 airSegment(vec4 sphere, vec3 o, vec3 d, float far) {
  vec3 toCentre = sphere.xyz - o;
  float along = dot(toCentre, d);
  float half2 = sphere.w * sphere.w - dot(toCentre, toCentre) + along * along;
  if (half2 <= 0.0) return vec2(1.0, 0.0);
  float half1 = sqrt(half2);
  return vec2(max(along - half1, 0.0), min(along + half1, far));
}

// Density over that at the base. @param y above the base  @param scale 0 where it is even
float airDensity(float y, float scale) {
  return scale > 0.0 && y > 0.0 ? exp(-y / scale) : 1.0;
}

// Length through fog of a way that begins at the height y and rises by `slope` per metre.
float airLength(float y, float slope, float way, float scale) {
  if (scale <= 0.0 || way <= 0.0) return max(way, 0.0);
  float end = y + slope * way;
  float low = min(y, end);
  float high = max(y, end);
  float below = high <= 0.0 ? way : low >= 0.0 ? 0.0 : way * (-low / (high - low));
  float above = way - below;
  float x = above * abs(slope) / scale;
  // (1 - e^-x) / x, by its series where the difference would lose its digits.
  float mean = x < 0.01 ? 1.0 - x * (0.5 - x / 6.0) : (1.0 - exp(-x)) / x;
  return below + above * exp(-max(low, 0.0) / scale) * mean;
}

// The way from the height y that has this length through fog; 1e30 if none is as long.
float airWay(float y, float slope, float length_, float scale) {
  if (scale <= 0.0) return length_;
  float start = 0.0;
  float rest = length_;
  if (y <= 0.0) {
    if (slope <= 0.0 || rest * slope <= -y) return rest;
    start = -y / slope;
    rest -= start;
  }
  // In the thinning part: rest = e^(-y/scale) (1 - e^(-slope way / scale)) scale / slope.
  float thin = rest * exp(min(max(y, 0.0) / scale, 80.0));
  float z = thin * slope / scale;
  if (z >= 1.0) return 1e30;
  float way = thin * (abs(z) < 0.01 ? 1.0 + z * (0.5 + z / 3.0) : -log(1.0 - z) / z);
  if (slope >= 0.0 || y <= 0.0 || y + slope * way >= 0.0) return start + way;
  // Down to the base, and on in what is even below it.
  float down = -y / slope;
  return down + rest - airLength(y, slope, down, scale);
}

// L. G. Henyey and J. L. Greenstein, 1941: the density in 1/sr of scattering by an angle. g > 0 is forward.
float phase(float cosine, float g) {
  float base = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (12.566370614359172 * base * sqrt(base));
}
