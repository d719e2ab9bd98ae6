/** What a surface reflects of ambient light and of the environment, as far as they reach it. */
import { dot, float, If, smoothstep, uniform, vec2, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import { AlbedoNode } from './albedo-table.ts';
import type { EnvironmentLightNode } from './environment-light.ts';
import type { FrameContext, OpenSky } from './frame-context.ts';
import { openTowards } from './open-towards.ts';
import { latticePoint, type Sampler } from './sampler.ts';
import type { ShadingFrame } from './shading-frame.ts';
import { repeat } from './statements.ts';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** Directions per fragment for the environment, unless `scene.userData.environmentSamples` says another. */
const DEFAULT_ENVIRONMENT_SAMPLES = 32;
const environmentSamples = uniform(DEFAULT_ENVIRONMENT_SAMPLES).onRenderUpdate(({ scene }) => {
  const samples: unknown = scene?.userData.environmentSamples;
  return typeof samples === 'number' ? samples : DEFAULT_ENVIRONMENT_SAMPLES;
}) as unknown as Float;

/** Directions where ambient light alone is looked at: what is in its way is all that varies with them. */
const AMBIENT_SAMPLES = 8;

/**
 * Densities of directions, in 1/sr, between which they turn from a part of a wide lobe to one of a highlight: a cosine lobe
 * has 1/pi = .32 at most, GGX of roughness .5 (alpha .25) has 1/(4 pi alpha^2) = 1.3 in its middle.
 */
const WIDE = 0.4;
const SHARP = 1.2;

/** How much a direction that has this density belongs to a highlight: 0..1. */
export function sharpness(density: Float): Float {
  return smoothstep(WIDE, SHARP, density) as unknown as Float;
}

export interface Reflector {
  readonly frame: ShadingFrame;
  readonly sampler: Sampler;
  /** Whether the albedo table holds for the material. */
  readonly hasTable: boolean;
  f(L: Vec3): Vec3;
}

/**
 * The environment is gathered by filtered importance sampling. Its samples are normalised by their own weights and R(v) from
 * the table: a constant environment then comes out exact, whatever the number of samples, and any other with less noise.
 * Ambient light is the same from everywhere: its reflection is R(v) times it.
 *
 * @param ambient radiance of ambient light; null if there is none
 */
export function lightFromEverywhere(
  { frame, sampler, hasTable, f }: Reflector,
  environment: EnvironmentLightNode | null,
  ambient: Vec3 | null,
  { openSky, tracedLight }: FrameContext,
): Vec3 {
  const { V, N, X, Y } = frame;
  const isFar = environment !== null || ambient !== null;
  const traced = tracedLight?.incident() ?? vec3(0);
  const albedo = hasTable ? albedoOf(frame) : null;
  // Where rays are traced, they have found what is in the way.
  const isTraced = tracedLight?.reflections && tracedLight.indirectLight;
  const open = isFar && !isTraced ? openSky?.() : undefined;
  if (albedo && !environment && !open) return albedo.mul(traced.add(ambient ?? vec3(0)).max(0)) as Vec3;

  const samples = environment || !hasTable ? environmentSamples : float(AMBIENT_SAMPLES);
  const isOpen = open && !tracedLight?.reflections ? openTowards(open, frame) : null;
  sampler.start(V, N, X, Y);
  // Of wide lobes and of highlights; without anything in the way all is in the first.
  const [wide, sharp, weights] = [vec3(0).toVar(), vec3(0).toVar(), vec3(0).toVar()] as [Vec3, Vec3, Vec3];
  /** What highlights would see where something is in the way. */
  const closed = vec3(0).toVar() as Vec3;
  const add = (sum: Vec3, value: Vec3) =>
    (sum as unknown as { addAssign(value: Node): void }).addAssign(value);
  repeat(samples, (i) => {
    const u = latticePoint(i, samples);
    const L = sampler.sampleL(vec2(u.x, u.y) as unknown as Node<'vec2'>, V, N, X, Y).toVar() as Vec3;
    const cosine = dot(N, L).toVar();
    If(cosine.greaterThan(0), () => {
      const density = sampler.pdf(L, V, N, X, Y).toVar() as Float;
      If(density.greaterThan(0), () => {
        const weight = f(L).mul(cosine.div(density)).toVar() as Vec3;
        add(weights, weight);
        const radiance = sumOf(environment?.radiance(L, density.mul(samples) as Float), ambient);
        if (!open) {
          add(wide, weight.mul(radiance) as Vec3);
          return;
        }
        const incident = weight.mul(radiance).toVar() as Vec3;
        const part = sharpness(density).toVar() as Float;
        add(wide, incident.mul(part.oneMinus()) as Vec3);
        const highlight = incident.mul(part).toVar() as Vec3;
        if (!isOpen) {
          add(sharp, highlight);
          return;
        }
        const towards = isOpen(L).toVar() as Float;
        add(sharp, highlight.mul(towards) as Vec3);
        add(closed, highlight.mul(towards.oneMinus()) as Vec3);
      });
    });
  });
  const mean = albedo ? albedo.div(weights.max(1e-9)) : float(1).div(samples);
  const reflectance = albedo ?? (weights.div(samples) as Vec3);
  let arrives = wide.add(sharp) as Vec3;
  if (open) {
    const part = reaching(open, reflectance).toVar() as Vec3;
    // What is in the way is taken to reflect as the surface does, and to get as much light.
    const bounced = closed.mul(reflectance).mul(part).mul(open.bounces);
    arrives = (tracedLight?.indirectLight ? wide : wide.mul(part)).add(sharp).add(bounced) as Vec3;
  }
  const far = arrives.mul(mean) as Vec3;
  return (tracedLight ? far.add(reflectance.mul(traced)).max(0) : far) as Vec3;
}

/** R(v) from the material's table. */
export function albedoOf({ N, V }: ShadingFrame): Vec3 {
  return new AlbedoNode(dot(N, V) as Float) as unknown as Vec3;
}

export function sumOf(a: Vec3 | undefined, b: Vec3 | null): Vec3 {
  return (a && b ? a.add(b) : (a ?? b ?? vec3(0))) as Vec3;
}

/**
 * The part of wide light that reaches a surface: what is open, and what bounces in what is closed, if that has the same
 * reflectance (Jimenez et al., 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion", section 5).
 */
function reaching({ visibility, bounces }: OpenSky, reflectance: Vec3): Vec3 {
  const a = reflectance.mul(2.0404).sub(0.3324);
  const b = reflectance.mul(4.7951).negate().add(0.6417);
  const c = reflectance.mul(2.7552).add(0.6903);
  const v = vec3(visibility);
  const tinted = v.mul(a).add(b).mul(v).add(c).mul(v).max(v).min(1);
  return v.add(tinted.sub(v).mul(bounces)) as Vec3;
}
