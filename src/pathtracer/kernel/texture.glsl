// Textures: bilinear, without mipmaps, since many samples average each pixel anyway.

int wrapTexel(int i, int size, uint mode) {
  if (mode == 2u) return clamp(i, 0, size - 1);
  int period = mode == 1u ? 2 * size : size;
  int j = i % period;
  j = j < 0 ? j + period : j;
  return j < size ? j : 2 * size - 1 - j;
}

// One texel of a texture use; row 0 is v = 0.
vec4 texelAt(uvec4 image, int x, int y) {
  uint mode = image.w & 3u;
  uint format = (image.w >> 4u) & 3u;
  int index = wrapTexel(y, int(image.z), mode) * int(image.y) + wrapTexel(x, int(image.y), mode);
  if (format == 2u) return loadFloat4(int(image.x) + index);
  uint bytes = loadUint(int(image.x) + index);
  if (format == 1u) {
    return vec4(float(bytes & 255u), float((bytes >> 8u) & 255u), float((bytes >> 16u) & 255u), float(bytes >> 24u)) / 255.0;
  }
  int table = int(loadUint4(1).w);
  return vec4(
    loadFloat(table + int(bytes & 255u)),
    loadFloat(table + int((bytes >> 8u) & 255u)),
    loadFloat(table + int((bytes >> 16u) & 255u)),
    float(bytes >> 24u) / 255.0);
}

vec4 sampleImage(uvec4 image, vec2 uv) {
  // Far from 0 a float no longer tells texels apart; repeating images are the same there.
  vec2 place = ((image.w & 3u) == 0u ? fract(uv) : clamp(uv, -1e4, 1e4)) * vec2(float(image.y), float(image.z)) - 0.5;
  vec2 base = floor(place);
  vec2 t = place - base;
  int x = int(base.x);
  int y = int(base.y);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; i++) {
    vec2 corner = vec2(float(i & 1), float(i >> 1));
    vec2 weight = mix(1.0 - t, t, corner);
    sum += texelAt(image, x + (i & 1), y + (i >> 1)) * (weight.x * weight.y);
  }
  return sum;
}

// @param use a slot @param uv the two sets of texture coordinates
vec4 sampleTexture(int use, vec4 uv) {
  uvec4 image = loadUint4(use);
  vec3 place = vec3((image.w >> 8u) == 0u ? uv.xy : uv.zw, 1.0);
  return sampleImage(image, vec2(dot(loadFloat4(use + 1).xyz, place), dot(loadFloat4(use + 2).xyz, place)));
}

float channelOf(vec4 texel, uint channel) {
  return channel == 0u ? texel.x : channel == 1u ? texel.y : channel == 2u ? texel.z : texel.w;
}
