// Adds samples first <= index < first + count of a pixel to 5 slots of the film.
void renderPixel(int pixel, int film, uint first, uint count) {
  uvec4 settings = loadUint4(16);
  int x = pixel % int(settings.x);
  int y = pixel / int(settings.x);
  vec3 radiance = vec3(0.0);
  vec3 squares = vec3(0.0);
  vec3 albedo = vec3(0.0);
  float albedoSquares = 0.0;
  vec3 normal = vec3(0.0);
  float distance = 0.0;
  float alpha = 0.0;
  float shadow = 0.0;
  float shadowSquares = 0.0;
  bool isTransparent = loadFloat4(15).w != 0.0;
  uint i = 0u;
  while (i < count) {
    startSample(uint(x), uint(y), first + i, settings.w);
    cameraRay(vec2(float(x), float(y)) + random2());
    vec3 sampled = tracePath(cameraOrigin, cameraDirection);
    radiance += sampled;
    squares += sampled * sampled;
    albedo += pathAlbedo;
    albedoSquares += dot(pathAlbedo, pathAlbedo);
    normal += pathNormal;
    distance += pathDistance;
    alpha += pathAlpha;
    shadow += pathShadow;
    if (isTransparent) shadowSquares += pathShadow * pathShadow;
    i++;
  }
  filmStore(film, filmLoad(film) + vec4(radiance, float(count)));
  filmStore(film + 1, filmLoad(film + 1) + vec4(squares, 0.0));
  filmStore(film + 2, filmLoad(film + 2) + vec4(albedo, albedoSquares));
  filmStore(film + 3, filmLoad(film + 3) + vec4(normal, 0.0));
  filmStore(film + 4, filmLoad(film + 4) + vec4(distance, alpha, shadow, shadowSquares));
}

// A run of pixels, one after the other, into a film of these pixels alone.
void renderPixels(int from, int to, uint first, uint count) {
  int pixel = from;
  while (pixel < to) {
    renderPixel(pixel, 5 * (pixel - from), first, count);
    pixel++;
  }
}
