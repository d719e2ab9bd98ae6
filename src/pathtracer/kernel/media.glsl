// What fills space: fog in the scene's bounding sphere (src/lights/air.glsl), and the insides of transparent bodies.

// The bodies that a path is in, the last one entered on top. Where bodies overlap the one entered later counts.
const int MEDIA = 4;
int mediumCount;
int mediumMaterial[MEDIA];
float mediumIor[MEDIA];
vec3 mediumExtinction[MEDIA];   // 1/m
vec3 mediumAlbedo[MEDIA];       // of a single scattering
float mediumAnisotropy[MEDIA];

// The medium around the present point.
vec3 spaceExtinction;
vec3 spaceAlbedo;
float spaceAnisotropy;

void findSpace() {
  if (mediumCount > 0) {
    spaceExtinction = mediumExtinction[mediumCount - 1];
    spaceAlbedo = mediumAlbedo[mediumCount - 1];
    spaceAnisotropy = mediumAnisotropy[mediumCount - 1];
  } else {
    vec4 fog = loadFloat4(7);
    spaceExtinction = vec3(fog.x);
    spaceAlbedo = loadFloat4(8).xyz;
    spaceAnisotropy = fog.y;
  }
}

// The index of refraction at the top, but for the topmost entry of one material (~0: none left out).
float surroundingIor(int material) {
  int i = mediumCount - 1;
  if (i >= 0 && mediumMaterial[i] == material) i--;
  return i < 0 ? 1.0 : mediumIor[i];
}

// Leaves the body of a material.
void leaveMedium(int material) {
  int i = mediumCount - 1;
  while (i >= 0 && mediumMaterial[i] != material) i--;
  if (i < 0) return;
  while (i < mediumCount - 1) {
    mediumMaterial[i] = mediumMaterial[i + 1];
    mediumIor[i] = mediumIor[i + 1];
    mediumExtinction[i] = mediumExtinction[i + 1];
    mediumAlbedo[i] = mediumAlbedo[i + 1];
    mediumAnisotropy[i] = mediumAnisotropy[i + 1];
    i++;
  }
  mediumCount--;
}

// Enters a body. Beyond MEDIA nested ones the rest counts as air.
void enterMedium(int material, float ior, vec3 extinction, vec3 albedo, float anisotropy) {
  if (mediumCount >= MEDIA) return;
  mediumMaterial[mediumCount] = material;
  mediumIor[mediumCount] = ior;
  mediumExtinction[mediumCount] = extinction;
  mediumAlbedo[mediumCount] = albedo;
  mediumAnisotropy[mediumCount] = anisotropy;
  mediumCount++;
}

// Where a ray is in the medium around its beginning: from x to y, y < x if nowhere.
vec2 spaceSegment(vec3 o, vec3 d, float far) {
  return mediumCount > 0 ? vec2(0.0, far) : airSegment(loadFloat4(6), o, d, far);
}

// The height in which fog thins by e; 0 in what is even.
float spaceScale() {
  return mediumCount > 0 ? 0.0 : loadFloat4(7).z;
}

// In metres of the medium where it is densest.
float spaceLength(vec3 o, vec3 d, vec2 segment) {
  float y = o.y + d.y * segment.x - loadFloat4(7).w;
  return airLength(y, d.y, segment.y - segment.x, spaceScale());
}

vec3 spaceTransmittance(vec3 o, vec3 d, float far) {
  if (largest(spaceExtinction) == 0.0) return vec3(1.0);
  return exp(-spaceExtinction * spaceLength(o, d, spaceSegment(o, d, far)));
}

vec3 samplePhase(vec2 u, vec3 d, float g) {
  float s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u.x);
  float cosine = abs(g) < 1e-3 ? 1.0 - 2.0 * u.x : clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 X = anyTangent(d);
  vec3 Y = cross(d, X);
  return X * (sine * cos(2.0 * PI * u.y)) + Y * (sine * sin(2.0 * PI * u.y)) + d * cosine;
}

// What a path keeps, by channel, of a way through a medium, and where it scattered.
float scatterDistance;    // -1: nowhere

// Draws the distance by the extinction of one channel, itself drawn by what the path has left of each; the weights of
// all three are then those of the balance heuristic (M. Pharr et al., 2023, section 14.2.2). What is uneven is so by
// the same factor in all channels: the length through it is drawn. @param segment of the way, by spaceSegment()
vec3 crossSpace(vec3 throughput, vec3 o, vec3 d, vec2 segment) {
  scatterDistance = -1.0;
  if (segment.y <= segment.x || largest(spaceExtinction) == 0.0) return vec3(1.0);
  float way = spaceLength(o, d, segment);
  if (largest(spaceAlbedo) == 0.0) return exp(-spaceExtinction * way);
  vec2 u = random2();
  vec3 share = throughput / (throughput.x + throughput.y + throughput.z);
  float extinction = u.x < share.x ? spaceExtinction.x : u.x < share.x + share.y ? spaceExtinction.y : spaceExtinction.z;
  float length_ = extinction > 0.0 ? -log(1.0 - u.y) / extinction : INFINITY;
  if (length_ >= way) {
    vec3 left = exp(-spaceExtinction * way);
    return left / dot(share, left);
  }
  float y = o.y + d.y * segment.x - loadFloat4(7).w;
  scatterDistance = segment.x + min(airWay(y, d.y, length_, spaceScale()), segment.y - segment.x);
  vec3 arrived = exp(-spaceExtinction * length_) * spaceExtinction;
  return arrived * spaceAlbedo / dot(share, arrived);
}
