/** What is asked of the thread of meshes, and its answers. */
import { Matrix4 } from 'three/webgpu';
import { Pace } from '../../../pathtracer/scene/pace.ts';
import type { Answered } from '../../threads/answering.ts';
import { fallOf, leastOf, lowestOf, worldTriangles } from '../placing/fall.ts';
import { buildMeshTree, type MeshTree } from './mesh-tree.ts';
import type { Shape } from './shape.ts';

/** By its number; with its triangles if this thread has not had them yet. */
export interface SentMesh {
  readonly id: number;
  readonly shape: Shape | null;
}

/** Of a mesh in the world. */
export interface PlacedMesh {
  readonly mesh: SentMesh;
  /** As Matrix4 has them. */
  readonly matrix: readonly number[];
}

export type MeshQuestion =
  /** The first one is for meshes that something will be asked of. */
  | { readonly kind: 'mesh' | 'tree'; readonly mesh: SentMesh }
  | {
      readonly kind: 'fall';
      readonly bodies: readonly (PlacedMesh & { readonly middle: number })[];
      readonly obstacles: readonly PlacedMesh[];
      /** The height of a ground, or the meshes that it lies under; null for none. */
      readonly ground: number | readonly PlacedMesh[] | null;
    };

export type MeshAnswer =
  | { readonly kind: 'mesh' }
  | { readonly kind: 'tree'; readonly tree: MeshTree }
  | { readonly kind: 'fall'; readonly fall: number | null };

/** @returns what answers, and remembers the meshes that it was sent */
export function meshAnswers(): (question: MeshQuestion) => Promise<Answered<MeshAnswer>> {
  const shapes = new Map<number, Shape>();
  const shapeOf = ({ id, shape }: SentMesh): Shape => {
    if (shape) shapes.set(id, shape);
    const known = shapes.get(id);
    if (!known) throw new Error(`the thread of meshes has no mesh ${id}`);
    return known;
  };
  const placed = ({ mesh, matrix }: PlacedMesh) =>
    worldTriangles(shapeOf(mesh), new Matrix4().fromArray(matrix));
  const heightOf = (ground: number | readonly PlacedMesh[] | null): number | null =>
    typeof ground === 'object'
      ? leastOf(
          (ground ?? []).map(({ mesh, matrix }) => lowestOf(shapeOf(mesh), new Matrix4().fromArray(matrix))),
        )
      : ground;
  return async (question) => {
    switch (question.kind) {
      case 'mesh':
        shapeOf(question.mesh);
        return { answer: { kind: 'mesh' } };
      case 'tree': {
        const shape = shapeOf(question.mesh);
        const pace = new Pace();
        try {
          const tree = await buildMeshTree(shape, pace);
          return { answer: { kind: 'tree', tree }, transfer: buffersOf(tree) };
        } finally {
          pace.end();
        }
      }
      case 'fall': {
        const bodies = question.bodies.map((body) => ({ triangles: placed(body), middle: body.middle }));
        const obstacles = question.obstacles.map(placed);
        return { answer: { kind: 'fall', fall: fallOf(bodies, obstacles, heightOf(question.ground)) } };
      }
    }
  };
}

const buffersOf = (parts: object): ArrayBuffer[] =>
  (Object.values(parts) as Uint32Array<ArrayBuffer>[]).map(({ buffer }) => buffer);
