// Choosing a light by how much it may give to a point: a tree of lights with bounds of their places, directions and
// power. A. Conty Estevez and C. Kulla, 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting";
// the importance is that of M. Pharr et al., 2023, "Physically Based Rendering", section 12.6.3.

// cos(max(0, a - b)) and sin(max(0, a - b)).
float cosOfDifference(float sinA, float cosA, float sinB, float cosB) {
  return cosA > cosB ? 1.0 : cosA * cosB + sinA * sinB;
}
float sinOfDifference(float sinA, float cosA, float sinB, float cosB) {
  return cosA > cosB ? 0.0 : sinA * cosB - cosA * sinB;
}
float sineOf(float cosine) {
  return sqrt(max(1.0 - cosine * cosine, 0.0));
}

// An upper bound, about, of what the lights of a node give. @param N 0 in fog, which has no normal
float nodeImportance(int node, vec3 P, vec3 N) {
  vec4 low = loadFloat4(node);
  vec4 high = loadFloat4(node + 1);
  vec4 axis = loadFloat4(node + 2);
  vec3 centre = 0.5 * (low.xyz + high.xyz);
  vec3 away = P - centre;
  vec3 halfSize = 0.5 * (high.xyz - low.xyz);
  float radius2 = dot(halfSize, halfSize);
  float distance2 = dot(away, away);
  vec3 w = away * inversesqrt(max(distance2, 1e-20));
  float cosW = dot(axis.xyz, w);
  if (loadUint4(node + 3).w != 0u) cosW = abs(cosW);
  float sinW = sineOf(cosW);
  // The angle that the bounds subtend; all around where P is among them.
  float sinB2 = radius2 / max(distance2, 1e-20);
  float cosB = sinB2 >= 1.0 ? -1.0 : sqrt(1.0 - sinB2);
  float sinB = sineOf(cosB);
  float sinO = sineOf(high.w);
  float cosX = cosOfDifference(sinW, cosW, sinO, high.w);
  float sinX = sinOfDifference(sinW, cosW, sinO, high.w);
  float cosAtLight = cosOfDifference(sinX, cosX, sinB, cosB);
  if (cosAtLight <= axis.w) return 0.0;
  float importance = low.w * cosAtLight / max(distance2, max(sqrt(radius2), 1e-12));
  if (dot(N, N) > 0.0) {
    float cosI = abs(dot(w, N));
    importance *= max(cosOfDifference(sineOf(cosI), cosI, sinB, cosB), 0.0);
  }
  return max(importance, 0.0);
}

// How probable it is that child 1 is taken; -1 where neither can give anything.
float secondChildProbability(uvec4 links, vec3 P, vec3 N) {
  float first = nodeImportance(int(links.x), P, N);
  float second = nodeImportance(int(links.y), P, N);
  float sum = first + second;
  return sum > 0.0 ? second / sum : -1.0;
}

// The share of the choice that falls to the tree; each infinite light has as much.
float treeProbability() {
  uint infinite = loadUint4(2).y;
  return loadUint4(1).y == 0u ? 0.0 : 1.0 / (1.0 + float(infinite));
}
float infiniteProbability() {
  uint infinite = loadUint4(2).y;
  return 1.0 / (float(infinite) + (loadUint4(1).y == 0u ? 0.0 : 1.0));
}

float chosenProbability;

// A finite light's number, or -1. Its probability goes to chosenProbability.
int chooseFiniteLight(float u, vec3 P, vec3 N) {
  int node = int(loadUint4(1).y);
  chosenProbability = treeProbability();
  while (true) {
    uvec4 links = loadUint4(node + 3);
    if (links.z == 1u) return int(links.x);
    float second = secondChildProbability(links, P, N);
    if (second < 0.0) return -1;
    // What is left of u chooses further down.
    if (u < second) {
      u = u / second;
      chosenProbability *= second;
      node = int(links.y);
    } else {
      u = (u - second) / (1.0 - second);
      chosenProbability *= 1.0 - second;
      node = int(links.x);
    }
    u = min(u, 0.99999994);
  }
  return -1;
}

// The probability with which chooseFiniteLight() takes the light with this bit trail.
float finiteLightProbability(uint trail, vec3 P, vec3 N) {
  int node = int(loadUint4(1).y);
  // A light without power is not in the tree.
  if (node == 0 || trail == NONE) return 0.0;
  float probability = treeProbability();
  while (true) {
    uvec4 links = loadUint4(node + 3);
    if (links.z == 1u) return probability;
    float second = secondChildProbability(links, P, N);
    if (second < 0.0) return 0.0;
    bool takesSecond = (trail & 1u) != 0u;
    probability *= takesSecond ? second : 1.0 - second;
    node = int(takesSecond ? links.y : links.x);
    trail = trail >> 1u;
  }
  return 0.0;
}
