import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three/webgpu';
import { PathTracerError } from './error.ts';
import { VERTEX_SLOTS, WORDS_PER_SLOT } from './layout.ts';
import type { Pace } from './pace.ts';

/** A geometry's triangles as plain arrays. */
export interface Triangles {
  /** Number of triangles. */
  readonly count: number;
  readonly vertices: number;
  /** Three floats a vertex. */
  readonly positions: Float32Array;
  /** Three vertices a triangle. */
  readonly indices: Uint16Array | Uint32Array;
}

/** @throws PathTracerError for an index beyond the vertices or a position that is not finite */
export async function readTriangles(geometry: BufferGeometry, pace: Pace): Promise<Triangles> {
  const position = geometry.getAttribute('position');
  const vertices = position?.count ?? 0;
  const positions = vertices > 0 ? floatsOf(position, 3) : new Float32Array(0);
  const count = Math.floor((geometry.index?.count ?? vertices) / 3);
  const indices = indicesOf(geometry, 3 * count);
  await pace.each(0, 3 * count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const vertex = indices[i] as number;
      if (vertex >= vertices)
        throw new PathTracerError(
          `triangle ${Math.floor(i / 3)} has the vertex ${vertex}, but there are ${vertices}`,
        );
    }
  });
  await pace.each(0, positions.length, (from, to) => {
    for (let i = from; i < to; i += 1)
      if (!Number.isFinite(positions[i]))
        throw new PathTracerError(`the position of vertex ${Math.floor(i / 3)} is not finite`);
  });
  return { count, vertices, positions, indices };
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

function indicesOf({ index }: BufferGeometry, length: number): Uint16Array | Uint32Array {
  const array = index?.array;
  if (array instanceof Uint16Array || array instanceof Uint32Array) return array;
  const indices = new Uint32Array(length);
  for (let i = 0; i < length; i += 1) indices[i] = index?.getX(i) ?? i;
  return indices;
}

function floatsOf(attribute: Attribute, size: number): Float32Array {
  const { array, count, itemSize } = attribute;
  if (array instanceof Float32Array && itemSize === size && !('isInterleavedBufferAttribute' in attribute))
    return array;
  const values = new Float32Array(size * count);
  for (let i = 0; i < count; i += 1)
    for (let c = 0; c < Math.min(size, itemSize); c += 1) values[size * i + c] = attribute.getComponent(i, c);
  return values;
}

const uvNames = ['uv', 'uv1', 'uv2', 'uv3'] as const;

/** Slots of each of a geometry's vertices. */
export function vertexSlots(geometry: BufferGeometry): number {
  const last = uvNames.findLastIndex((name) => geometry.hasAttribute(name));
  return VERTEX_SLOTS + Math.ceil(Math.max(0, last) / 2);
}

/** Writes the vertices from the word `at` on; the words are 0 before. */
export async function writeVertices(
  floats: Float32Array,
  at: number,
  geometry: BufferGeometry,
  triangles: Triangles,
  pace: Pace,
): Promise<void> {
  const stride = vertexSlots(geometry) * WORDS_PER_SLOT;
  const { vertices } = triangles;
  const normals = await normalsOf(geometry, triangles, pace);
  const tangents = await tangentsOf(geometry, triangles, normals, pace);
  await pace.each(0, vertices, (from, to) => {
    for (let i = from; i < to; i += 1)
      for (let c = 0; c < 3; c += 1) {
        floats[at + i * stride + c] = normals[3 * i + c] as number;
        if (tangents !== null) floats[at + i * stride + WORDS_PER_SLOT + c] = tangents[3 * i + c] as number;
      }
  });
  for (const [set, name] of uvNames.entries()) {
    if (!geometry.hasAttribute(name)) continue;
    const uvs = floatsOf(geometry.getAttribute(name), 2);
    await pace.each(0, vertices, (from, to) => {
      for (let i = from; i < to; i += 1)
        for (let c = 0; c < 2; c += 1)
          floats[at + i * stride + uvWord(set, c)] = finite(uvs[2 * i + c] as number);
    });
  }
}

/** The word of u (0) or v (1) of a set of texture coordinates within a vertex. */
export function uvWord(set: number, component: number): number {
  return set === 0
    ? component * WORDS_PER_SLOT + 3
    : VERTEX_SLOTS * WORDS_PER_SLOT + 2 * (set - 1) + component;
}

const finite = (value: number): number => (Number.isFinite(value) ? value : 0);

/** Unit normals: the geometry's; where it has none, or none of a direction, those of the faces around a vertex. */
async function normalsOf(geometry: BufferGeometry, triangles: Triangles, pace: Pace): Promise<Float32Array> {
  const { vertices, count, positions, indices } = triangles;
  const given = geometry.hasAttribute('normal') ? floatsOf(geometry.getAttribute('normal'), 3) : null;
  const normals = new Float32Array(3 * vertices);
  let missing = 0;
  await pace.each(0, vertices, (from, to) => {
    for (let i = from; i < to; i += 1)
      if (given === null || !setUnit(normals, i, given[3 * i]!, given[3 * i + 1]!, given[3 * i + 2]!))
        missing += 1;
  });
  if (missing === 0) return normals;
  // Doubles: the products of two edges of a mesh in millimetres are beyond what is normal in a float32.
  const sums = new Float64Array(3 * vertices);
  const cross = new Float64Array(3);
  await pace.each(0, count, (from, to) => {
    for (let t = from; t < to; t += 1) {
      crossOfEdges(cross, positions, indices[3 * t]!, indices[3 * t + 1]!, indices[3 * t + 2]!);
      for (let corner = 0; corner < 3; corner += 1) {
        const at = 3 * indices[3 * t + corner]!;
        for (let k = 0; k < 3; k += 1) sums[at + k] = sums[at + k]! + cross[k]!;
      }
    }
  });
  await pace.each(0, vertices, (from, to) => {
    for (let i = from; i < to; i += 1) {
      if (normals[3 * i] !== 0 || normals[3 * i + 1] !== 0 || normals[3 * i + 2] !== 0) continue;
      const [x, y, z] = [sums[3 * i] as number, sums[3 * i + 1] as number, sums[3 * i + 2] as number];
      // Only triangles without area meet here, which nothing hits.
      if (!setUnit(normals, i, x, y, z)) normals[3 * i + 1] = 1;
    }
  });
  return normals;
}

/** False, and nothing set, if the vector has no direction. */
function setUnit(target: Float32Array, i: number, x: number, y: number, z: number): boolean {
  const length = Math.sqrt(x * x + y * y + z * z);
  if (!(length > 0 && length < Number.POSITIVE_INFINITY)) return false;
  target[3 * i] = x / length;
  target[3 * i + 1] = y / length;
  target[3 * i + 2] = z / length;
  return true;
}

/** Writes (b - a) x (c - a), twice the area along the normal of a triangle, at the start of `target`. */
export function crossOfEdges(
  target: Float64Array,
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
): void {
  const x = positions[3 * a] as number;
  const y = positions[3 * a + 1] as number;
  const z = positions[3 * a + 2] as number;
  const x1 = (positions[3 * b] as number) - x;
  const y1 = (positions[3 * b + 1] as number) - y;
  const z1 = (positions[3 * b + 2] as number) - z;
  const x2 = (positions[3 * c] as number) - x;
  const y2 = (positions[3 * c + 1] as number) - y;
  const z2 = (positions[3 * c + 2] as number) - z;
  target[0] = y1 * z2 - z1 * y2;
  target[1] = z1 * x2 - x1 * z2;
  target[2] = x1 * y2 - y1 * x2;
}

/**
 * Tangents whose length says on which side the bitangent is: the geometry's, or those of its texture coordinates
 * (E. Lengyel, 2001, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh"), as three.js computes them for the
 * realtime renderer. Null if there are neither.
 */
async function tangentsOf(
  geometry: BufferGeometry,
  { vertices, count, positions, indices }: Triangles,
  normals: Float32Array,
  pace: Pace,
): Promise<Float32Array | null> {
  const tangents = new Float32Array(3 * vertices);
  const set = (i: number, x: number, y: number, z: number, handedness: number): void => {
    if (!setUnit(tangents, i, x, y, z) || handedness >= 0) return;
    for (let c = 0; c < 3; c += 1) tangents[3 * i + c] = 2 * (tangents[3 * i + c] as number);
  };
  if (geometry.hasAttribute('tangent')) {
    const given = floatsOf(geometry.getAttribute('tangent'), 4);
    await pace.each(0, vertices, (from, to) => {
      for (let i = from; i < to; i += 1)
        set(i, given[4 * i]!, given[4 * i + 1]!, given[4 * i + 2]!, given[4 * i + 3]!);
    });
    return tangents;
  }
  if (!geometry.hasAttribute('uv')) return null;
  const uvs = floatsOf(geometry.getAttribute('uv'), 2);
  const alongU = new Float64Array(3 * vertices);
  const alongV = new Float64Array(3 * vertices);
  await pace.each(0, count, (from, to) => {
    for (let t = from; t < to; t += 1) {
      const a = indices[3 * t]!;
      const b = indices[3 * t + 1]!;
      const c = indices[3 * t + 2]!;
      const u1 = uvs[2 * b]! - uvs[2 * a]!;
      const v1 = uvs[2 * b + 1]! - uvs[2 * a + 1]!;
      const u2 = uvs[2 * c]! - uvs[2 * a]!;
      const v2 = uvs[2 * c + 1]! - uvs[2 * a + 1]!;
      const r = 1 / (u1 * v2 - u2 * v1);
      if (!Number.isFinite(r)) continue;
      for (let k = 0; k < 3; k += 1) {
        const e1 = positions[3 * b + k]! - positions[3 * a + k]!;
        const e2 = positions[3 * c + k]! - positions[3 * a + k]!;
        const s = (v2 * e1 - v1 * e2) * r;
        const p = (u1 * e2 - u2 * e1) * r;
        for (let corner = 0; corner < 3; corner += 1) {
          const at = 3 * indices[3 * t + corner]! + k;
          alongU[at] = alongU[at]! + s;
          alongV[at] = alongV[at]! + p;
        }
      }
    }
  });
  await pace.each(0, vertices, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const nx = normals[3 * i]!;
      const ny = normals[3 * i + 1]!;
      const nz = normals[3 * i + 2]!;
      const ux = alongU[3 * i]!;
      const uy = alongU[3 * i + 1]!;
      const uz = alongU[3 * i + 2]!;
      const along = nx * ux + ny * uy + nz * uz;
      const handedness =
        (ny * uz - nz * uy) * alongV[3 * i]! +
        (nz * ux - nx * uz) * alongV[3 * i + 1]! +
        (nx * uy - ny * ux) * alongV[3 * i + 2]!;
      set(i, ux - nx * along, uy - ny * along, uz - nz * along, handedness);
    }
  });
  return tangents;
}
