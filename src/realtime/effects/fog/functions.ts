/** How light goes through fog, as functions of shaders. */
import type { Node } from 'three/webgpu';
import { glslFunction } from '../../../glsl/tsl.ts';
import air from '../../../lights/air.glsl?raw';
import lamp from '../../../lights/lamp.glsl?raw';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** Of one way; `fog` is density, anisotropy, height and base. */
const transmittance = `${air}
float fogTransmittance(vec4 sphere, vec4 fog, vec3 o, vec3 d, float far) {
  vec2 way = airSegment(sphere, o, d, far);
  return exp(-fog.x * airLength(o.y + d.y * way.x - fog.w, d.y, way.y - way.x, fog.z));
}`;

export const fogTransmittance = glslFunction(transmittance) as unknown as (
  sphere: Vec4,
  fog: Vec4,
  o: Vec3,
  d: Vec3,
  far: Float,
) => Float;

/** Where a ray is in the fog and may be lit by a lamp: its range and its cone are convex, so it is one piece. */
export const litWay = glslFunction(`${air}
vec2 litWay(vec4 sphere, vec3 o, vec3 d, float far, vec4 place, float inverseRange4, vec4 axis) {
  vec2 way = airSegment(sphere, o, d, far);
  if (place.w < 0.5) return way;
  if (inverseRange4 > 0.0) {
    vec2 near = airSegment(vec4(place.xyz, sqrt(inversesqrt(inverseRange4))), o, d, far);
    way = vec2(max(way.x, near.x), min(way.y, near.y));
  }
  vec3 q = o - place.xyz;
  float across = dot(q, axis.xyz);
  float along = dot(d, axis.xyz);
  if (place.w > 1.5) {
    // Before a rectangle.
    float t = -across / (abs(along) > 1e-9 ? along : 1e-9);
    return along > 0.0 ? vec2(max(way.x, t), way.y) : vec2(way.x, min(way.y, t));
  }
  if (axis.w < -1.5) return way;
  // dot(x, axis) >= c |x| for x = q + t d: a t^2 + 2 b t + c >= 0 in front of the lamp.
  float c2 = axis.w * axis.w;
  float a = along * along - c2;
  if (abs(a) < 1e-7) a = -1e-7;
  float b = across * along - c2 * dot(q, d);
  float c = across * across - c2 * dot(q, q);
  float discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    if (axis.w > 1e-4) return vec2(1.0, 0.0);
    discriminant = 0.0;
  }
  float root = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
  float t1 = root / a;
  float t2 = root == 0.0 ? t1 : c / root;
  float low = min(t1, t2);
  float high = max(t1, t2);
  if (a > 0.0) return along > 0.0 ? vec2(max(way.x, high), way.y) : vec2(way.x, min(way.y, low));
  if (across + 0.5 * (low + high) * along < 0.0) return vec2(1.0, 0.0);
  return vec2(max(way.x, low), min(way.y, high));
}`) as unknown as (
  sphere: Vec4,
  fog: Vec3,
  d: Vec3,
  far: Float,
  place: Vec4,
  inverseRange4: Float,
  axis: Vec4,
) => Vec2;

/**
 * A place on a lit way, and its weight: extinction and what is left of its light on the way to the camera, over how densely
 * places are drawn. Of far light, by what the fog does; else by the lamp's distance (C. Kulla and M. Fajardo, 2012,
 * "Importance Sampling Techniques for Path Tracing in Participating Media", CGF 31(4), equiangular sampling).
 */
export const airSample = glslFunction(`${transmittance}
vec2 airSample(float u, vec4 sphere, vec4 fog, vec3 o, vec3 d, vec2 way, vec4 place) {
  float before = fogTransmittance(sphere, fog, o, d, way.x);
  float y = o.y + d.y * way.x - fog.w;
  if (place.w < 0.5) {
    float depth = fog.x * airLength(y, d.y, way.y - way.x, fog.z);
    float part = depth < 0.01 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
    float x = u * part;
    float passed = x < 0.01 ? x * (1.0 + x * (0.5 + x / 3.0)) : -log(1.0 - x);
    float t = way.x + min(airWay(y, d.y, passed / fog.x, fog.z), way.y - way.x);
    return vec2(t, before * part);
  }
  vec3 toLamp = place.xyz - o;
  float nearest = dot(toLamp, d);
  // Not on the ray itself, where the angles would run out of digits.
  float away = max(length(toLamp - d * nearest), 1e-3 * (way.y - way.x));
  float from = atan((way.x - nearest) / away);
  float to = atan((way.y - nearest) / away);
  float x = away * tan(mix(from, to, u));
  float t = clamp(nearest + x, way.x, way.y);
  float left = before * exp(-fog.x * airLength(y, d.y, t - way.x, fog.z));
  return vec2(t, fog.x * airDensity(y + d.y * (t - way.x), fog.z) * left * (to - from) * (away + x * x / away));
}`) as unknown as (u: Float, sphere: Vec4, fog: Vec4, o: Vec3, d: Vec3, way: Vec2, place: Vec4) => Vec2;

/** What of a lamp's light is turned towards the camera at P, per unit of scattering. @param d the way from the camera */
export const scattered = glslFunction(`${transmittance}
${lamp}
float triangleAngle(vec3 a, vec3 b, vec3 c) {
  // A. Van Oosterom and J. Strackee, 1983, "The Solid Angle of a Plane Triangle", equation 8. For unit vectors.
  return 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
}
vec3 scattered(vec3 P, vec3 d, vec4 sphere, vec4 fog, vec4 place, vec4 power, vec4 axis, vec4 edge,
    vec3 halfWidth, vec3 halfHeight, float least) {
  vec3 L = -axis.xyz;
  float far = 1e30;
  vec3 light = power.xyz;
  if (place.w > 0.5) {
    vec3 toLamp = place.xyz - P;
    float r = max(length(toLamp), least);
    L = toLamp / r;
    far = r;
    if (place.w > 1.5) {
      if (dot(axis.xyz, L) >= 0.0) return vec3(0.0);
      vec3 a = normalize(toLamp - halfWidth - halfHeight);
      vec3 b = normalize(toLamp + halfWidth - halfHeight);
      vec3 c = normalize(toLamp + halfWidth + halfHeight);
      vec3 e = normalize(toLamp - halfWidth + halfHeight);
      light *= triangleAngle(a, b, c) + triangleAngle(a, c, e);
    } else {
      light = lampIrradiance(L, 1.0 / r, power, axis, edge);
    }
  }
  if (light.x + light.y + light.z <= 0.0) return vec3(0.0);
  return light * (phase(dot(d, L), fog.y) * fogTransmittance(sphere, fog, P, L, far));
}`) as unknown as (
  P: Vec3,
  d: Vec3,
  sphere: Vec4,
  fog: Vec4,
  place: Vec4,
  power: Vec4,
  axis: Vec4,
  edge: Vec4,
  halfWidth: Vec3,
  halfHeight: Vec3,
  least: Float,
) => Vec3;
