// The generic sampler at the present surface, for models without a sampler.

vec3 inFrame(vec3 W) {
  return vec3(dot(W, surfaceX), dot(W, surfaceY), dot(W, surfaceN));
}

vec3 sampleGenerically(uint model, vec2 u) {
  int table = int(loadUint4(surfaceMaterial + 4).y);
  vec3 l = genericSample(table, u, inFrame(surfaceV), modelIor(model), modelIsThin(model));
  return l.x * surfaceX + l.y * surfaceY + l.z * surfaceN;
}

float genericDensity(uint model, vec3 L) {
  int table = int(loadUint4(surfaceMaterial + 4).y);
  return genericPdf(table, inFrame(L), inFrame(surfaceV), modelIor(model), modelIsThin(model));
}
