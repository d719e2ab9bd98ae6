// Light transport: paths from the camera, with lights sampled at every vertex (next-event estimation) and both ways of
// finding a light weighed against each other (E. Veach, 1997, chapter 9). J. T. Kajiya, 1986, "The Rendering Equation".

const uint BOTH = 0u;
const uint DIRECTIONS_ALONE = 1u;
const uint LIGHTS_ALONE = 2u;

// Paths may end by chance from this depth on.
const int ROULETTE_DEPTH = 3;

vec3 pathAlbedo;
vec3 pathNormal;
float pathDistance;
float pathAlpha;

vec3 pathRadiance;
vec3 pathThroughput;

// Adds light; beyond direct light no more than the limit, if one is asked for.
void addLight(vec3 light, int depth, float limit) {
  vec3 found = pathThroughput * light;
  float most = largest(found);
  if (limit > 0.0 && depth > 1 && most > limit) found *= limit / most;
  pathRadiance += found;
}

// The model at this surface, in 1/sr: neither negative nor NaN.
vec3 surfaceBRDF(uint model, vec3 L) {
  vec3 f = modelBRDF(model, L);
  return vec3(f.x > 0.0 ? f.x : 0.0, f.y > 0.0 ? f.y : 0.0, f.z > 0.0 ? f.z : 0.0);
}

// Rectangle lights along a ray of the given density: they are seen in reflections and hide nothing.
void addRectangles(vec3 o, vec3 d, float density, vec3 N, uint strategy, int depth, float limit) {
  int first = int(loadUint4(1).x);
  int count = int(loadUint4(9).y);
  int i = 0;
  while (i < count) {
    int slot = first + 6 * i;
    i++;
    vec4 side = loadFloat4(slot + 3);
    float cosine = -dot(side.xyz, d);
    if (cosine <= 1e-7) continue;
    vec3 toCentre = loadFloat4(slot + 2).xyz - o;
    float distance = -dot(toCentre, side.xyz) / cosine;
    if (distance <= 0.0 || distance >= hitDistance) continue;
    vec3 place = d * distance - toCentre;
    vec3 halfWidth = loadFloat4(slot + 4).xyz;
    vec3 halfHeight = loadFloat4(slot + 5).xyz;
    if (abs(dot(place, halfWidth)) > dot(halfWidth, halfWidth)) continue;
    if (abs(dot(place, halfHeight)) > dot(halfHeight, halfHeight)) continue;
    float weight = 1.0;
    if (strategy == BOTH) {
      float ofLight = finiteLightProbability(loadUint4(slot).w, o, N) * distance * distance / (cosine * side.w);
      weight = balance(density, ofLight);
    }
    addLight(loadFloat4(slot + 1).xyz * (weight * fogTransmittance(o, d, distance)), depth, limit);
  }
}

// Light that reaches a vertex straight from a light. @param g in fog, where it is at P: the phase function's;
// d is then the way that the path came
void addDirectLight(bool isFog, vec3 P, vec3 d, float g, uint model, uint strategy, int depth, float limit) {
  vec3 N = isFog ? vec3(0.0) : surfaceN;
  if (!sampleLight(P, N)) return;
  vec3 share;
  float density = 0.0;
  vec3 o = P;
  if (isFog) {
    density = phase(dot(d, lightDirection), g);
    share = vec3(density);
  } else {
    float cosine = dot(N, lightDirection);
    if (cosine <= 0.0 || dot(surfaceFacetNormal, lightDirection) <= 0.0) return;
    share = surfaceBRDF(model, lightDirection) * cosine;
    if (largest(share * lightRadiance) <= 0.0) return;
    if (!lightIsDelta && strategy == BOTH) density = modelPdf(model, lightDirection);
    o = offsetOrigin(P, surfaceFacetNormal);
  }
  float weight = lightIsDelta || strategy != BOTH ? 1.0 : balance(lightDensity, density);
  // Not as far as the light, which would be in its own shadow.
  float visible = traceShadow(o, lightDirection, lightDistance * 0.9999);
  if (visible <= 0.0) return;
  visible *= fogTransmittance(o, lightDirection, lightDistance);
  addLight(share * lightRadiance * (weight * visible / lightDensity), depth + 1, limit);
}

// One path. @param d a unit vector
vec3 tracePath(vec3 o, vec3 d) {
  int maxDepth = int(loadUint4(16).z);
  uint strategy = loadUint4(21).x;
  float limit = loadFloat4(22).x;
  vec4 fog = loadFloat4(7);
  pathRadiance = vec3(0.0);
  pathThroughput = vec3(1.0);
  pathAlbedo = vec3(0.0);
  pathNormal = vec3(0.0);
  pathDistance = 0.0;
  pathAlpha = 0.0;
  // The density with which d was drawn at the last vertex, in 1/sr, and that vertex' normal.
  float density = 0.0;
  vec3 N = vec3(0.0);
  int depth = 0;
  while (true) {
    bool isHit = traceRay(o, d);
    bool isCameraRay = depth == 0;
    bool seesLights = !isCameraRay && strategy != LIGHTS_ALONE;
    if (seesLights) addRectangles(o, d, density, N, strategy, depth, limit);

    // In fog a path may scatter before it gets anywhere. Choosing the distance by the transmittance leaves the
    // albedo alone.
    bool isFog = false;
    if (fog.x > 0.0) {
      vec2 segment = fogSegment(o, d, hitDistance);
      float free = segment.x - log(1.0 - random1()) / fog.x;
      isFog = free < segment.y;
      if (isFog) o += d * free;
    }

    if (!isFog && !isHit) {
      if (isCameraRay) addLight(backgroundRadiance(d), depth, limit);
      else if (seesLights && loadUint4(2).w != NONE) {
        float weight = strategy == BOTH ? balance(density, skyLightDensity(d)) : 1.0;
        addLight(skyRadiance(d) * weight, depth, limit);
      }
      break;
    }

    uint model = 0u;
    if (isFog) {
      if (isCameraRay) pathAlpha = 1.0;
      pathThroughput *= loadFloat4(8).xyz;
    } else {
      loadSurface(d);
      model = loadUint4(surfaceMaterial).x;
      if (isCameraRay) {
        pathAlpha = 1.0;
        pathDistance = hitDistance;
        pathNormal = surfaceN;
      }
      vec3 emitted = emittedRadiance(surfaceMaterial, surfaceIsFront, surfaceUv);
      if (largest(emitted) > 0.0 && (isCameraRay || seesLights)) {
        float weight = 1.0;
        if (!isCameraRay && strategy == BOTH) weight = balance(density, hitTriangleDensity(o, N, d));
        addLight(emitted * weight, depth, limit);
      }
    }
    if (depth >= maxDepth) break;
    vec3 P = isFog ? o : surfacePosition;
    if (strategy != DIRECTIONS_ALONE) addDirectLight(isFog, P, d, fog.y, model, strategy, depth, limit);

    if (isFog) {
      vec3 scattered = samplePhase(random2(), d, fog.y);
      density = phase(dot(d, scattered), fog.y);
      d = scattered;
      N = vec3(0.0);
    } else {
      vec3 L = modelSample(model, random2());
      float cosine = dot(surfaceN, L);
      if (cosine <= 0.0 || dot(surfaceFacetNormal, L) <= 0.0) break;
      density = modelPdf(model, L);
      // Not only against 0: a NaN ends the path, too.
      if (!(density > 0.0)) break;
      vec3 share = surfaceBRDF(model, L) * (cosine / density);
      if (isCameraRay) pathAlbedo = min(share, vec3(1.0));
      pathThroughput *= share;
      o = offsetOrigin(surfacePosition, surfaceFacetNormal);
      d = L;
      N = surfaceN;
    }
    depth++;
    float most = largest(pathThroughput);
    if (!(most > 0.0)) break;
    if (depth > ROULETTE_DEPTH) {
      float survival = min(most, 0.95);
      if (random1() >= survival) break;
      pathThroughput = pathThroughput / survival;
    }
  }
  return pathRadiance;
}
