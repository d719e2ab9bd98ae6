import type { BufferGeometry } from 'three/webgpu';
import { type BinaryTree, buildBinaryTree } from './binary-tree.ts';
import { PathTracerError } from './error.ts';
import {
  BLOCK_NUMBERS,
  BLOCK_SLOTS,
  BLOCK_TRIANGLES,
  MESH_SLOTS,
  NODE_SLOTS,
  NODE_WIDTH,
  NONE,
  WORDS_PER_SLOT,
} from './layout.ts';
import type { Pace } from './pace.ts';
import { crossOfEdges, readTriangles, type Triangles, vertexSlots, writeVertices } from './vertices.ts';
import { moveNodes, widen, writeNodes } from './wide-tree.ts';

/** A mesh as it lies in the scene's memory, but for where that begins: slots are counted from its own first one. */
export interface PackedMesh {
  /** The mesh's slot, its tree's nodes, blocks, vertices and indices, one behind the other. */
  readonly words: Uint32Array<ArrayBuffer>;
  readonly triangles: number;
  readonly nodes: number;
  readonly blocks: number;
  readonly vertexSlots: number;
  /** The word of the first index. */
  readonly indices: number;
  /** Minimum and maximum of what can be hit; null if nothing can. */
  readonly bounds: Float32Array | null;
  /** Entries that a traversal's stack can have at most. */
  readonly stack: number;
}

/** What a mesh will take at least: enough to refuse a scene before its trees are built. */
export function leastMeshBytes(triangles: number, vertices: number): number {
  const blocks = Math.ceil(triangles / BLOCK_TRIANGLES);
  const slots = blocks * (BLOCK_SLOTS + NODE_SLOTS / (NODE_WIDTH - 1)) + 2 * vertices;
  return 4 * (Math.ceil(slots) * WORDS_PER_SLOT + 3 * triangles);
}

const nodesAt = MESH_SLOTS;
export const blocksAt = (mesh: { nodes: number }): number => nodesAt + mesh.nodes * NODE_SLOTS;
export const verticesAt = (mesh: { nodes: number; blocks: number }): number =>
  blocksAt(mesh) + mesh.blocks * BLOCK_SLOTS;

/** @param onProgress called with 0 to 1 */
export async function packMesh(
  geometry: BufferGeometry,
  maxBytes: number,
  pace: Pace,
  onProgress?: (part: number) => void,
): Promise<PackedMesh> {
  const triangles = await readTriangles(geometry, pace);
  const { boxes, numbers } = await boxesOf(triangles, pace);
  const hittable = numbers.length;
  const tree = await buildBinaryTree(boxes, BLOCK_TRIANGLES, pace, (done) =>
    onProgress?.((0.9 * done) / hittable),
  );
  const wide = widen(tree);
  const nodes = wide.children.length / NODE_WIDTH;
  const blocks = Math.max(0, (tree.nodes + 1) / 2) | 0;
  const stride = vertexSlots(geometry);
  const place = { nodes, blocks };
  const indicesSlot = verticesAt(place) + triangles.vertices * stride;
  const slots = indicesSlot + Math.ceil((3 * triangles.count) / WORDS_PER_SLOT);
  const bytes = 4 * WORDS_PER_SLOT * slots;
  if (bytes > maxBytes)
    throw new PathTracerError(`${triangles.count} triangles take ${bytes} bytes; the limit is ${maxBytes}`);
  const words = new Uint32Array(slots * WORDS_PER_SLOT);
  const floats = new Float32Array(words.buffer);
  const indices = indicesSlot * WORDS_PER_SLOT;
  words.set([nodesAt, verticesAt(place), indices, stride]);
  const blockOf = await writeBlocks(words, floats, blocksAt(place), triangles, tree, numbers, pace);
  writeNodes(words, nodesAt * WORDS_PER_SLOT, nodesAt, tree, wide, (leaf) => blockOf[leaf] as number);
  await writeVertices(floats, verticesAt(place) * WORDS_PER_SLOT, geometry, triangles, pace);
  words.set(triangles.indices.subarray(0, 3 * triangles.count), indices);
  onProgress?.(1);
  return {
    words,
    triangles: triangles.count,
    nodes,
    blocks,
    vertexSlots: stride,
    indices,
    bounds: hittable > 0 ? tree.boxes.slice(0, 6) : null,
    stack: wide.stack,
  };
}

/** The boxes of the triangles that have an area, and their numbers: nothing hits the others. */
async function boxesOf(
  { count, positions, indices }: Triangles,
  pace: Pace,
): Promise<{ boxes: Float32Array; numbers: Uint32Array }> {
  const boxes = new Float32Array(6 * count);
  const numbers = new Uint32Array(count);
  const cross = new Float64Array(3);
  let length = 0;
  await pace.each(0, count, (from, to) => {
    for (let t = from; t < to; t += 1) {
      const a = indices[3 * t]!;
      const b = indices[3 * t + 1]!;
      const c = indices[3 * t + 2]!;
      crossOfEdges(cross, positions, a, b, c);
      if (cross[0] === 0 && cross[1] === 0 && cross[2] === 0) continue;
      for (let k = 0; k < 3; k += 1) {
        const p = positions[3 * a + k]!;
        const q = positions[3 * b + k]!;
        const r = positions[3 * c + k]!;
        boxes[6 * length + k] = Math.min(p, q, r);
        boxes[6 * length + k + 3] = Math.max(p, q, r);
      }
      numbers[length] = t;
      length += 1;
    }
  });
  return { boxes: boxes.subarray(0, 6 * length), numbers: numbers.subarray(0, length) };
}

/** Writes a block for each leaf of the tree. @returns the slot of each leaf's block, by node */
async function writeBlocks(
  words: Uint32Array,
  floats: Float32Array,
  slot: number,
  { positions, indices }: Triangles,
  tree: BinaryTree,
  numbers: Uint32Array,
  pace: Pace,
): Promise<Uint32Array> {
  const blockOf = new Uint32Array(tree.nodes);
  let next = slot;
  await pace.each(0, tree.nodes, (from, to) => {
    for (let node = from; node < to; node += 1) {
      const count = tree.count[node] as number;
      if (count === 0) continue;
      blockOf[node] = next;
      const at = next * WORDS_PER_SLOT;
      for (let lane = 0; lane < BLOCK_TRIANGLES; lane += 1) {
        const item = tree.order[(tree.first[node] as number) + lane] as number;
        const triangle = lane < count ? (numbers[item] as number) : NONE;
        words[at + BLOCK_NUMBERS * WORDS_PER_SLOT + lane] = triangle;
        if (triangle === NONE) continue;
        for (let corner = 0; corner < 3; corner += 1) {
          const vertex = 3 * (indices[3 * triangle + corner] as number);
          for (let k = 0; k < 3; k += 1)
            floats[at + (3 * corner + k) * WORDS_PER_SLOT + lane] = positions[vertex + k] as number;
        }
      }
      next += BLOCK_SLOTS;
    }
  });
  return blockOf;
}

/** Copies a mesh into the scene's memory at `slot`. */
export function placeMesh(memory: Uint32Array, slot: number, mesh: PackedMesh): void {
  const at = slot * WORDS_PER_SLOT;
  memory.set(mesh.words, at);
  const [root, vertices, indices] = mesh.words as unknown as [number, number, number];
  memory.set([root + slot, vertices + slot, indices + at], at);
  moveNodes(memory, at + nodesAt * WORDS_PER_SLOT, mesh.nodes, slot);
}
