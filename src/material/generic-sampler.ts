import { loadModel } from '../../models/index.ts';
import type { Evaluator, Vector3 } from '../glsl/evaluator.ts';
import type { Model } from '../glsl/model.ts';

/**
 * The sampler of models that bring none: half its directions by the cosine, half by GGX's visible normals
 * with the width of the model's own highlight. Its GLSL is compiled as a model's is.
 */
export const genericSampler: Model = loadModel(
  `analytic
# Cosine and GGX, half and half.
::begin parameters
float alpha .001 1 .5   # width of the highlight, as of GGX
::end parameters
::begin shader
::include lib/frame.glsl
::include lib/half-vector.glsl
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(INV_PI); }
::end shader
::begin sampling
::include lib/sample-cosine.glsl
::include lib/sample-gtr2.glsl
vec3 sampleL(vec2 u, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 v = toFrame(V, N, X, Y);
    if (v.z < HORIZON) return vec3(0.0);
    vec2 circle = unitCircle(u.y);
    if (u.x < 0.5) return sampledDirection(sampleCosine(2.0 * u.x, circle), N, X, Y);
    vec3 h = sampleVisibleGTR2(2.0 * u.x - 1.0, circle, v, vec2(alpha));
    return sampledDirection(2.0 * dot(v, h) * h - v, N, X, Y);
}
float pdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 l = toFrame(L, N, X, Y);
    vec3 v = toFrame(V, N, X, Y);
    if (l.z < HORIZON || v.z < HORIZON) return 0.0;
    vec3 h = halfVector(l, v, halfCosine(l, v));
    return 0.5 * (l.z * INV_PI + pdfVisibleGTR2(h, v, vec2(alpha)));
}
::end sampling
`,
  'generic-sampler.brdf',
);

/** Angles between N and H at which the highlight is looked at, rough to sharp, in radians. */
const STEPS = 64;
const WIDEST = Math.PI / 4;
const NARROWEST = 1e-3;

/**
 * The GGX alpha of a model's highlight with its present parameters, seen along the normal.
 *
 * GGX's D falls to cos^-4 / 4 of its peak where tan(theta_h) = alpha (Walter et al., 2007, equation 33), so
 * alpha is the tangent of the angle where the reflection above its base has fallen to a quarter. The two
 * azimuths of the tangent and the bitangent are looked at; the wider highlight counts, which costs noise
 * but misses nothing.
 *
 * @returns .001 to 1; 1 where there is no highlight
 */
export function highlightAlpha(evaluator: Evaluator): number {
  const V: Vector3 = [0, 0, 1];
  const profile = (thetaH: number, azimuth: number): number => {
    const [s, c] = [Math.sin(2 * thetaH), Math.cos(2 * thetaH)];
    const [r, g, b] = evaluator.f([s * Math.cos(azimuth), s * Math.sin(azimuth), c], V);
    const sum = r + g + b;
    return Number.isFinite(sum) ? sum : 0;
  };
  let alpha = NARROWEST;
  for (const azimuth of [0, Math.PI / 2]) {
    const base = profile(WIDEST * 0.98, azimuth);
    const peak = profile(0, azimuth) - base;
    // Less than a tenth above the base is no highlight worth aiming at.
    if (!(peak > 0.1 * base)) return 1;
    for (let i = 0; i < STEPS; i++) {
      const theta = WIDEST * (NARROWEST / WIDEST) ** (i / (STEPS - 1));
      if (profile(theta, azimuth) - base >= peak / 4) {
        alpha = Math.max(alpha, Math.tan(theta));
        break;
      }
    }
  }
  return Math.min(alpha, 1);
}
