/** Draws the outlines of what is selected on the overlay: the last chosen in the accent's colour, the others paler. */
import { Box3, type BufferGeometry, Matrix4, type Mesh, type PerspectiveCamera, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Entity } from '../../state.ts';
import { boxCorners, type Line } from '../light-lines.ts';
import { type MeshEdges, meshEdges } from './mesh-edges.ts';
import { type Loop, silhouette } from './silhouette.ts';

/** CSS pixels. */
const WIDTH = 2;
const HALO_WIDTH = 1.25;
const LAST = '#f6a93b';
const OTHERS = '#d8b98a';
const HALO = 'rgba(0, 0, 0, 0.45)';
/** Triangles whose outlines are found, 8 ms a frame for 100 000; what is beyond has marks at the corners of its bounds. */
const MAX_TRIANGLES = 300_000;

interface Cached {
  readonly edges: MeshEdges;
  readonly toClip: Matrix4;
  readonly size: string;
  readonly path: Path2D;
}

export class Outlines {
  readonly #mirror: SceneMirror;
  readonly #edges = new WeakMap<BufferGeometry, MeshEdges>();
  readonly #cache = new WeakMap<Mesh, Cached>();
  /** Outlines are made here: lines around what is then erased within them. */
  #layer: HTMLCanvasElement | null = null;

  constructor(mirror: SceneMirror) {
    this.#mirror = mirror;
  }

  /** @returns marks for what is too large to have an outline */
  draw(
    context: CanvasRenderingContext2D,
    selected: readonly Entity[],
    width: number,
    height: number,
  ): Line[] {
    const meshes = selected.flatMap(({ kind, id }) => {
      const mesh = kind === 'objects' ? this.#mirror.objectFor(id) : undefined;
      return mesh?.visible ? [mesh] : [];
    });
    if (meshes.length === 0) {
      this.#layer = null;
      return [];
    }
    const { camera } = this.#mirror;
    const layer = this.#layerOf(context.canvas);
    const lines: Line[] = [];
    let triangles = 0;
    const [last, others]: [Path2D[], Path2D[]] = [[], []];
    const isLast = selected.at(-1)?.kind === 'objects';
    // The last first: it has its outline whatever the others cost.
    for (const [i, mesh] of meshes.reverse().entries()) {
      mesh.updateWorldMatrix(true, false);
      triangles += triangleCount(mesh.geometry);
      if (triangles > MAX_TRIANGLES) lines.push(...cornersOf(mesh));
      else (i === 0 && isLast ? last : others).push(this.#path(mesh, camera, width, height));
    }
    paint(context, layer, others, OTHERS, WIDTH * 0.75);
    paint(context, layer, last, LAST, WIDTH);
    return lines;
  }

  #layerOf({ width, height }: HTMLCanvasElement): HTMLCanvasElement {
    this.#layer ??= document.createElement('canvas');
    if (this.#layer.width !== width) this.#layer.width = width;
    if (this.#layer.height !== height) this.#layer.height = height;
    return this.#layer;
  }

  /** A frame of a scene that stands still costs nothing. */
  #path(mesh: Mesh, camera: PerspectiveCamera, width: number, height: number): Path2D {
    const edges = this.#edgesOf(mesh.geometry);
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

  #edgesOf(geometry: BufferGeometry): MeshEdges {
    let edges = this.#edges.get(geometry);
    if (!edges) {
      edges = meshEdges(geometry.getAttribute('position').array, geometry.index?.array ?? null);
      this.#edges.set(geometry, edges);
    }
    return edges;
  }
}

function triangleCount({ index, attributes }: BufferGeometry): number {
  return (index?.count ?? attributes.position?.count ?? 0) / 3;
}

/** The bounds in the object's own space, so that the marks turn with it. */
function cornersOf(mesh: Mesh): Line[] {
  if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
  return boxCorners(mesh.geometry.boundingBox ?? new Box3(), mesh.matrixWorld);
}

/** Lines twice as wide as wanted, whose inner halves, and all that crosses the thing, are erased. */
function paint(
  context: CanvasRenderingContext2D,
  layer: HTMLCanvasElement,
  paths: readonly Path2D[],
  color: string,
  width: number,
): void {
  const on = layer.getContext('2d');
  if (!on || paths.length === 0) return;
  const ratio = context.getTransform().a;
  on.setTransform(1, 0, 0, 1, 0, 0);
  on.clearRect(0, 0, layer.width, layer.height);
  on.setTransform(ratio, 0, 0, ratio, 0, 0);
  on.lineJoin = 'round';
  for (const [stroke, extra] of [
    [HALO, HALO_WIDTH],
    [color, 0],
  ] as const) {
    on.strokeStyle = stroke;
    on.lineWidth = 2 * (width + extra);
    for (const path of paths) on.stroke(path);
  }
  on.globalCompositeOperation = 'destination-out';
  for (const path of paths) on.fill(path, 'nonzero');
  on.globalCompositeOperation = 'source-over';
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(layer, 0, 0);
  context.restore();
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
