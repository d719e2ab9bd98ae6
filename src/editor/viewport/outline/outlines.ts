/** Draws the outlines of what is selected on the overlay: the last chosen in the accent's colour, the others paler. */
import { Box3, Matrix4, type Mesh, type PerspectiveCamera, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Entity } from '../../state.ts';
import { boxCorners, type Line } from '../light-lines.ts';
import { type Meshes, triangleCount } from '../meshes/meshes.ts';
import type { Point } from '../projector.ts';
import { OutlineLayer } from './layer.ts';
import type { MeshEdges } from './mesh-edges.ts';
import { type Loop, silhouette } from './silhouette.ts';

/** Triangles whose outlines are found, 8 ms a frame for 100 000; what is beyond has marks at the corners of its bounds. */
const MAX_TRIANGLES = 300_000;
/** Objects that have outlines; of what is beyond, only the places are marked. */
const MAX_OBJECTS = 300;

/** Beside the outlines. */
export interface Marks {
  readonly corners: readonly Line[];
  readonly places: readonly Point[];
}

interface Cached {
  readonly edges: MeshEdges;
  readonly toClip: Matrix4;
  readonly size: string;
  readonly path: Path2D;
}

export class Outlines {
  readonly #mirror: SceneMirror;
  readonly #meshes: Meshes;
  readonly #redraw: () => void;
  readonly #cache = new WeakMap<Mesh, Cached>();
  #layer: OutlineLayer | null = null;

  /** @param redraw is called when an outline can be drawn that could not before */
  constructor(mirror: SceneMirror, meshes: Meshes, redraw: () => void) {
    this.#mirror = mirror;
    this.#meshes = meshes;
    this.#redraw = redraw;
  }

  draw(context: CanvasRenderingContext2D, selected: readonly Entity[], width: number, height: number): Marks {
    const meshes = selected.flatMap(({ kind, id }) => {
      const mesh = kind === 'objects' ? this.#mirror.objectFor(id) : undefined;
      return mesh?.visible ? [mesh] : [];
    });
    const marks = { corners: [] as Line[], places: [] as Point[] };
    if (meshes.length === 0) {
      this.#layer = null;
      return marks;
    }
    const [last, others]: [Path2D[], Path2D[]] = [[], []];
    const isLast = selected.at(-1)?.kind === 'objects';
    let triangles = 0;
    // The last first: it has its outline whatever the others cost.
    for (const [i, mesh] of meshes.reverse().entries()) {
      mesh.updateWorldMatrix(true, false);
      triangles += triangleCount(mesh.geometry);
      if (i >= MAX_OBJECTS) marks.places.push(placeOf(mesh));
      else {
        const edges = triangles > MAX_TRIANGLES ? null : this.#meshes.edges(mesh.geometry, this.#redraw);
        if (edges === null) marks.corners.push(...cornersOf(mesh));
        else
          (i === 0 && isLast ? last : others).push(
            this.#path(mesh, edges, this.#mirror.camera, width, height),
          );
      }
    }
    this.#layer ??= new OutlineLayer();
    this.#layer.draw(context, last, others);
    return marks;
  }

  /** The same path as long as nothing has moved. */
  #path(mesh: Mesh, edges: MeshEdges, camera: PerspectiveCamera, width: number, height: number): Path2D {
    const toClip = new Matrix4()
      .multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
      .multiply(mesh.matrixWorld);
    const size = `${width} ${height}`;
    const cached = this.#cache.get(mesh);
    if (cached?.edges === edges && cached.size === size && cached.toClip.equals(toClip)) return cached.path;
    const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld);
    eye.applyMatrix4(new Matrix4().copy(mesh.matrixWorld).invert());
    const path = pathOf(silhouette(edges, { eye, toClip, near: camera.near, width, height }));
    this.#cache.set(mesh, { edges, toClip, size, path });
    return path;
  }
}

/** The bounds in the object's own space, so that the marks turn with it. */
function cornersOf(mesh: Mesh): Line[] {
  if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
  return boxCorners(mesh.geometry.boundingBox ?? new Box3(), mesh.matrixWorld);
}

function placeOf({ matrixWorld: { elements: e } }: Mesh): Point {
  return [e[12] as number, e[13] as number, e[14] as number];
}

function pathOf(loops: readonly Loop[]): Path2D {
  const path = new Path2D();
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i += 2) {
      if (i === 0) path.moveTo(loop[i] as number, loop[i + 1] as number);
      else path.lineTo(loop[i] as number, loop[i + 1] as number);
    }
    path.closePath();
  }
  return path;
}
