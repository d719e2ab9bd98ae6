/**
 * Where an image lies on a surface: as KHR_texture_transform says it, and as a document does (which is three.js's way).
 * The extension has v downwards and rotates what has been scaled; here v is upwards and what has been rotated is scaled.
 * With p = (u, 1 - v), p' = R S p + offset becomes a rotation by the opposite angle and the offset below.
 */
import { MathUtils } from 'three/webgpu';
import type { TextureRef } from '../../scene/schema.ts';

export type Placement = Pick<TextureRef, 'repeat' | 'offset' | 'rotation'>;

export interface KhrTransform {
  offset: [number, number];
  /** Radians. */
  rotation: number;
  scale: [number, number];
}

export function fromKhr({ offset: [ox, oy], rotation, scale: [sx, sy] }: KhrTransform): Placement {
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  return {
    repeat: [sx, sy],
    rotation: MathUtils.radToDeg(-rotation) % 360,
    offset: [sin * sy + ox, 1 - cos * sy - oy],
  };
}

export function toKhr({ repeat: [sx, sy], offset: [ox, oy], rotation: degrees }: Placement): KhrTransform {
  const rotation = -MathUtils.degToRad(degrees);
  return {
    scale: [sx, sy],
    rotation,
    offset: [ox - Math.sin(rotation) * sy, 1 - Math.cos(rotation) * sy - oy],
  };
}

/** With both, the two orders of rotation and scale differ. */
export const isApproximate = ({ repeat: [sx, sy], rotation }: Placement): boolean =>
  sx !== sy && Math.sin(MathUtils.degToRad(rotation)) !== 0;

export const isPlain = ({ repeat, offset, rotation }: Placement): boolean =>
  repeat[0] === 1 && repeat[1] === 1 && offset[0] === 0 && offset[1] === 0 && rotation === 0;
