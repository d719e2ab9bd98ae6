// Light transport: paths from the camera, with lights sampled at every vertex (next-event estimation) and both ways of
// finding a light weighed against each other (E. Veach, 1997, chapter 9). J. T. Kajiya, 1986, "The Rendering Equation".

const uint BOTH = 0u;
const uint DIRECTIONS_ALONE = 1u;
const uint LIGHTS_ALONE = 2u;

// Paths may end by chance from this depth on.
const int ROULETTE_DEPTH = 3;
const int ROULETTE_STEPS = 16;
// A path in a white medium without an end must end.
const int MAX_STEPS = 4096;

vec3 pathAlbedo;
vec3 pathNormal;
float pathDistance;
float pathAlpha;
// How much of the background the shadow on the ground takes, as luminance: what it covers of a transparent picture.
float pathShadow;

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

// Whether L may leave the surface: both normals must have it on one side, and that side must be open.
bool isSameSide(float cosine, vec3 L) {
  if (cosine == 0.0 || (cosine < 0.0 && !surfaceTransmits)) return false;
  return dot(surfaceFacetNormal, L) * cosine > 0.0;
}

vec3 leavingOrigin(bool isBelow) {
  return offsetOrigin(surfacePosition, isBelow ? -surfaceFacetNormal : surfaceFacetNormal);
}

// Passes through the surface into or out of its body.
void crossSurface(uint model) {
  if (surfaceIsThin) return;
  if (!surfaceIsFront) {
    leaveMedium(surfaceMaterial);
    return;
  }
  vec3 extinction = modelExtinction(model);
  vec3 albedo = vec3(0.0);
  if (largest(extinction) > 0.0) {
    vec3 scattering = modelScattering(model);
    // Absorption is what is left, and cannot be less than none (OpenPBR 1.1, "Transmission").
    vec3 absorption = extinction - scattering;
    float least = min(absorption.x, min(absorption.y, absorption.z));
    if (least < 0.0) extinction -= vec3(least);
    albedo = scattering / max(extinction, vec3(1e-20));
  }
  enterMedium(surfaceMaterial, surfaceIor, extinction, albedo, modelAnisotropy(model));
}

// Takes crossSurface() back: it added or removed the top alone. @param count the media before it
void uncrossSurface(int count) {
  mediumCount = count;
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
    bool passesThrough = loadUint4(slot).z != 0u;
    if (distance <= 0.0 || (distance >= hitDistance && !passesThrough)) continue;
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
    addLight(loadFloat4(slot + 1).xyz * spaceTransmittance(o, d, distance) * weight, depth, limit);
  }
}

// Light that reaches a vertex straight from a light. @param isSpace whether P is in a medium, not on the surface; d is
// then the way that the path came
void addDirectLight(bool isSpace, vec3 P, vec3 d, uint model, uint strategy, int depth, float limit) {
  vec3 N = isSpace ? vec3(0.0) : surfaceN;
  if (!sampleLight(P, N)) return;
  vec3 share;
  float density = 0.0;
  vec3 o = P;
  bool isBelow = false;
  if (isSpace) {
    density = phase(dot(d, lightDirection), spaceAnisotropy);
    share = vec3(density);
  } else {
    float cosine = dot(N, lightDirection);
    isBelow = cosine < 0.0;
    if (!isSameSide(cosine, lightDirection)) return;
    share = surfaceBRDF(model, lightDirection) * abs(cosine);
    if (largest(share * lightRadiance) <= 0.0) return;
    if (!lightIsDelta && strategy == BOTH) density = modelPdf(model, lightDirection);
    o = leavingOrigin(isBelow);
  }
  float weight = lightIsDelta || strategy != BOTH ? 1.0 : balance(lightDensity, density);
  // Not as far as the light, which would be in its own shadow.
  float visible = lightPassesThrough ? 1.0 : traceShadow(o, shadowDirection, shadowDistance * 0.9999);
  if (visible <= 0.0) return;
  // Beyond the surface is another medium.
  int inside = mediumCount;
  if (isBelow) crossSurface(model);
  findSpace();
  vec3 transmittance = spaceTransmittance(o, lightDirection, lightDistance);
  if (isBelow) uncrossSurface(inside);
  findSpace();
  addLight(share * lightRadiance * transmittance * (weight * visible / lightDensity), depth + 1, limit);
}

// One path. @param d a unit vector
vec3 tracePath(vec3 o, vec3 d) {
  int maxDepth = int(loadUint4(16).z);
  uint strategy = loadUint4(21).x;
  float limit = loadFloat4(22).x;
  mediumCount = 0;
  pathRadiance = vec3(0.0);
  pathThroughput = vec3(1.0);
  pathAlbedo = vec3(0.0);
  pathNormal = vec3(0.0);
  pathDistance = 0.0;
  pathAlpha = 0.0;
  pathShadow = 0.0;
  // The density with which d was drawn at the last vertex, in 1/sr, and that vertex' normal.
  float density = 0.0;
  vec3 N = vec3(0.0);
  int depth = 0;
  int steps = 0;
  while (true) {
    bool isHit = traceRay(o, d);
    bool isCameraRay = depth == 0;
    // The ground hides what is below it, but not a floor that lies in it.
    float ground = isCameraRay ? groundDistance(o, d) : 0.0;
    if (ground > 0.0 && hitDistance > ground * 1.0001) {
      isHit = false;
      hitDistance = INFINITY;
    }
    bool seesLights = !isCameraRay && strategy != LIGHTS_ALONE;
    findSpace();
    if (seesLights) addRectangles(o, d, density, N, strategy, depth, limit);
    pathThroughput *= crossSpace(pathThroughput, o, d, spaceSegment(o, d, hitDistance));
    bool isSpace = scatterDistance >= 0.0;
    if (isSpace) o += d * scatterDistance;

    if (!isSpace && !isHit) {
      if (isCameraRay) {
        vec3 shade = ground > 0.0 ? groundShade(o + d * ground) : vec3(1.0);
        pathShadow = 1.0 - luminance(shade);
        addLight(backgroundRadiance(d) * shade, depth, limit);
      } else if (seesLights && loadUint4(2).w != NONE) {
        float weight = strategy == BOTH ? balance(density, skyLightDensity(d)) : 1.0;
        addLight(skyRadiance(d) * weight, depth, limit);
      }
      break;
    }

    uint model = 0u;
    if (isSpace) {
      if (isCameraRay) pathAlpha = 1.0;
    } else {
      loadSurface(d);
      model = loadUint4(surfaceMaterial).x;
      // A body's surface inside another, entered later, is not there.
      if (surfaceTransmits && !surfaceIsThin && !surfaceIsFront && mediumCount > 0
          && mediumMaterial[mediumCount - 1] != surfaceMaterial) {
        leaveMedium(surfaceMaterial);
        o = leavingOrigin(true);
        steps++;
        if (steps > MAX_STEPS) break;
        continue;
      }
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
    // Inside a body light may scatter as often as it likes: what looks like one surface takes hundreds of turns.
    bool isInside = isSpace && mediumCount > 0;
    if (depth >= maxDepth && !isInside) break;
    vec3 P = isSpace ? o : surfacePosition;
    if (strategy != DIRECTIONS_ALONE) addDirectLight(isSpace, P, d, model, strategy, depth, limit);

    if (isSpace) {
      vec3 scattered = samplePhase(random2(), d, spaceAnisotropy);
      density = phase(dot(d, scattered), spaceAnisotropy);
      d = scattered;
      N = vec3(0.0);
    } else {
      vec3 L = modelSample(model, random2());
      float cosine = dot(surfaceN, L);
      bool isBelow = cosine < 0.0;
      if (!isSameSide(cosine, L)) break;
      density = modelPdf(model, L);
      // Not only against 0: a NaN ends the path, too.
      if (!(density > 0.0)) break;
      vec3 share = surfaceBRDF(model, L) * (abs(cosine) / density);
      if (isCameraRay) pathAlbedo = min(share, vec3(1.0));
      pathThroughput *= share;
      o = leavingOrigin(isBelow);
      if (isBelow) crossSurface(model);
      d = L;
      N = surfaceN;
    }
    steps++;
    if (steps > MAX_STEPS) break;
    if (!isInside) depth++;
    float most = largest(pathThroughput);
    if (!(most > 0.0)) break;
    if (depth > ROULETTE_DEPTH || steps > ROULETTE_STEPS) {
      float survival = min(most, 0.95);
      if (random1() >= survival) break;
      pathThroughput = pathThroughput / survival;
    }
  }
  return pathRadiance;
}
