// Light from one of the document's lights.

const uint POINT = 0u;
const uint SPOT = 1u;
const uint RECTANGLE = 2u;
const uint TRIANGLE_LIGHT = 3u;
const uint DIRECTIONAL = 4u;

// What sampleLight() found.
vec3 lightDirection;
float lightDistance;
vec3 lightRadiance;    // of a light without size: its irradiance on a surface that faces it
float lightDensity;    // in 1/sr, times the light's probability; of a light without size: that probability alone
bool lightIsDelta;
// Where the light has to come from to be seen: a point of a lamp that is lit as from its centre, a direction within the
// sun (docs/decisions/light-sizes.md).
vec3 shadowDirection;
float shadowDistance;
bool lightPassesThrough;    // things do not keep it off

// How irradiance falls with the distance r (src/lights/falloff.ts).
float falloffAt(float r, uint falloff, float inverseRange4) {
  float base = falloff == 2u ? 1.0 : falloff == 1u ? 1.0 / r : 1.0 / (r * r);
  float r2 = r * r;
  float window = max(1.0 - r2 * r2 * inverseRange4, 0.0);
  return base * window * window;
}

// A point of an area light, seen from P.
bool towardsArea(vec3 P, vec3 point, vec3 normal, float area, bool bothSides) {
  vec3 toLight = point - P;
  float distance2 = dot(toLight, toLight);
  if (distance2 <= 0.0) return false;
  lightDistance = sqrt(distance2);
  lightDirection = toLight / lightDistance;
  float cosine = -dot(normal, lightDirection);
  if (bothSides) cosine = abs(cosine);
  if (cosine <= 1e-7) return false;
  lightDensity = chosenProbability * distance2 / (cosine * area);
  shadowDirection = lightDirection;
  shadowDistance = lightDistance;
  return true;
}

// A point of the disc of this radius about the origin that faces d, evenly. @param d a unit vector
vec3 sampleDisc(vec3 d, float radius, vec2 u) {
  // T. Duff et al., 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1), listing 3.
  float s = d.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (s + d.z);
  vec3 x = vec3(1.0 + s * d.x * d.x * a, s * d.x * d.y * a, -s * d.x);
  float r = radius * sqrt(u.x);
  float angle = 2.0 * PI * u.y;
  return (x * cos(angle) + cross(d, x) * sin(angle)) * r;
}

// A direction to the light in a slot that has been chosen with chosenProbability. @returns false where no light comes
bool towardsLight(int slot, vec3 P, vec2 uv) {
  uvec4 head = loadUint4(slot);
  vec4 power = loadFloat4(slot + 1);
  vec4 place = loadFloat4(slot + 2);
  lightIsDelta = false;
  lightPassesThrough = false;
  if (head.x == RECTANGLE) {
    lightPassesThrough = head.z != 0u;
    vec4 side = loadFloat4(slot + 3);
    vec3 point = place.xyz + loadFloat4(slot + 4).xyz * (2.0 * uv.x - 1.0) + loadFloat4(slot + 5).xyz * (2.0 * uv.y - 1.0);
    lightRadiance = power.xyz;
    return towardsArea(P, point, side.xyz, side.w, false);
  }
  if (head.x == TRIANGLE_LIGHT) {
    // Uniformly, without tearing the square apart: E. Heitz, 2019, "A Low-Distortion Map Between Triangle and Square".
    vec2 b = uv.y > uv.x ? vec2(0.5 * uv.x, uv.y - 0.5 * uv.x) : vec2(uv.x - 0.5 * uv.y, 0.5 * uv.y);
    vec4 corner = loadFloat4(slot + 3);
    vec3 edge1 = corner.xyz - place.xyz;
    vec3 edge2 = loadFloat4(slot + 4).xyz - place.xyz;
    vec3 normal = cross(edge1, edge2);
    float normal2 = dot(normal, normal);
    if (normal2 <= 0.0) return false;
    uvec4 parts = loadUint4(int(loadUint4(0).y) + 8 * int(head.y) + 6);
    normal = normal * inversesqrt(normal2) * ((parts.z & 1u) != 0u ? -1.0 : 1.0);
    if (!towardsArea(P, place.xyz + edge1 * b.x + edge2 * b.y, normal, corner.w, power.w != 0.0)) return false;
    bool isFront = dot(normal, lightDirection) < 0.0;
    bool hasMap = loadUint4(int(parts.y) + 3).z != 0u;
    vec4 at = hasMap ? uvAt(int(head.y), head.z, b.x, b.y) : vec4(0.0);
    lightRadiance = emittedRadiance(int(parts.y), isFront, at);
    return true;
  }
  if (head.x == POINT || head.x == SPOT) {
    vec3 toLight = place.xyz - P;
    float distance2 = dot(toLight, toLight);
    if (distance2 <= 0.0) return false;
    lightDistance = sqrt(distance2);
    lightDirection = toLight / lightDistance;
    lightRadiance = power.xyz * falloffAt(lightDistance, head.y, place.w);
    lightDensity = chosenProbability;
    lightIsDelta = true;
    lightPassesThrough = head.z != 0u;
    shadowDirection = lightDirection;
    shadowDistance = lightDistance;
    if (power.w > 0.0) {
      vec3 toPoint = toLight + sampleDisc(lightDirection, power.w, uv);
      shadowDistance = length(toPoint);
      shadowDirection = toPoint / shadowDistance;
    }
    if (head.x == SPOT) {
      vec4 axis = loadFloat4(slot + 3);
      vec4 edge = loadFloat4(slot + 4);
      float cosTheta = -dot(axis.xyz, lightDirection);
      float t = clamp((cosTheta - axis.w) * edge.y, 0.0, 1.0);
      lightRadiance *= pow(max(cosTheta, 1e-6), edge.x) * t * t * (3.0 - 2.0 * t);
    }
    return true;
  }
  lightDistance = INFINITY;
  if (head.x == DIRECTIONAL) {
    lightDirection = place.xyz;
    lightRadiance = power.xyz;
    lightDensity = chosenProbability;
    lightIsDelta = true;
    lightPassesThrough = head.z != 0u;
    shadowDirection = lightDirection;
    shadowDistance = INFINITY;
    if (power.w > 0.0) shadowDirection = normalize(lightDirection + sampleDisc(lightDirection, power.w, uv));
    return true;
  }
  lightDirection = sampleSky(uv);
  shadowDirection = lightDirection;
  shadowDistance = INFINITY;
  lightRadiance = skyRadiance(lightDirection);
  lightDensity = chosenProbability * skySampleDensity;
  return lightDensity > 0.0;
}

// A light, and a direction to it, for a point in space. @param N 0 in fog @returns false where no light comes
bool sampleLight(vec3 P, vec3 N) {
  uvec4 lists = loadUint4(1);
  uvec4 infinite = loadUint4(2);
  float u = random1();
  vec2 uv = random2();
  float treeShare = treeProbability();
  int slot;
  if (u < treeShare) {
    int number = chooseFiniteLight(u / treeShare, P, N);
    if (number < 0) return false;
    slot = int(lists.x) + 6 * number;
  } else {
    if (infinite.y == 0u) return false;
    chosenProbability = infiniteProbability();
    int number = min(int((u - treeShare) / chosenProbability), int(infinite.y) - 1);
    slot = int(infinite.x) + 6 * number;
  }
  return towardsLight(slot, P, uv);
}

// The density of sampleLight() for the sky, from any point.
float skyLightDensity(vec3 d) {
  return infiniteProbability() * skyPdf(d);
}

// The same for the triangle that was hit, from the point P with normal N where the ray began.
float hitTriangleDensity(vec3 P, vec3 N, vec3 d) {
  uint first = loadUint4(int(loadUint4(0).y) + 8 * hitInstance + 6).w;
  if (first == NONE) return 0.0;
  int slot = int(loadUint4(1).x) + 6 * int(first + hitTriangle);
  float cosine = abs(dot(surfaceFacetNormal, d));
  float area = loadFloat4(slot + 3).w;
  return finiteLightProbability(loadUint4(slot).w, P, N) * hitDistance * hitDistance / max(cosine * area, 1e-20);
}
