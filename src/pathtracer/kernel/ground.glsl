// A ground that shows the shadows on it and nothing of itself. Where the camera sees it, the background is multiplied by
// the ratio of two irradiances on level ground: of the light that reaches it straight from lamps and sky, and of the light
// that would if there were no objects. The second has a closed form for each light, and the sky's is known beforehand, so
// that one light is chosen by its true share. What is estimated is the part that objects keep off: where they
// keep off nothing there is no noise, and any number of samples gives the right mean.

const vec3 UP = vec3(0.0, 1.0, 0.0);

// How much of its shadows the ground shows at a place: 1 but for the rim.
float groundPresence(vec3 P) {
  vec4 ground = loadFloat4(13);
  if (ground.y <= 0.0) return 1.0;
  float from = ground.y * (1.0 - ground.z);
  float t = clamp((length(P.xz - loadFloat4(15).xy) - from) / max(ground.y - from, 1e-6 * ground.y), 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

// How far along a ray from above the ground is; 0 where it is not.
float groundDistance(vec3 o, vec3 d) {
  if (loadFloat4(15).z == 0.0 || d.y >= 0.0) return 0.0;
  float t = (loadFloat4(13).x - o.y) / d.y;
  return t > 0.0 && groundPresence(o + d * t) > 0.0 ? t : 0.0;
}

// The irradiance of a rectangle of radiance 1 on level ground, by the edges of its part above it (J. H. Lambert, 1760).
float rectangleFactor(int slot, vec3 P) {
  vec3 toCentre = loadFloat4(slot + 2).xyz - P;
  if (dot(toCentre, loadFloat4(slot + 3).xyz) >= 0.0) return 0.0;
  vec3 x = loadFloat4(slot + 4).xyz;
  vec3 y = loadFloat4(slot + 5).xyz;
  vec3 corner[5];
  int corners = 0;
  vec3 a = toCentre - x - y;
  int i = 0;
  while (i < 4) {
    vec3 b = toCentre + (i == 0 || i == 1 ? x : -x) + (i == 1 || i == 2 ? y : -y);
    if (a.y > 0.0) {
      corner[corners] = a;
      corners++;
    }
    if (a.y > 0.0 != b.y > 0.0) {
      corner[corners] = mix(a, b, a.y / (a.y - b.y));
      corners++;
    }
    a = b;
    i++;
  }
  float sum = 0.0;
  i = 0;
  while (i < corners) {
    vec3 from = corner[i];
    vec3 to = corner[i + 1 < corners ? i + 1 : 0];
    vec3 side = cross(from, to);
    float sine = length(side);
    // The angle times the unit vector's component.
    if (sine > 0.0) sum += atan(sine, dot(from, to)) * side.y / sine;
    i++;
  }
  return 0.5 * abs(sum);
}

// The irradiance of a lamp on level ground.
vec3 levelIrradiance(int slot, vec3 P) {
  if (loadUint4(slot).x == RECTANGLE) return loadFloat4(slot + 1).xyz * rectangleFactor(slot, P);
  if (!towardsLight(slot, P, vec2(0.5))) return vec3(0.0);
  return lightRadiance * max(lightDirection.y, 0.0);
}

// A lamp by its number: the near ones first, then those that are infinitely far away.
int lampSlot(int lamp) {
  int near = int(loadUint4(9).z);
  return lamp < near ? int(loadUint4(1).x) + 6 * lamp : int(loadUint4(2).x) + 6 * (lamp - near);
}

// The part of the irradiance at a place on the ground that objects keep off, by channel: one sample, which may be more
// than 1 where its light is brighter than most of the lamp or the sky.
vec3 groundOcclusion(vec3 P) {
  uvec4 infinite = loadUint4(2);
  int lamps = int(loadUint4(9).z + infinite.y) - (infinite.w == NONE ? 0 : 1);
  vec4 sky = loadFloat4(14);
  chosenProbability = 1.0;
  vec3 whole = sky.xyz;
  int lamp = 0;
  while (lamp < lamps) {
    whole += levelIrradiance(lampSlot(lamp), P);
    lamp++;
  }
  vec3 isLit = vec3(whole.x > 0.0 ? 1.0 : 0.0, whole.y > 0.0 ? 1.0 : 0.0, whole.z > 0.0 ? 1.0 : 0.0);
  vec3 unit = isLit / max(whole, vec3(1e-30));
  float channels = dot(isLit, vec3(1.0));
  float left = random1() * channels;
  vec2 uv = random2();
  // By a light's mean share of the three channels.
  float weight = 0.0;
  vec3 share;
  lamp = 0;
  while (lamp < lamps) {
    share = levelIrradiance(lampSlot(lamp), P) * unit;
    weight = dot(share, vec3(1.0));
    if (left < weight) break;
    left -= weight;
    lamp++;
  }
  vec3 o = offsetOrigin(P, UP);
  if (lamp == lamps) {
    share = sky.xyz * unit;
    weight = dot(share, vec3(1.0));
    if (weight <= 0.0) return vec3(0.0);
    vec3 d = sampleSkyRows(int(loadUint4(14).w), uv);
    if (d.y <= 0.0 || skySampleDensity <= 0.0) return vec3(0.0);
    float hidden = 1.0 - traceShadow(o, d, INFINITY);
    return skyRadiance(d) * unit * (hidden * d.y / skySampleDensity * channels / weight);
  }
  int slot = lampSlot(lamp);
  if (!towardsLight(slot, P, uv) || lightPassesThrough || shadowDirection.y <= 0.0) return vec3(0.0);
  float hidden = 1.0 - traceShadow(o, shadowDirection, shadowDistance * 0.9999);
  if (!lightIsDelta) share = lightRadiance * unit * (lightDirection.y / lightDensity);
  return share * (hidden * channels / weight);
}

// By what the background is multiplied where the ground is before it.
vec3 groundShade(vec3 P) {
  float shown = loadFloat4(13).w * groundPresence(P);
  if (shown <= 0.0) return vec3(1.0);
  return vec3(1.0) - groundOcclusion(P) * shown;
}
