/**
 * The part of a light that a point sees, from shadow maps: percentage-closer soft shadows (R. Fernando, 2005, "Percentage-Closer
 * Soft Shadows"). First what stands between the point and the light is looked for, then rays to points of the light are
 * followed as far as that.
 *
 * A texel is a point in space. It keeps off light if it is nearer to the light than the shaded point and above the plane of
 * the shaded triangle: a surface does not shade itself, however slanted or coarse the map, and hardly any bias is needed.
 */
import { cross, dot, float, If, int, ivec2, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { repeat } from '../../../material/statements.ts';
import { NOTHING } from './atlas.ts';
import { FIRST_MAP } from './rows.ts';

export type Float = Node<'float'>;
export type Int = Node<'int'>;
export type Vec2 = Node<'vec2'>;
export type Vec3 = Node<'vec3'>;
export type Vec4 = Node<'vec4'>;

/** What is above the triangle's plane by less than this keeps off no light: of the distance to the light (float32), */
export const OF_LIGHT = 2e-5;
/** of a texel, */
export const OF_TEXEL = 0.1;
/** and of the distance to the point: hollows of coarse meshes. As a slope it is that of light that hardly counts. */
export const OF_DISTANCE = 0.02;

/** Radius of the filter of a light without size, in texels: edges that are neither stairs nor blurred. */
export const FILTER = 1.2;

/** Blockers are looked for at a part of the samples, but no fewer than this. */
export const LEAST_SEARCH = 8;

const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

export interface Maps {
  readonly atlas: TextureNode;
  readonly rows: TextureNode;
}

export function readRow({ rows }: Maps, row: Int): (texel: number | Int) => Vec4 {
  return (texel) => rows.load(ivec2(int(texel as Int), row)) as unknown as Vec4;
}

/** The i-th of n points that fill the unit disc evenly (H. Vogel, 1979), turned. */
export function discPoint(i: Float, n: Float, turn: Float): Vec2 {
  const angle = i.mul(GOLDEN_ANGLE).add(turn.mul(2 * Math.PI));
  const radius = i.add(0.5).div(n).sqrt();
  return vec2(angle.cos(), angle.sin()).mul(radius) as unknown as Vec2;
}

/**
 * The texel that is looked at, in texels of the atlas; x is negative outside the map. @param jitter goes no farther than its edge
 */
export function texelAt(at: Vec2, jitter: Vec2, bounds: Vec4): Vec2 {
  const inside = at.x
    .greaterThanEqual(bounds.x)
    .and(at.x.lessThan(bounds.z))
    .and(at.y.greaterThanEqual(bounds.y))
    .and(at.y.lessThan(bounds.w));
  const moved = at.add(jitter).clamp(bounds.xy, bounds.zw.sub(0.5)).floor();
  return inside.select(moved, vec2(-1)).toVar() as unknown as Vec2;
}

/** What a map has at a place; far away outside it. @param at in texels of the atlas */
export function fetch(maps: Maps, at: Vec2, bounds: Vec4): Float {
  return distanceAt(maps, texelAt(at, vec2(0) as unknown as Vec2, bounds));
}

/** A texel's distance; far away outside the map. */
export function distanceAt({ atlas }: Maps, texel: Vec2): Float {
  const distance = atlas.load(ivec2(int(texel.x.max(0)), int(texel.y.max(0)))) as unknown as Vec4;
  return texel.x.lessThan(0).select(float(NOTHING), distance.x).toVar() as unknown as Float;
}

/** Two unit vectors orthogonal to a unit vector and to each other. */
export function basis(a: Vec3): [Vec3, Vec3] {
  // T. Duff et al., 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1), listing 3.
  const s = a.z.lessThan(0).select(float(-1), float(1)) as unknown as Float;
  const k = float(-1).div(s.add(a.z));
  const x = vec3(a.x.mul(a.x).mul(k).mul(s).add(1), a.x.mul(a.y).mul(k).mul(s), s.negate().mul(a.x)).toVar();
  return [x as unknown as Vec3, cross(a, x as unknown as Vec3) as unknown as Vec3];
}

/** A vector's components in a frame. */
export function inFrame(v: Vec3, [x, y, z]: readonly [Vec4, Vec4, Vec4]): Vec3 {
  return vec3(dot(v, x.xyz as Vec3), dot(v, y.xyz as Vec3), dot(v, z.xyz as Vec3)).toVar() as unknown as Vec3;
}

/** Whether a place is above the triangle's plane by so much that it is not the surface itself. */
export function isAbove(offset: Vec3, normal: Vec3, lightDistance: Float, texel: Float): Node<'bool'> {
  const least = lightDistance.mul(OF_LIGHT).add(texel.mul(OF_TEXEL)).add(offset.length().mul(OF_DISTANCE));
  return dot(normal, offset).greaterThan(least) as unknown as Node<'bool'>;
}

export function mapAt(read: (texel: number | Int) => Vec4, map: Int): { place: Vec4; bounds: Vec4 } {
  const at = map.mul(2).add(FIRST_MAP) as Int;
  return { place: read(at).toVar() as Vec4, bounds: read(at.add(1) as Int).toVar() as Vec4 };
}

/** Whether `read` of the search: how many samples it takes of so many. */
export function searchSamples(samples: Float): Float {
  return samples.mul(0.5).ceil().max(LEAST_SEARCH) as Float;
}

export { dot, float, If, int, repeat, vec2, vec3, vec4 };
