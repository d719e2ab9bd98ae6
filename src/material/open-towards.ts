/** Which directions of a highlight are open to light from far away, from what ambient occlusion has found. */
import { atan, cross, dot, mix, smoothstep } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { OpenSky } from './frame-context.ts';
import type { ShadingFrame } from './shading-frame.ts';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** The cosine over which the rim of the open cone is soft. */
const RIM = 0.15;
/** The angle over which the ends of what is closed are soft, in radians: two of the sectors in which it was found. */
const SOFT = (2 * Math.PI) / 32;
/** The variance of an angle within one sector. */
const SECTOR_VARIANCE = (Math.PI / 32) ** 2 / 12;
/** Sines of the angle off the plane of view and normal, between which the plane stops to speak for a direction. */
const [BESIDE, OFF] = [0.3, 0.8];

/**
 * A mirror's direction is in the plane of view and normal, where it is known what is closed: as much of the angles as the moments
 * say, taken to be one interval. Off the plane it is the cone about the mean open direction that lets as much of a
 * cosine-weighted hemisphere through, sin^2 of its half angle (Jimenez et al., 2016, section 6).
 *
 * @returns of a direction in view space, how open it is: 0..1. Nothing is in the way of what is all open
 */
export function openTowards(
  { visibility, direction, mirrored: closed }: OpenSky,
  { V, N }: ShadingFrame,
): (L: Vec3) => Float {
  const kept = <T extends Node>(node: T): T => {
    const variable = (node as unknown as { toVar(): Node }).toVar();
    return variable as unknown as T;
  };
  const mirrored = closed();
  const rim = kept(visibility.oneMinus().max(0).sqrt() as Float);
  const cosine = kept(dot(N, V).clamp(-1, 1) as unknown as Float);
  const beside = N.sub(V.mul(cosine)) as Vec3;
  const O = kept(beside.div(beside.length().max(1e-4)) as Vec3);
  const axis = kept(cross(V, O) as unknown as Vec3);
  const mirror = kept(cosine.acos().mul(2) as Float);
  const part = kept(mirrored.x.max(1e-6) as Float);
  const middle = kept(mirrored.y.div(part) as Float);
  const variance = mirrored.z.div(part).sub(middle.mul(middle)).max(0).add(SECTOR_VARIANCE);
  // Of an interval of width w the variance is w^2 / 12.
  const width = kept(variance.mul(12).sqrt() as Float);
  const density = kept(mirrored.x.mul(Math.PI).div(width).min(1) as Float);
  return (L) => {
    const cone = smoothstep(rim.sub(RIM), rim, dot(L, direction)) as unknown as Float;
    const angle = (atan(dot(L, O), dot(L, V)) as unknown as Float).sub(mirror);
    const within = width.mul(0.5).sub(angle.sub(middle).abs()).div(SOFT).add(0.5).clamp(0, 1);
    const inPlane = density.mul(within).oneMinus();
    const off = smoothstep(BESIDE, OFF, dot(L, axis).abs());
    return mix(inPlane, cone, off) as unknown as Float;
  };
}
