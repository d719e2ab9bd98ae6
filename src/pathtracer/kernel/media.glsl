// What fills space: homogeneous fog in the scene's bounding sphere, and the insides of transparent bodies.

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
  if (mediumCount > 0) return vec2(0.0, far);
  vec4 sphere = loadFloat4(6);
  vec3 toCentre = sphere.xyz - o;
  float along = dot(toCentre, d);
  float half2 = sphere.w * sphere.w - dot(toCentre, toCentre) + along * along;
  if (half2 <= 0.0) return vec2(1.0, 0.0);
  float half1 = sqrt(half2);
  return vec2(max(along - half1, 0.0), min(along + half1, far));
}

vec3 spaceTransmittance(vec3 o, vec3 d, float far) {
  if (largest(spaceExtinction) == 0.0) return vec3(1.0);
  vec2 segment = spaceSegment(o, d, far);
  return exp(-spaceExtinction * max(segment.y - segment.x, 0.0));
}

// L. G. Henyey and J. L. Greenstein, 1941: the density in 1/sr of scattering by an angle. g > 0 is forward.
float phase(float cosine, float g) {
  float base = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (4.0 * PI * base * sqrt(base));
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
// all three are then those of the balance heuristic (M. Pharr et al., 2023, section 14.2.2). @param far of the way
vec3 crossSpace(vec3 throughput, vec2 segment) {
  scatterDistance = -1.0;
  float way = segment.y - segment.x;
  if (way <= 0.0 || largest(spaceExtinction) == 0.0) return vec3(1.0);
  if (largest(spaceAlbedo) == 0.0) return exp(-spaceExtinction * way);
  vec2 u = random2();
  vec3 share = throughput / (throughput.x + throughput.y + throughput.z);
  float extinction = u.x < share.x ? spaceExtinction.x : u.x < share.x + share.y ? spaceExtinction.y : spaceExtinction.z;
  float distance = extinction > 0.0 ? -log(1.0 - u.y) / extinction : INFINITY;
  if (distance >= way) {
    vec3 left = exp(-spaceExtinction * way);
    return left / dot(share, left);
  }
  scatterDistance = segment.x + distance;
  vec3 arrived = exp(-spaceExtinction * distance) * spaceExtinction;
  return arrived * spaceAlbedo / dot(share, arrived);
}
