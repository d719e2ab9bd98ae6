// The sampler of models that bring none: four lobes, weighed and shaped by a table of the material's own reflection
// (scene/generic-table.ts). Two are cosines, above and below the surface. The others draw the normal h of a facet and
// reflect v about it, or send v through it:
//   J. Dupuy et al., 2015, "Extracting Microfacet-based BRDF Parameters from Arbitrary Materials with Power
//   Iterations", and J. Dupuy and W. Jakob, 2018, "An Adaptive Parameterization for Efficient Material Acquisition and
//   Rendering", for why normals: a highlight keeps its place among them from wherever it is seen.
// Directions are in a frame with z along the normal; v.z > 0. ior is that of the far side over the near one.

const int GENERIC_ROWS = 128;
const int GENERIC_COLUMNS = 32;
const int GENERIC_VIEWS = 16;
const int GENERIC_AZIMUTHS = 4;
// Words of a lobe's cumulative distributions, rounded up to slots, and of its rows.
const int GENERIC_MARGINAL = 132;
const int GENERIC_LOBE = 4356;

// The ways from v to l by a facet.
const int BY_REFLECTION = 0;
const int BY_REFRACTION = 1;
const int THROUGH_SHEET = 2;

// The table's rows are even in x = tan(theta/2)^(1/4): fine enough for the sharpest highlight around the normal.
vec3 gridNormal(float x, vec2 circle) {
  float t = x * x * x * x;
  float scale = 1.0 / (1.0 + t * t);
  return vec3(2.0 * t * scale * circle, (1.0 - t * t) * scale);
}

float gridRow(vec3 h) {
  return sqrt(sqrt(length(h.xy) / (1.0 + h.z)));
}

// Solid angle of normals per unit of x and radian of azimuth.
float gridStretch(float x) {
  float t = x * x * x * x;
  float scale = 4.0 / (1.0 + t * t);
  return scale * scale * t * x * x * x;
}

// v by a facet of normal h, or 0.
vec3 genericDirection(int way, vec3 v, vec3 h, float ior) {
  float VdotH = dot(v, h);
  if (VdotH <= 0.0) return vec3(0.0);
  if (way == BY_REFRACTION) {
    float cosine2 = 1.0 - (1.0 - VdotH * VdotH) / (ior * ior);
    if (cosine2 <= 0.0) return vec3(0.0);
    vec3 l = (VdotH / ior - sqrt(cosine2)) * h - v / ior;
    return l.z < 0.0 ? l : vec3(0.0);
  }
  vec3 l = 2.0 * VdotH * h - v;
  if (l.z <= 0.0) return vec3(0.0);
  return way == BY_REFLECTION ? l : vec3(l.xy, -l.z);
}

// The facet's normal that takes v to l, or 0.
vec3 genericNormal(int way, vec3 v, vec3 l, float ior) {
  vec3 h = way == BY_REFRACTION ? v + ior * l : vec3(l.xy, abs(l.z)) + v;
  float length2 = dot(h, h);
  if (length2 < 1e-12) return vec3(0.0);
  h *= (h.z < 0.0 ? -1.0 : 1.0) * inversesqrt(length2);
  if (way == BY_REFRACTION && (dot(v, h) <= 0.0 || dot(l, h) >= 0.0)) return vec3(0.0);
  return h;
}

// Solid angle of l over that of h (Walter et al., 2007, equations 14 and 17).
float genericSpread(int way, vec3 v, vec3 l, vec3 h, float ior) {
  float VdotH = dot(v, h);
  if (way != BY_REFRACTION) return 4.0 * VdotH;
  float LdotH = dot(l, h);
  float s = VdotH + ior * LdotH;
  return -s * s / (ior * ior * LdotH);
}

// The table's frame about the normal: x and y for a vector's xy. Where nothing depends on the tangent, x is that of v
// and the table is for y > 0; otherwise it is for v in the first quadrant, the others being mirrored.
struct GenericFrame {
  vec2 x;
  vec2 y;
};

GenericFrame genericFrame(vec3 v, bool isRound) {
  if (!isRound) return GenericFrame(vec2(v.x < 0.0 ? -1.0 : 1.0, 0.0), vec2(0.0, v.y < 0.0 ? -1.0 : 1.0));
  float r = length(v.xy);
  vec2 x = r > 0.0 ? v.xy / r : vec2(1.0, 0.0);
  return GenericFrame(x, vec2(-x.y, x.x));
}

// Where the table's four views around v are, in words from the first one's, and their shares.
int genericNodes[4];
float genericShares[4];

void findGenericNodes(vec3 v, bool isRound, int nodeWords) {
  float place = sqrt(min(v.z, 1.0)) * float(GENERIC_VIEWS - 1);
  int view = min(int(place), GENERIC_VIEWS - 2);
  float t = place - float(view);
  int azimuth = 0;
  float s = 0.0;
  if (!isRound) {
    float around = atan(abs(v.y), abs(v.x)) * (2.0 * INV_PI) * float(GENERIC_AZIMUTHS - 1);
    azimuth = min(int(around), GENERIC_AZIMUTHS - 2);
    s = around - float(azimuth);
  }
  for (int i = 0; i < 4; i++) {
    genericNodes[i] = ((azimuth + i / 2) * GENERIC_VIEWS + view + i % 2) * nodeWords;
    genericShares[i] = (i < 2 ? 1.0 - s : s) * (i % 2 == 0 ? 1.0 - t : t);
  }
}

// Words of a view, by the number of the table's lobes that it has.
int genericNodeWords(uint lobes) {
  return 4 + int(lobes) * GENERIC_LOBE;
}

// The first view's word. @param head of the table: azimuths, lobes, sides
int genericFirst(int table, uvec4 head, float ior) {
  int side = head.z > 1u && ior < 1.0 ? 1 : 0;
  return 4 * (table + 1) + side * int(head.x) * GENERIC_VIEWS * genericNodeWords(head.y);
}

// @param table its slot
float genericPdf(int table, vec3 l, vec3 v, float ior, bool isThin) {
  uvec4 head = loadUint4(table);
  bool isBelow = l.z < 0.0;
  if (l.z == 0.0 || (isBelow && head.y < 2u)) return 0.0;
  bool isRound = head.x == 1u;
  int way = !isBelow ? BY_REFLECTION : isThin ? THROUGH_SHEET : BY_REFRACTION;
  vec3 h = genericNormal(way, v, l, ior);
  GenericFrame frame = genericFrame(v, isRound);
  float x = gridRow(h);
  float phi = atan(dot(h.xy, frame.y), dot(h.xy, frame.x)) * (0.5 * INV_PI);
  float turn = isRound ? 2.0 * abs(phi) : phi < 0.0 ? phi + 1.0 : phi;
  int row = min(int(x * float(GENERIC_ROWS)), GENERIC_ROWS - 1);
  int column = clamp(int(turn * float(GENERIC_COLUMNS)), 0, GENERIC_COLUMNS - 1);

  int first = genericFirst(table, head, ior);
  findGenericNodes(v, isRound, genericNodeWords(head.y));
  float cosine = 0.0;
  float inCell = 0.0;
  for (int i = 0; i < 4; i++) {
    if (genericShares[i] == 0.0) continue;
    int node = first + genericNodes[i];
    vec4 weights = loadFloat4(node / 4);
    cosine += genericShares[i] * (isBelow ? weights.z : weights.x);
    float weight = isBelow ? weights.w : weights.y;
    if (weight == 0.0) continue;
    int marginal = node + 4 + (isBelow ? GENERIC_LOBE : 0);
    int conditional = marginal + GENERIC_MARGINAL + row * (GENERIC_COLUMNS + 1) + column;
    float ofRow = loadFloat(marginal + row + 1) - loadFloat(marginal + row);
    inCell += genericShares[i] * weight * ofRow * (loadFloat(conditional + 1) - loadFloat(conditional));
  }
  float density = cosine * abs(l.z) * INV_PI;
  if (inCell > 0.0 && h.z > 0.0)
    density += inCell * (float(GENERIC_ROWS * GENERIC_COLUMNS) * 0.5 * INV_PI)
      / (gridStretch(x) * genericSpread(way, v, l, h, ior));
  return density;
}

vec3 genericSample(int table, vec2 u, vec3 v, float ior, bool isThin) {
  uvec4 head = loadUint4(table);
  bool isRound = head.x == 1u;
  int node = genericFirst(table, head, ior);
  findGenericNodes(v, isRound, genericNodeWords(head.y));
  // One number chooses the view and, stretched back to 0..1, serves a second time, as the other one for the lobe.
  bool isChosen = false;
  float b = u.y;
  for (int i = 0; i < 4; i++) {
    if (isChosen || genericShares[i] == 0.0) continue;
    isChosen = b < genericShares[i];
    if (isChosen) {
      node += genericNodes[i];
      b /= genericShares[i];
    } else b -= genericShares[i];
  }
  // Rounding may leave none: then b is about 0 beyond the last.
  if (!isChosen) return vec3(0.0);
  vec4 weights = loadFloat4(node / 4);
  int lobe = -1;
  float a = u.x;
  for (int i = 0; i < 4; i++) {
    if (lobe >= 0 || weights[i] == 0.0) continue;
    if (a < weights[i]) {
      lobe = i;
      a /= weights[i];
    } else a -= weights[i];
  }
  if (lobe < 0) return vec3(0.0);
  if (lobe == 0 || lobe == 2) {
    // Over the disk, C. Ulbricht's "Malley's method".
    float r = sqrt(a);
    float phi = 2.0 * PI * b;
    float z = sqrt(max(1.0 - a, 0.0));
    return vec3(r * cos(phi), r * sin(phi), lobe == 0 ? z : -z);
  }
  bool isBelow = lobe == 3;
  int way = !isBelow ? BY_REFLECTION : isThin ? THROUGH_SHEET : BY_REFRACTION;
  int marginal = node + 4 + (isBelow ? GENERIC_LOBE : 0);
  int row = findCell(marginal, GENERIC_ROWS, a);
  float low = loadFloat(marginal + row);
  float inRow = (a - low) / max(loadFloat(marginal + row + 1) - low, 1e-30);
  float side = 1.0;
  if (isRound) {
    side = b < 0.5 ? 1.0 : -1.0;
    b = 2.0 * b - (b < 0.5 ? 0.0 : 1.0);
  }
  int conditional = marginal + GENERIC_MARGINAL + row * (GENERIC_COLUMNS + 1);
  int column = findCell(conditional, GENERIC_COLUMNS, b);
  float left = loadFloat(conditional + column);
  float inColumn = (b - left) / max(loadFloat(conditional + column + 1) - left, 1e-30);
  float phi = (float(column) + min(inColumn, 1.0)) * ((isRound ? PI : 2.0 * PI) / float(GENERIC_COLUMNS)) * side;
  GenericFrame frame = genericFrame(v, isRound);
  vec2 circle = cos(phi) * frame.x + sin(phi) * frame.y;
  vec3 h = gridNormal((float(row) + min(inRow, 1.0)) / float(GENERIC_ROWS), circle);
  return genericDirection(way, v, h, ior);
}
