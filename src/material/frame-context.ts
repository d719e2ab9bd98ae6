/**
 * What the effects of a frame tell every material: it reaches the lighting model through three.js' context. What an
 * effect does not tell is not there, and costs nothing.
 */
import type { Node, NodeBuilder } from 'three/webgpu';

type Float = Node<'float'>;
type Vec3 = Node<'vec3'>;

/** How much of what is around the fragment is open to light from far away. */
export interface OpenSky {
  /** 0..1: the part of the hemisphere that is open, weighted by the cosine. */
  readonly visibility: Float;
  /** The mean open direction, a unit vector in view space. */
  readonly direction: Vec3;
  /** 1 where light that bounces in what is closed is to be counted, by the material's albedo; else 0. */
  readonly bounces: Float;
}

export type FrameContext = {
  /** Ambient occlusion, at the fragment that is shaded; in the fragment's own code, at its top level. */
  readonly openSky?: () => OpenSky;
  /** The part of a lamp's light that is not kept off close to the fragment. @param L to the lamp, in view space */
  readonly contactShadow?: (L: Vec3) => Float;
};

/** What opaque materials are told. Behind what is transparent lies another surface: what is known of the pixel is that one's. */
export function frameContext(builder: NodeBuilder): FrameContext {
  const { context, material } = builder as unknown as {
    context: FrameContext;
    material: { transparent: boolean };
  };
  return material.transparent ? {} : context;
}
