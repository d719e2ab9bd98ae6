// Rays through the two trees: instances, and each mesh's triangles. Nodes have 4 children, blocks 4 triangles:
// four lanes of one vector instruction on a CPU.

const uint LEAF = 0x80000000u;
const int STACK = 96;

// A material's flags.
const uint BOTH_SIDES = 1u;
const uint MASK = 2u;
const uint BLEND = 4u;
const uint EMITS = 8u;
const uint ALPHA = 6u;  // MASK or BLEND

// The nearest hit.
float hitDistance;
int hitInstance;     // -1: none
int hitBlock;
int hitLane;
float hitWeight1;    // barycentric coordinates of v1 and v2
float hitWeight2;
uint hitTriangle;

// For sampling coverage: distinct for each ray.
uint rayKey;

vec3 transformPoint(int rows, vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(dot(loadFloat4(rows), q), dot(loadFloat4(rows + 1), q), dot(loadFloat4(rows + 2), q));
}

vec3 transformVector(int rows, vec3 v) {
  return vec3(
    dot(loadFloat4(rows).xyz, v),
    dot(loadFloat4(rows + 1).xyz, v),
    dot(loadFloat4(rows + 2).xyz, v));
}

// By the transposed matrix: of world to object, what normals need.
vec3 transformNormal(int rows, vec3 n) {
  return loadFloat4(rows).xyz * n.x + loadFloat4(rows + 1).xyz * n.y + loadFloat4(rows + 2).xyz * n.z;
}

// 1/x that stays finite: 0 times it must not be NaN.
vec3 inverseDirection(vec3 d) {
  return vec3(
    1.0 / (abs(d.x) > 1e-20 ? d.x : 1e-20),
    1.0 / (abs(d.y) > 1e-20 ? d.y : 1e-20),
    1.0 / (abs(d.z) > 1e-20 ? d.z : 1e-20));
}

// Where the ray enters the four children of a node, and from where on it has left them again: a child is missed
// where it leaves before it enters. The factor covers the rounding of both (M. Pharr et al., 2023, "Physically Based
// Rendering", section 6.8.2: 1 + 2 gamma(3)). Macros, here and below, because a call in these loops costs more than
// what it does.
#define INTERSECT_NODE(node, o, inverse, limit) \
  int nearX = inverse.x < 0.0 ? 1 : 0; \
  int nearY = inverse.y < 0.0 ? 1 : 0; \
  int nearZ = inverse.z < 0.0 ? 1 : 0; \
  vec4 enter = max( \
    max((loadFloat4(node + nearX) - o.x) * inverse.x, (loadFloat4(node + 2 + nearY) - o.y) * inverse.y), \
    max((loadFloat4(node + 4 + nearZ) - o.z) * inverse.z, vec4(0.0))); \
  vec4 leave = min( \
    min((loadFloat4(node + 1 - nearX) - o.x) * inverse.x, (loadFloat4(node + 3 - nearY) - o.y) * inverse.y), \
    min((loadFloat4(node + 5 - nearZ) - o.z) * inverse.z, vec4(limit))) * 1.0000004;

// A child that is hit: the nearest is next, the others wait.
#define VISIT(lane) \
  if (enter.lane <= leave.lane) { \
    if (nearest == NONE) { \
      nearest = children.lane; \
      least = enter.lane; \
    } else if (top < STACK) { \
      bool isNearer = enter.lane < least; \
      stack[top] = isNearer ? nearest : children.lane; \
      enters[top] = isNearer ? least : enter.lane; \
      nearest = isNearer ? children.lane : nearest; \
      least = isNearer ? enter.lane : least; \
      top++; \
    } \
  }

// Goes on with the nearest child or what waits. What has come to lie behind the nearest hit is left out.
#define NEXT_NODE(blocked) \
  if (nearest == NONE) { \
    while (top > 0 && nearest == NONE) { \
      top--; \
      if (enters[top] <= hitDistance) nearest = stack[top]; \
    } \
    if (nearest == NONE) return blocked; \
  } \
  current = nearest;

// What lies behind a material's alpha, from 0 (nothing) to 1; in material.glsl.
float surfaceCoverage(int instance, uint triangle, float weight1, float weight2);

// Whether a ray hits a surface that is there only in part: by chance, without bias. Shadow rays take the whole
// (shadowTransmittance).
bool isCovered(float coverage, int instance, uint triangle) {
  if (coverage >= 1.0) return true;
  uint key = mixBits(rayKey ^ (triangle * 0x9e3779b9u) ^ (uint(instance) << 20u));
  return float(key >> 8u) * (1.0 / 16777216.0) < coverage;
}

#define CANDIDATE(lane_, number) \
  if (inside.lane_ >= 0.0 && t.lane_ < nearest) { \
    nearest = t.lane_; \
    lane = number; \
  }

// What light is left behind the surfaces with alpha that a shadow ray met.
float shadowTransmittance;

// The triangles of a block, by the signs of the volumes that their edges span with the ray: they are exactly
// opposite on both sides of a shared edge, so nothing leaks (I. Wald et al., 2014, "Embree", ACM TOG 33(4)).
// @returns whether a shadow ray may stop
bool intersectBlock(int block, vec3 o, vec3 d, int instance, uint flags, bool isShadow) {
  vec4 ax = loadFloat4(block) - o.x;
  vec4 ay = loadFloat4(block + 1) - o.y;
  vec4 az = loadFloat4(block + 2) - o.z;
  vec4 bx = loadFloat4(block + 3) - o.x;
  vec4 by = loadFloat4(block + 4) - o.y;
  vec4 bz = loadFloat4(block + 5) - o.z;
  vec4 cx = loadFloat4(block + 6) - o.x;
  vec4 cy = loadFloat4(block + 7) - o.y;
  vec4 cz = loadFloat4(block + 8) - o.z;
  // Edges ca, ab, bc and the sums of their ends: twice the volumes that they span with the ray.
  vec4 px = cx - ax;
  vec4 py = cy - ay;
  vec4 pz = cz - az;
  vec4 qx = ax - bx;
  vec4 qy = ay - by;
  vec4 qz = az - bz;
  vec4 rx = bx - cx;
  vec4 ry = by - cy;
  vec4 rz = bz - cz;
  vec4 ux = cx + ax;
  vec4 uy = cy + ay;
  vec4 uz = cz + az;
  vec4 vx = ax + bx;
  vec4 vy = ay + by;
  vec4 vz = az + bz;
  vec4 wx = bx + cx;
  vec4 wy = by + cy;
  vec4 wz = bz + cz;
  vec4 u = (py * uz - pz * uy) * d.x + (pz * ux - px * uz) * d.y + (px * uy - py * ux) * d.z;
  vec4 v = (qy * vz - qz * vy) * d.x + (qz * vx - qx * vz) * d.y + (qx * vy - qy * vx) * d.z;
  vec4 w = (ry * wz - rz * wy) * d.x + (rz * wx - rx * wz) * d.y + (rx * wy - ry * wx) * d.z;
  vec4 least = min(u, min(v, w));
  vec4 most = max(u, max(v, w));
  // Ng = p x q: the front is where d.Ng < 0.
  vec4 nx = py * qz - pz * qy;
  vec4 ny = pz * qx - px * qz;
  vec4 nz = px * qy - py * qx;
  vec4 facing = nx * d.x + ny * d.y + nz * d.z;
  vec4 t = (ax * nx + ay * ny + az * nz) / facing;
  // Inside where all volumes have one sign, in front of the origin, nearer than the last hit. What has no area
  // has no facing.
  vec4 inside = min(max(least, -most), min(t, hitDistance - t));
  inside = mix(vec4(-1.0), inside, notEqual(facing, vec4(0.0)));
  if (!any(greaterThanEqual(inside, vec4(0.0)))) return false;
  uvec4 triangles = loadUint4(block + 9);
  vec4 sum = u + v + w;
  vec4 weight1 = u / sum;
  vec4 weight2 = v / sum;
  // One after the other, the nearest first.
  while (true) {
    int lane = -1;
    float nearest = hitDistance;
    CANDIDATE(x, 0)
    CANDIDATE(y, 1)
    CANDIDATE(z, 2)
    CANDIDATE(w, 3)
    if (lane < 0) return false;
    bool isFront = facing[lane] < 0.0;
    uint triangle = triangles[lane];
    inside[lane] = -1.0;
    if (!isFront && (flags & BOTH_SIDES) == 0u) continue;
    float coverage = 1.0;
    if ((flags & ALPHA) != 0u) coverage = surfaceCoverage(instance, triangle, weight1[lane], weight2[lane]);
    if (isShadow) {
      shadowTransmittance *= 1.0 - coverage;
      if (shadowTransmittance <= 0.0) return true;
    } else if (isCovered(coverage, instance, triangle)) {
      hitDistance = nearest;
      hitInstance = instance;
      hitBlock = block;
      hitLane = lane;
      hitWeight1 = weight1[lane];
      hitWeight2 = weight2[lane];
      hitTriangle = triangle;
      return false;
    }
  }
  return false;
}

// A mesh's triangles, in its own space. @returns whether a shadow ray is blocked
bool traceMesh(int root, vec3 o, vec3 d, int instance, uint flags, bool isShadow) {
  vec3 inverse = inverseDirection(d);
  uint stack[STACK];
  float enters[STACK];
  int top = 0;
  uint current = uint(root);
  while (true) {
    uint nearest = NONE;
    if ((current & LEAF) != 0u) {
      if (intersectBlock(int(current & ~LEAF), o, d, instance, flags, isShadow)) return true;
    } else {
      int node = int(current);
      float least = INFINITY;
      INTERSECT_NODE(node, o, inverse, hitDistance)
      if (any(lessThanEqual(enter, leave))) {
        uvec4 children = loadUint4(node + 6);
        VISIT(x)
        VISIT(y)
        VISIT(z)
        VISIT(w)
      }
    }
    NEXT_NODE(false)
  }
  return false;
}

// All instances. @returns whether a shadow ray is blocked
bool traceInstances(vec3 o, vec3 d, bool isShadow) {
  uvec4 header = loadUint4(0);
  if (header.w == 0u) return false;
  vec3 inverse = inverseDirection(d);
  uint stack[STACK];
  float enters[STACK];
  int top = 0;
  uint current = header.x;
  while (true) {
    uint nearest = NONE;
    if ((current & LEAF) != 0u) {
      int index = int(current & ~LEAF);
      int instance = int(header.y) + 8 * index;
      uvec4 parts = loadUint4(instance + 6);
      uint flags = loadUint4(int(parts.y)).y;
      int root = int(loadUint4(int(parts.x)).x);
      // Distances along the ray are the same in both spaces, since d is not made a unit vector again.
      vec3 localO = transformPoint(instance, o);
      vec3 localD = transformVector(instance, d);
      if (traceMesh(root, localO, localD, index, flags, isShadow)) return true;
    } else {
      int node = int(current);
      float least = INFINITY;
      INTERSECT_NODE(node, o, inverse, hitDistance)
      if (any(lessThanEqual(enter, leave))) {
        uvec4 children = loadUint4(node + 6);
        VISIT(x)
        VISIT(y)
        VISIT(z)
        VISIT(w)
      }
    }
    NEXT_NODE(false)
  }
  return false;
}

// The nearest surface along a ray, in the hit variables. @param d of length 1
bool traceRay(vec3 o, vec3 d) {
  hitDistance = INFINITY;
  hitInstance = -1;
  rayKey = mixBits(sampleSeed ^ sampleBlock ^ (sampleDimension * 0x85ebca6bu));
  traceInstances(o, d, false);
  return hitInstance >= 0;
}

// The part of the light that comes through up to the given distance.
float traceShadow(vec3 o, vec3 d, float distance) {
  hitDistance = distance;
  shadowTransmittance = 1.0;
  return traceInstances(o, d, true) ? 0.0 : shadowTransmittance;
}
