/**
 * What hands need to know of meshes: trees for picking, how far they fall. Small meshes are looked at at once, triangle by
 * triangle; of large ones a thread finds it out, once for each geometry, and until it has, they have none. An answer belongs
 * to a geometry, which never changes: one that comes late for a geometry that has gone is of no harm.
 */
import {
  BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  type Mesh,
} from 'three/webgpu';
import { Thread, type ThreadWorker } from '../../threads/thread.ts';
import { fallOf, leastOf, lowestOf, worldTriangles } from '../placing/fall.ts';
import type { MeshAnswer, MeshQuestion, PlacedMesh, SentMesh } from './mesh-jobs.ts';
import type { MeshTree } from './mesh-tree.ts';
import type { Shape } from './shape.ts';

/** Up to so many triangles take the page a few milliseconds. */
export const SMALL = 5_000;

/** What is known of a geometry; a promise of what is being found out. */
interface Known {
  tree?: MeshTree | Promise<void>;
}

export class Meshes {
  readonly #thread: Thread<MeshQuestion, MeshAnswer>;
  readonly #known = new WeakMap<BufferGeometry, Known>();
  readonly #shapes = new WeakMap<BufferGeometry, Shape>();
  readonly #ids = new WeakMap<BufferGeometry, { readonly id: number; life: number }>();
  #lastId = 0;

  constructor(spawn: () => ThreadWorker) {
    this.#thread = new Thread(spawn);
  }

  /** A promise of when it is there, until it is. Only of large meshes. */
  tree(geometry: BufferGeometry): MeshTree | Promise<void> {
    const known = this.#of(geometry);
    if (!known.tree) {
      const asked = this.#thread.ask({ kind: 'tree', mesh: this.#sent(geometry) }).then((answer) => {
        if (answer.kind === 'tree') known.tree = answer.tree;
      });
      known.tree = asked;
      asked.catch(() => {
        delete known.tree;
      });
    }
    return known.tree;
  }

  /**
   * How far meshes fall, as fallOf() says; at once if they are small.
   *
   * @param ground its height, or the meshes that it lies under; null for none
   */
  fall(
    bodies: readonly { readonly mesh: Mesh; readonly middle: number }[],
    obstacles: readonly Mesh[],
    ground: number | readonly Mesh[] | null = null,
  ): number | null | Promise<number | null> {
    const under = typeof ground === 'object' ? (ground ?? []) : [];
    const all = [...bodies.map(({ mesh }) => mesh), ...obstacles, ...under];
    if (all.reduce((sum, { geometry }) => sum + triangleCount(geometry), 0) <= SMALL) {
      const placed = ({ geometry, matrixWorld }: Mesh) => worldTriangles(this.shape(geometry), matrixWorld);
      return fallOf(
        bodies.map(({ mesh, middle }) => ({ triangles: placed(mesh), middle })),
        obstacles.map(placed),
        typeof ground === 'number'
          ? ground
          : leastOf(under.map(({ geometry, matrixWorld }) => lowestOf(this.shape(geometry), matrixWorld))),
      );
    }
    // As they stand now, wherever they are once their triangles have been sent.
    const matrices = new Map(all.map((mesh) => [mesh, [...mesh.matrixWorld.elements]]));
    const placed = (mesh: Mesh): PlacedMesh => ({
      mesh: this.#sent(mesh.geometry),
      matrix: matrices.get(mesh) ?? [],
    });
    const ask = async () => {
      // One by one: what is sent is copied while the page waits.
      for (const { geometry } of all)
        if (!this.#isSent(geometry)) await this.#thread.ask({ kind: 'mesh', mesh: this.#sent(geometry) });
      const answer = await this.#thread.ask({
        kind: 'fall',
        bodies: bodies.map(({ mesh, middle }) => ({ ...placed(mesh), middle })),
        obstacles: obstacles.map(placed),
        ground: typeof ground === 'object' ? (ground?.map(placed) ?? null) : ground,
      });
      return answer.kind === 'fall' ? answer.fall : null;
    };
    return ask();
  }

  /** Gives up what is under way, which then fails with ThreadEnded. */
  cancel(): void {
    this.#thread.end();
  }

  /** Its triangles. */
  shape(geometry: BufferGeometry): Shape {
    let shape = this.#shapes.get(geometry);
    if (!shape) {
      shape = shapeOf(geometry);
      this.#shapes.set(geometry, shape);
    }
    return shape;
  }

  #of(geometry: BufferGeometry): Known {
    let known = this.#known.get(geometry);
    if (!known) {
      known = {};
      this.#known.set(geometry, known);
    }
    return known;
  }

  #isSent(geometry: BufferGeometry): boolean {
    return this.#ids.get(geometry)?.life === this.#thread.life;
  }

  #sent(geometry: BufferGeometry): SentMesh {
    const id = this.#ids.get(geometry)?.id ?? ++this.#lastId;
    if (this.#isSent(geometry)) return { id, shape: null };
    this.#ids.set(geometry, { id, life: this.#thread.life });
    return { id, shape: this.shape(geometry) };
  }
}

export const isSmall = (geometry: BufferGeometry): boolean => triangleCount(geometry) <= SMALL;

export function triangleCount({ index, attributes }: BufferGeometry): number {
  return (index?.count ?? attributes.position?.count ?? 0) / 3;
}

function shapeOf({ index, attributes }: BufferGeometry): Shape {
  const { position } = attributes;
  return { positions: position ? floatsOf(position) : new Float32Array(), index: index && integersOf(index) };
}

function floatsOf(attribute: BufferAttribute | InterleavedBufferAttribute): Float32Array {
  if (attribute instanceof BufferAttribute && attribute.array instanceof Float32Array) return attribute.array;
  return Float32Array.from({ length: 3 * attribute.count }, (_, i) =>
    attribute.getComponent(Math.floor(i / 3), i % 3),
  );
}

function integersOf({ array }: BufferAttribute): Uint16Array | Uint32Array {
  return array instanceof Uint16Array || array instanceof Uint32Array ? array : Uint32Array.from(array);
}

/** Those of the page. */
export const pageMeshes = new Meshes(
  () => new Worker(new URL('./mesh-worker.ts', import.meta.url), { type: 'module' }),
);
