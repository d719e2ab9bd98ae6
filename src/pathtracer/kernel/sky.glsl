// Light from everywhere: the environment map, ambient and hemisphere lights, as one.

vec2 directionToMap(vec3 d, vec4 shape) {
  // Turned back by the rotation about y.
  float x = shape.y * d.x - shape.z * d.z;
  float z = shape.z * d.x + shape.y * d.z;
  return vec2(atan(z, x) * (0.5 * INV_PI) + 0.5, asin(clamp(d.y, -1.0, 1.0)) * INV_PI + 0.5);
}

vec3 mapToDirection(vec2 uv, vec4 shape) {
  float latitude = (uv.y - 0.5) * PI;
  float longitude = (uv.x - 0.5) * 2.0 * PI;
  float x = cos(longitude) * cos(latitude);
  float z = sin(longitude) * cos(latitude);
  return vec3(shape.y * x + shape.z * z, sin(latitude), shape.y * z - shape.z * x);
}

// The environment map's radiance.
vec3 mapRadiance(int sky, vec3 d) {
  uvec4 image = loadUint4(sky);
  if (image.x == 0u) return vec3(0.0);
  vec4 shape = loadFloat4(sky + 2);
  vec2 uv = directionToMap(d, shape);
  // Around the axis the map repeats, at the poles it ends.
  vec2 place = uv * vec2(float(image.x), float(image.y)) - 0.5;
  vec2 base = floor(place);
  vec2 t = place - base;
  int width = int(image.x);
  int x0 = (int(base.x) + width) % width;
  int x1 = (x0 + 1) % width;
  int y0 = int(image.z) + clamp(int(base.y), 0, int(image.y) - 1) * width;
  int y1 = int(image.z) + clamp(int(base.y) + 1, 0, int(image.y) - 1) * width;
  // A sky has a sharp horizon: between ground and sky there is nothing.
  if (image.w != 0u && int(base.y) + 1 == int(image.y) / 2) t.y = d.y > 0.0 ? 1.0 : 0.0;
  vec3 low = mix(loadFloat4(y0 + x0).xyz, loadFloat4(y0 + x1).xyz, t.x);
  vec3 high = mix(loadFloat4(y1 + x0).xyz, loadFloat4(y1 + x1).xyz, t.x);
  return mix(low, high, t.y) * shape.x;
}

// All of it.
vec3 skyRadiance(vec3 d) {
  int sky = int(loadUint4(2).z);
  if (sky == 0) return vec3(0.0);
  return mapRadiance(sky, d) + loadFloat4(d.y > 0.0 ? 4 : 5).xyz;
}

// The disc of the sky's sun, which shines as a light of its own: it is seen, not found by chance.
vec3 sunDisc(vec3 d) {
  vec4 sun = loadFloat4(10);
  if (sun.w == 0.0 || d.y <= 0.0 || dot(d, sun.xyz) <= 0.0) return vec3(0.0);
  // The sine of the angle to its middle over that of its edge.
  float sine = length(cross(d, sun.xyz)) / sun.w;
  if (sine >= 1.0) return vec3(0.0);
  return loadFloat4(11).xyz * pow(vec3(sqrt(1.0 - sine * sine)), loadFloat4(12).xyz);
}

// What the camera sees behind the scene.
vec3 backgroundRadiance(vec3 d) {
  vec4 background = loadFloat4(3);
  if (background.w == 0.0) return background.xyz;
  int sky = int(loadUint4(2).z);
  return (sky == 0 ? vec3(0.0) : mapRadiance(sky, d)) + sunDisc(d);
}

// The density of sampleSky() in a cell, in 1/sr. @param marginal the distribution of its rows
float skyDensity(int x, int y, uvec4 grid, int marginal, float cosLatitude) {
  int row = int(grid.w + uint(y) * (grid.x + 1u));
  float inRow = (loadFloat(row + x + 1) - loadFloat(row + x)) * float(grid.x);
  float ofRow = (loadFloat(marginal + y + 1) - loadFloat(marginal + y)) * float(grid.y);
  return inRow * ofRow / max(2.0 * PI * PI * cosLatitude, 1e-9);
}

float skyPdf(vec3 d) {
  int sky = int(loadUint4(2).z);
  uvec4 grid = loadUint4(sky + 1);
  vec2 uv = directionToMap(d, loadFloat4(sky + 2));
  int x = clamp(int(uv.x * float(grid.x)), 0, int(grid.x) - 1);
  int y = clamp(int(uv.y * float(grid.y)), 0, int(grid.y) - 1);
  return skyDensity(x, y, grid, int(grid.z), sqrt(max(1.0 - d.y * d.y, 0.0)));
}

float skySampleDensity;

// A direction by a distribution of the sky's rows, and within a row by its luminance; its density goes to skySampleDensity.
vec3 sampleSkyRows(int marginal, vec2 u) {
  int sky = int(loadUint4(2).z);
  uvec4 grid = loadUint4(sky + 1);
  int y = findCell(marginal, int(grid.y), u.y);
  int row = int(grid.w + uint(y) * (grid.x + 1u));
  int x = findCell(row, int(grid.x), u.x);
  float low = loadFloat(row + x);
  float width = loadFloat(row + x + 1) - low;
  float bottom = loadFloat(marginal + y);
  float height = loadFloat(marginal + y + 1) - bottom;
  vec2 uv = vec2(
    (float(x) + (width > 0.0 ? (u.x - low) / width : 0.5)) / float(grid.x),
    (float(y) + (height > 0.0 ? (u.y - bottom) / height : 0.5)) / float(grid.y));
  vec3 d = mapToDirection(uv, loadFloat4(sky + 2));
  skySampleDensity = skyDensity(x, y, grid, marginal, sqrt(max(1.0 - d.y * d.y, 0.0)));
  return d;
}

// A direction by the sky's luminance.
vec3 sampleSky(vec2 u) {
  return sampleSkyRows(int(loadUint4(int(loadUint4(2).z) + 1).z), u);
}
