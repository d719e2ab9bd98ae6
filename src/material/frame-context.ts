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
  /**
   * What is closed in the plane of view and normal, on the side of the mirror direction: the parts of a half circle's angles,
   * and the means over it of what is closed times its angle from the mirror direction, in radians, and times its square.
   * To be called at the top level, as openSky() is.
   */
  readonly mirrored: () => Vec3;
  /** 1 where light that bounces in what is closed is to be counted, by the material's albedo; else 0. */
  readonly bounces: Float;
}

/** What a ray through the picture found; to be read where it was traced. */
export interface TracedRay {
  readonly radiance: Vec3;
  /** 0..1: how much of what the ray would find otherwise this stands for; 0 where it found nothing. */
  readonly share: Float;
  /** How wide the found is blurred by the lobe, in texels. */
  readonly spread: Float;
}

/** Told instead of all else in a pass of its own, in which materials trace rays and are not lit. */
export interface RayTracer {
  /** Rays per fragment. */
  readonly rays: Float;
  /** Whether highlights, and whether wide lobes are traced. */
  readonly reflections: boolean;
  readonly indirectLight: boolean;
  /** 0..1 each, another for every fragment and frame: what the set of directions is shifted by. */
  shift(): Node<'vec2'>;
  /**
   * @param L from the fragment, in view space
   * @param density of the model's sampler there, in 1/sr
   * @param part how much it belongs to a highlight
   */
  trace(L: Vec3, density: Float, part: Float): TracedRay;
  /** The mean over the rays, by the model's weights: found radiance less that of far light from the same directions. */
  write(wide: Vec3, sharp: Vec3, spread: Float): void;
}

/** What rays have found, once for each pixel. */
export interface TracedLight {
  readonly reflections: boolean;
  readonly indirectLight: boolean;
  /** Mean incident radiance, as the fragment's model weighs it, less that of far light in the same directions. */
  incident(): Vec3;
}

export type FrameContext = {
  /** Ambient occlusion, at the fragment that is shaded; in the fragment's own code, at its top level. */
  readonly openSky?: () => OpenSky;
  readonly tracedLight?: TracedLight;
  readonly rayTracer?: RayTracer;
};

export const frameContextKeys = [
  'openSky',
  'tracedLight',
  'rayTracer',
] as const satisfies readonly (keyof FrameContext)[];

/** What opaque materials are told. Behind what is transparent lies another surface: what is known of the pixel is that one's. */
export function frameContext(builder: NodeBuilder): FrameContext {
  const { context, material } = builder as unknown as {
    context: FrameContext;
    material: { transparent: boolean };
  };
  return material.transparent ? {} : context;
}
