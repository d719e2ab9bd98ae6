// The surface at a hit: where it is, how it is turned, what it is made of.

vec3 surfacePosition;
vec3 surfaceFacetNormal;  // of the triangle, on the side of the ray
vec3 surfaceN;            // shading normal
vec3 surfaceX;
vec3 surfaceY;
vec3 surfaceV;            // towards where the ray came from, never below the shading normal's horizon
vec4 surfaceUv;
bool surfaceIsFront;
bool surfaceTransmits;     // L may be on the other side
bool surfaceIsThin;        // that side is no inside
float surfaceIor;          // of the body
int surfaceMaterial;      // slot

// As in the interactive renderer (shading-frame.ts): the models are 0 below the horizon.
const float LEAST_COSINE = 1e-4;

const uint TRANSMITS = 16u;

// The index of refraction around a body of this material; in media.glsl.
float surroundingIor(int material);

// The slots of a triangle's three vertices.
ivec3 triangleVertices(uvec4 mesh, uint triangle) {
  int word = int(mesh.z + 3u * triangle);
  return ivec3(mesh.y + mesh.w * uvec3(loadUint(word), loadUint(word + 1), loadUint(word + 2)));
}

vec4 interpolateUv(uvec4 mesh, ivec3 at, float weight1, float weight2) {
  float weight0 = 1.0 - weight1 - weight2;
  vec2 uv0 = vec2(
    weight0 * loadFloat4(at.x).w + weight1 * loadFloat4(at.y).w + weight2 * loadFloat4(at.z).w,
    weight0 * loadFloat4(at.x + 1).w + weight1 * loadFloat4(at.y + 1).w + weight2 * loadFloat4(at.z + 1).w);
  if (mesh.w == 2u) return vec4(uv0, uv0);
  vec4 uv1 = weight0 * loadFloat4(at.x + 2) + weight1 * loadFloat4(at.y + 2) + weight2 * loadFloat4(at.z + 2);
  return vec4(uv0, uv1.xy);
}

vec4 uvAt(int instance, uint triangle, float weight1, float weight2) {
  uvec4 mesh = loadUint4(int(loadUint4(int(loadUint4(0).y) + 8 * instance + 6).x));
  return interpolateUv(mesh, triangleVertices(mesh, triangle), weight1, weight2);
}

// How opaque the material is here.
float opacityAt(int material, vec4 uv) {
  float opacity = loadFloat4(material + 1).w;
  int map = int(loadUint4(material + 3).w);
  if (map != 0) opacity *= channelOf(sampleTexture(map, uv), loadUint4(material + 4).x);
  return clamp(opacity, 0.0, 1.0);
}

float surfaceCoverage(int instance, uint triangle, float weight1, float weight2) {
  int material = int(loadUint4(int(loadUint4(0).y) + 8 * instance + 6).y);
  float opacity = opacityAt(material, uvAt(instance, triangle, weight1, weight2));
  if ((loadUint4(material).y & MASK) == 0u) return opacity;
  return opacity < loadFloat4(material + 2).x ? 0.0 : 1.0;
}

// A vertex of the hit triangle in the space of its mesh.
vec3 hitVertex(int which) {
  int word = 4 * (hitBlock + 3 * which) + hitLane;
  return vec3(loadFloat(word), loadFloat(word + 4), loadFloat(word + 8));
}

// What bends the normal: a tangent space map or a height map. a, b, c are the triangle's corners in the world.
vec3 bentNormal(vec3 N, vec3 T, vec3 B, vec3 edge1, vec3 edge2, uvec4 mesh, ivec3 at) {
  uvec4 maps = loadUint4(surfaceMaterial + 3);
  vec4 scales = loadFloat4(surfaceMaterial + 2);
  if (maps.x != 0u) {
    vec3 map = sampleTexture(int(maps.x), surfaceUv).xyz * 2.0 - 1.0;
    return T * (map.x * scales.y) + B * (map.y * scales.y) + N * map.z;
  }
  // The surface rises by the height: its gradient over the triangle comes from differences over a texel or so.
  vec4 uv0 = interpolateUv(mesh, at, 0.0, 0.0);
  vec4 du = interpolateUv(mesh, at, 1.0, 0.0) - uv0;
  vec4 dv = interpolateUv(mesh, at, 0.0, 1.0) - uv0;
  uvec4 image = loadUint4(int(maps.y));
  float texels = max(length(vec4(du.xy, dv.xy)) * float(max(image.y, image.z)), 1.0);
  float delta = 1.0 / texels;
  vec3 heights = vec3(0.0);
  for (int i = 0; i < 3; i++) {
    vec4 moved = surfaceUv + (i == 0 ? vec4(0.0) : i == 1 ? du : dv) * delta;
    heights[i] = sampleTexture(int(maps.y), moved).x;
  }
  float rise1 = (heights.y - heights.x) / delta;
  float rise2 = (heights.z - heights.x) / delta;
  vec3 normal = cross(edge1, edge2);
  float area2 = dot(normal, normal);
  if (area2 == 0.0) return N;
  vec3 gradient = (cross(edge2, normal) * rise1 + cross(normal, edge1) * rise2) / area2;
  return N - scales.z * (gradient - N * dot(N, gradient));
}

// Fills the surface variables for the hit of a ray of direction d.
void loadSurface(vec3 d) {
  int instance = int(loadUint4(0).y) + 8 * hitInstance;
  uvec4 parts = loadUint4(instance + 6);
  uvec4 mesh = loadUint4(int(parts.x));
  surfaceMaterial = int(parts.y);
  uvec4 head = loadUint4(surfaceMaterial);
  vec3 a = hitVertex(0);
  vec3 edge1 = hitVertex(1) - a;
  vec3 edge2 = hitVertex(2) - a;
  surfacePosition = transformPoint(instance + 3, a + edge1 * hitWeight1 + edge2 * hitWeight2);
  vec3 facet = normalize(transformNormal(instance, cross(edge1, edge2)));
  surfaceIsFront = dot(facet, d) < 0.0;
  float side = surfaceIsFront ? 1.0 : -1.0;
  surfaceFacetNormal = facet * side;

  ivec3 at = triangleVertices(mesh, hitTriangle);
  float weight0 = 1.0 - hitWeight1 - hitWeight2;
  vec3 normal = weight0 * loadFloat4(at.x).xyz + hitWeight1 * loadFloat4(at.y).xyz + hitWeight2 * loadFloat4(at.z).xyz;
  normal = transformNormal(instance, normal);
  float length2 = dot(normal, normal);
  vec3 N = length2 > 0.0 ? normal * inversesqrt(length2) * side : surfaceFacetNormal;
  surfaceUv = interpolateUv(mesh, at, hitWeight1, hitWeight2);

  // The tangent: the mesh's own, or around the object's y axis, as lathes leave their marks.
  vec3 corner = loadFloat4(at.x + 1).xyz;
  vec3 tangent = weight0 * corner + hitWeight1 * loadFloat4(at.y + 1).xyz + hitWeight2 * loadFloat4(at.z + 1).xyz;
  float handedness = dot(corner, corner) > 2.0 ? -1.0 : 1.0;
  bool hasTangent = dot(corner, corner) > 0.0;
  tangent = hasTangent ? transformVector(instance + 3, tangent) : cross(transformVector(instance + 3, vec3(0.0, 1.0, 0.0)), N);

  uvec4 maps = loadUint4(surfaceMaterial + 3);
  if ((maps.x | maps.y) != 0u) {
    vec3 T = normalize(tangent);
    vec3 bent = bentNormal(N, T, cross(N, T) * handedness,
      transformVector(instance + 3, edge1), transformVector(instance + 3, edge2), mesh, at);
    float bent2 = dot(bent, bent);
    // A map cannot turn the surface away from itself.
    if (bent2 > 0.0 && dot(bent, surfaceFacetNormal) > 0.0) N = bent * inversesqrt(bent2);
  }
  surfaceN = N;
  vec3 X = tangent - N * dot(N, tangent);
  float x2 = dot(X, X);
  surfaceX = x2 > 1e-12 ? X * inversesqrt(x2) : anyTangent(N);
  surfaceY = cross(N, surfaceX) * (hasTangent ? handedness : 1.0);
  float lift = max(LEAST_COSINE + dot(N, d), 0.0);
  surfaceV = N * lift - d;
  readParameters(int(head.z), int(head.w));
  setParameters(head.x);
  surfaceTransmits = (head.y & TRANSMITS) != 0u;
  if (surfaceTransmits) {
    surfaceIsThin = modelIsThin(head.x);
    surfaceIor = max(modelIor(head.x), 1e-3);
    float around = surroundingIor(surfaceMaterial);
    // A boundary that turns no ray has no formula; from both sides it must be the same boundary.
    if (abs(surfaceIor / around - 1.0) < 0.005) surfaceIor = 1.005 * around;
    if (!surfaceIsThin) setModelIor(head.x, surfaceIsFront ? surfaceIor / around : around / surfaceIor);
  }
}

// What the surface emits towards the ray, in nits.
vec3 emittedRadiance(int material, bool isFront, vec4 uv) {
  uint flags = loadUint4(material).y;
  if ((flags & EMITS) == 0u || (!isFront && (flags & BOTH_SIDES) == 0u)) return vec3(0.0);
  vec3 emitted = loadFloat4(material + 1).xyz;
  int map = int(loadUint4(material + 3).z);
  return map == 0 ? emitted : emitted * sampleTexture(map, uv).xyz;
}

// Reads the values that a material's parameters have at this surface.
void readParameters(int slot, int count) {
  int i = 0;
  while (i < count && i < MAX_PARAMETERS) {
    uvec4 stored = loadUint4(slot + i);
    vec3 value = uintBitsToFloat(stored.xyz);
    if (stored.w != 0u) {
      uint channel = stored.w >> 29u;
      vec4 texel = sampleTexture(int(stored.w & 0x1fffffffu), surfaceUv);
      value *= channel == 4u ? texel.xyz : vec3(channelOf(texel, channel));
    }
    surfaceParameters[i] = value;
    i++;
  }
}

// Where a ray that leaves the surface starts: beside the point, so far that rounding cannot put it back.
// C. Wachter and N. Binder, 2019, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, ch. 6.
float offsetCoordinate(float p, float n) {
  if (abs(p) < 1.0 / 32.0) return p + n * (1.0 / 65536.0);
  int steps = int(256.0 * n);
  return intBitsToFloat(floatBitsToInt(p) + (p < 0.0 ? -steps : steps));
}

vec3 offsetOrigin(vec3 p, vec3 n) {
  return vec3(offsetCoordinate(p.x, n.x), offsetCoordinate(p.y, n.y), offsetCoordinate(p.z, n.z));
}
