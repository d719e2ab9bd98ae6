/**
 * What shaders know of each shadowed light: a row of a texture. All vectors are in world space.
 *
 *     central light (point, spot, rectangle)          parallel light (directional)
 *     0  position, radius in metres                   0  0, 0, 0, tangent of half the angle
 *     1  x axis of its frame, half width or 0         1  x axis, number of cascades
 *     2  y axis, half height or 0                     2  y axis, height of the maps' camera along z
 *     3  z axis, tangent that the +z map goes to      3  z axis (to the light), height of the highest caster
 *     4  distance of the nearest caster, 0, 0, 0      4  0, 0, 0, 0
 *     6 + 2 i  map i: place in the atlas, in texels, is (u x + y, v z + w)
 *     7 + 2 i  map i: least and greatest place that has been drawn; empty if nothing casts
 *
 * The maps of a central light are the faces of a cube in its frame, in the order of FACES; (u, v) are tangents. Those of a
 * parallel light are its cascades, the finest first; (u, v) are metres along x and y.
 */
import {
  DataTexture,
  FloatType,
  type Matrix4,
  NearestFilter,
  RGBAFormat,
  Vector3,
  type Vector3Like,
} from 'three/webgpu';

export const ROW_TEXELS = 32;
export const FIRST_MAP = 6;

/** Forward, right and up of a cube's faces, as numbers of axes: 1 is x, -3 is -z. right x up = -forward. */
export const FACES = [
  { forward: 3, right: -1, up: 2 },
  { forward: -3, right: 1, up: 2 },
  { forward: 1, right: -2, up: 3 },
  { forward: -1, right: 2, up: 3 },
  { forward: 2, right: -3, up: 1 },
  { forward: -2, right: 3, up: 1 },
] as const;

/** A direction of a frame by its number. */
export function axisOf(frame: Matrix4, number: number): Vector3 {
  return new Vector3().setFromMatrixColumn(frame, Math.abs(number) - 1).multiplyScalar(Math.sign(number));
}

/** Where a map is: what its (u, v) are, and its square of the atlas. */
export interface Placement {
  readonly u: readonly [least: number, most: number];
  readonly v: readonly [least: number, most: number];
}

/** A square of the atlas, in texels from its upper left corner. */
export interface Tile {
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

export class Rows {
  readonly texture: DataTexture;
  readonly #data: Float32Array;

  constructor(count: number) {
    this.#data = new Float32Array(4 * ROW_TEXELS * Math.max(1, count));
    this.texture = new DataTexture(this.#data, ROW_TEXELS, Math.max(1, count), RGBAFormat, FloatType);
    this.texture.minFilter = NearestFilter;
    this.texture.magFilter = NearestFilter;
    this.texture.needsUpdate = true;
  }

  set(row: number, texel: number, { x, y, z }: Vector3Like, w: number): void {
    this.#data.set([x, y, z, w], 4 * (row * ROW_TEXELS + texel));
    this.texture.needsUpdate = true;
  }

  /** @param placement null where nothing casts a shadow */
  setMap(row: number, map: number, tile: Tile, placement: Placement | null): void {
    const at = 4 * (row * ROW_TEXELS + FIRST_MAP + 2 * map);
    this.texture.needsUpdate = true;
    if (placement === null) {
      this.#data.set([1, 0, -1, 0, 0, 0, 0, 0], at);
      return;
    }
    const { u, v } = placement;
    const [perU, perV] = [tile.size / (u[1] - u[0]), tile.size / (v[1] - v[0])];
    // Rows from the top.
    this.#data.set([perU, tile.x - u[0] * perU, -perV, tile.y + v[1] * perV], at);
    this.#data.set([tile.x, tile.y, tile.x + tile.size, tile.y + tile.size], at + 4);
  }
}
