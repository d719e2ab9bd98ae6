/**
 * What a lamp gives a fragment. three.js' own nodes compute the same; here what is the same for all fragments is a uniform,
 * and nothing is computed twice: on a software GPU a spot light's code is a third less.
 */
import { dot, renderGroup, smoothstep, uniform } from 'three/tsl';
import {
  type AnalyticLightNode,
  type DirectionalLight,
  type Light,
  type Node,
  type NodeBuilder,
  type PointLight,
  type SpotLight,
  Vector2,
} from 'three/webgpu';
import { glslFunction } from '../glsl/tsl.ts';
import { scaledViewDirection, viewDirection } from './view-direction.ts';
import { hasOneView } from './view-space.ts';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

export interface LampLight {
  /** To the lamp, in view space; a unit vector. */
  readonly direction: Vec3;
  /** Irradiance on a surface that faces it. */
  readonly irradiance: Vec3;
}

type LightNode = AnalyticLightNode<Light> & { readonly light: Light; readonly colorNode: Vec3 };

/** @param given what the light's node says of itself */
export function lampLight(
  lightNode: AnalyticLightNode<Light>,
  builder: NodeBuilder,
  given: { readonly lightDirection: Vec3; readonly lightColor: Vec3 },
): LampLight {
  const node = lightNode as LightNode;
  const { light } = node;
  const asGiven = { direction: given.lightDirection, irradiance: given.lightColor };
  if (!hasOneView(builder)) return asGiven;
  if ((light as Partial<DirectionalLight>).isDirectionalLight)
    return { direction: viewDirection(light as DirectionalLight), irradiance: given.lightColor };
  const { type } = node.constructor as unknown as { type: string };
  const isPoint = type === 'PointLightNode';
  const isSpot = type === 'SpotLightNode' && !projects(light as SpotLight);
  if (!isPoint && !isSpot) return asGiven;
  const toLamp = (node.getLightVector(builder) as Vec3).toVar() as Vec3;
  const distance2 = dot(toLamp, toLamp).toVar() as Float;
  const direction = toLamp.mul(distance2.inverseSqrt()).toVar() as Vec3;
  const reaching = node.colorNode.mul(attenuation(distance2, falloffOf(light as PointLight))) as Vec3;
  return {
    direction,
    irradiance: isSpot ? (reaching.mul(beam(light as SpotLight, direction)) as Vec3) : reaching,
  };
}

/** Whether the code is for one lamp, and not the body of a loop over many (src/lights/many-lamps.ts). */
export function isOneLamp(light: Light): boolean {
  const { isDirectionalLight, isPointLight, isSpotLight } = light as Partial<
    DirectionalLight & PointLight & SpotLight
  >;
  return Boolean(isDirectionalLight || isPointLight || isSpotLight);
}

/** Whether a spot light throws a picture. */
function projects(light: SpotLight): boolean {
  return Boolean(light.map ?? (light as unknown as { colorNode?: unknown }).colorNode);
}

/**
 * three.js' getDistanceAttenuation(): r^-decay, with the window of Lagarde and de Rousiers, 2014, "Moving Frostbite to
 * Physically Based Rendering", equation 26. falloff: decay/2, and the range^-2, which is 0 for none.
 */
const attenuation = glslFunction(`
  float attenuation(float distance2, vec2 falloff) {
    float x = distance2 * falloff.y;
    float window = max(1.0 - x * x, 0.0);
    return window * window / max(pow(distance2, falloff.x), 0.01);
  }
`) as unknown as (distance2: Float, falloff: Node<'vec2'>) => Float;

const falloffs = new WeakMap<Light, Node<'vec2'>>();

function falloffOf(light: PointLight | SpotLight): Node<'vec2'> {
  let falloff = falloffs.get(light);
  if (!falloff) {
    falloff = uniform(new Vector2())
      .setGroup(renderGroup)
      .onRenderUpdate((_, { value }) =>
        value.set(light.decay / 2, light.distance > 0 ? light.distance ** -2 : 0),
      ) as unknown as Node<'vec2'>;
    falloffs.set(light, falloff);
  }
  return falloff;
}

/** Without penumbra the edge is a step: a slope that no difference of float32 cosines but 0 survives. */
const STEP_SLOPE = 1e30;

function slopeOf({ angle, penumbra }: SpotLight): number {
  const width = Math.cos(angle * (1 - penumbra)) - Math.cos(angle);
  return width > 0 ? 1 / width : STEP_SLOPE;
}

const beams = new WeakMap<SpotLight, (direction: Vec3) => Float>();

/** From 0 at the cone's edge to 1 where the penumbra ends. */
function beam(light: SpotLight, direction: Vec3): Float {
  let shape = beams.get(light);
  if (!shape) {
    const axis = scaledViewDirection(light, () => slopeOf(light));
    const edge = uniform(0)
      .setGroup(renderGroup)
      .onRenderUpdate(() => Math.cos(light.angle) * slopeOf(light)) as unknown as Float;
    shape = (to) => smoothstep(0, 1, dot(to, axis).sub(edge)) as unknown as Float;
    beams.set(light, shape);
  }
  return shape(direction);
}
