/** What fog leaves of a lamp's light on its way to a surface. */
import { cameraWorldMatrix, float, positionView, vec4 } from 'three/tsl';
import type { AnalyticLightNode, DirectionalLight, Light, Node, NodeBuilder } from 'three/webgpu';

type Float = Node<'float'>;
type Vec3 = Node<'vec3'>;

/** The part that is left after a way in world space. @param direction a unit vector */
export type Air = (from: Vec3, direction: Vec3, distance: Float) => Float;

/** Beyond any scene. */
const FAR = 1e30;

/** Whether there is fog between lamps and surfaces. */
export function hasAir(builder: NodeBuilder): boolean {
  return Boolean((builder as unknown as { context: { readonly air?: Air } }).context.air);
}

/** Between the fragment and a place, in view space relative to the fragment; null where the air is clear. */
export function airTo(builder: NodeBuilder, way: Vec3, distance: Float): Float | null {
  const { air } = (builder as unknown as { context: { readonly air?: Air } }).context;
  if (!air) return null;
  const world = cameraWorldMatrix as unknown as Node<'mat4'>;
  const direction = world.mul(vec4(way.normalize(), 0)).xyz as Vec3;
  return air(world.mul(vec4(positionView as Vec3, 1)).xyz as Vec3, direction, distance);
}

/** The same for a lamp without size. @param L to the lamp, in view space */
export function airToLamp(builder: NodeBuilder, lightNode: AnalyticLightNode<Light>, L: Vec3): Float | null {
  const { isDirectionalLight } = lightNode.light as Partial<DirectionalLight>;
  const distance = isDirectionalLight
    ? float(FAR)
    : (lightNode.getLightVector(builder) as unknown as Vec3).length();
  return airTo(builder, L, distance as Float);
}
