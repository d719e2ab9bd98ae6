/** Triangles as the readers of model files give them, before they are part of a GLB. */
import type { GltfWriter, Json } from '../gltf/writer.ts';

export interface MeshData {
  /** Three numbers a vertex; finite. */
  positions: Float32Array;
  /** Three a vertex; without them faces are flat. */
  normals?: Float32Array | undefined;
  /** Two a vertex, v upwards. */
  uvs?: Float32Array | undefined;
  /** A second set of them. */
  uvs2?: Float32Array | undefined;
  /** Corners of triangles; without them, every three vertices are one. */
  indices?: Uint32Array | undefined;
}

/** The attributes of a primitive in a GLB. */
export function writeAttributes(writer: GltfWriter, { positions, normals, uvs, uvs2 }: MeshData): Json {
  return {
    POSITION: writer.attribute(positions, 'VEC3', true),
    ...(normals && { NORMAL: writer.attribute(unitVectors(normals), 'VEC3') }),
    ...(uvs && { TEXCOORD_0: writer.attribute(downwards(uvs), 'VEC2') }),
    // Sets count from 0 without gaps.
    ...(uvs && uvs2 && { TEXCOORD_1: writer.attribute(downwards(uvs2), 'VEC2') }),
  };
}

/** A primitive of a mesh in a GLB. */
export function writePrimitive(writer: GltfWriter, mesh: MeshData, material?: number): Json {
  return {
    attributes: writeAttributes(writer, mesh),
    ...(mesh.indices && { indices: writer.indices(mesh.indices, mesh.positions.length / 3) }),
    ...(material !== undefined && { material }),
  };
}

/** glTF's v points down the image. */
function downwards(uvs: Float32Array): Float32Array {
  return uvs.map((value, i) => (i % 2 === 1 ? 1 - value : value));
}

/** 3.7.2.1 asks for unit length; a normal of no length becomes one that at least is a direction. */
function unitVectors(normals: Float32Array): Float32Array {
  const result = new Float32Array(normals.length);
  for (let i = 0; i < normals.length; i += 3) {
    const [x, y, z] = [normals[i]!, normals[i + 1]!, normals[i + 2]!];
    const length = Math.hypot(x, y, z);
    if (length > 0 && Number.isFinite(length)) result.set([x / length, y / length, z / length], i);
    else result[i + 2] = 1;
  }
  return result;
}

/**
 * Normals that are the mean of those of the faces around, weighted by the angles in which the faces meet the vertex, so
 * that how polygons were cut into triangles does not show (G. Thürmer, C. Wüthrich, 1998, "Computing Vertex Normals from
 * Polygonal Facets"). Not of unit length.
 */
export function smoothNormals(positions: Float32Array, indices: ArrayLike<number>): Float32Array {
  const normals = new Float32Array(positions.length);
  const [p, q] = [
    [0, 0, 0],
    [0, 0, 0],
  ] as [number[], number[]];
  /** The unit vector from one vertex to another. */
  const direction = (from: number, to: number, out: number[]): void => {
    for (let axis = 0; axis < 3; axis++) out[axis] = positions[3 * to + axis]! - positions[3 * from + axis]!;
    const length = Math.hypot(out[0]!, out[1]!, out[2]!);
    for (let axis = 0; axis < 3; axis++) out[axis] = length > 0 ? out[axis]! / length : 0;
  };
  for (let i = 0; i + 2 < indices.length; i += 3)
    for (let corner = 0; corner < 3; corner++) {
      const at = indices[i + corner]!;
      direction(at, indices[i + ((corner + 1) % 3)]!, p);
      direction(at, indices[i + ((corner + 2) % 3)]!, q);
      const [px, py, pz] = p as [number, number, number];
      const [qx, qy, qz] = q as [number, number, number];
      const normal = [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx];
      const sine = Math.hypot(normal[0]!, normal[1]!, normal[2]!);
      if (!(sine > 0)) continue;
      const angle = Math.atan2(sine, px * qx + py * qy + pz * qz);
      for (let axis = 0; axis < 3; axis++) normals[3 * at + axis]! += (angle / sine) * normal[axis]!;
    }
  return normals;
}

/** Numbers that become more: a typed array that grows. */
export class Numbers<A extends Float32Array | Uint32Array> {
  #values: A;
  length = 0;

  constructor(readonly type: new (length: number) => A) {
    this.#values = new type(1024);
  }

  push(...values: number[]): void {
    if (this.length + values.length > this.#values.length) {
      const larger = new this.type(2 * (this.length + values.length));
      larger.set(this.#values);
      this.#values = larger;
    }
    for (const value of values) this.#values[this.length++] = value;
  }

  at(index: number): number {
    return this.#values[index]!;
  }

  finish(): A {
    return this.#values.slice(0, this.length) as A;
  }
}
