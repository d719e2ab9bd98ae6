// The camera: a thin lens with a round or polygonal aperture.

vec3 cameraOrigin;
vec3 cameraDirection;

// A point of the unit disk, areas kept. P. Shirley and K. Chiu, 1997, "A Low Distortion Map Between Disk and Square".
vec2 diskPoint(vec2 u) {
  vec2 p = 2.0 * u - 1.0;
  if (p.x == 0.0 && p.y == 0.0) return vec2(0.0);
  bool isWide = abs(p.x) > abs(p.y);
  float r = isWide ? p.x : p.y;
  float phi = isWide ? 0.25 * PI * p.y / p.x : 0.5 * PI - 0.25 * PI * p.x / p.y;
  return r * vec2(cos(phi), sin(phi));
}

// A point of a regular polygon inside the unit disk.
vec2 polygonPoint(vec2 u, float corners, float rotation) {
  float sector = floor(u.x * corners);
  float rest = u.x * corners - sector;
  float r = sqrt(rest);
  float from = rotation + 2.0 * PI * sector / corners;
  float to = rotation + 2.0 * PI * (sector + 1.0) / corners;
  return r * mix(vec2(cos(from), sin(from)), vec2(cos(to), sin(to)), u.y);
}

// A ray through a place in the picture, in pixels from its upper left corner.
void cameraRay(vec2 place) {
  vec2 size = vec2(loadUint4(16).xy);
  vec4 position = loadFloat4(17);
  vec4 right = loadFloat4(18);
  vec4 up = loadFloat4(19);
  vec4 forward = loadFloat4(20);
  vec2 p = place / size * 2.0 - 1.0;
  vec3 d = forward.xyz + right.xyz * p.x - up.xyz * p.y;
  cameraOrigin = position.xyz;
  if (position.w > 0.0) {
    vec2 u = random2();
    vec2 lens = up.w >= 3.0 ? polygonPoint(u, up.w, forward.w) : diskPoint(u);
    vec3 focus = cameraOrigin + d * right.w;
    cameraOrigin += (normalize(right.xyz) * lens.x + normalize(up.xyz) * lens.y) * position.w;
    d = focus - cameraOrigin;
  }
  cameraDirection = normalize(d);
}
