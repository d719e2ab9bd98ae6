/**
 * A box is drawn over the picture, and what is in it is selected: drawn to the right, what is wholly within it; to the
 * left, what it touches, as in programs for drawing plans.
 */
import { Box3, type BufferGeometry, Matrix4 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { ignoreEnd } from '../../threads/thread.ts';
import { isSmall, pageMeshes } from '../meshes/meshes.ts';
import type { Overlay } from '../overlay.ts';
import type { Pixel } from '../projector.ts';
import { isInRectangle, type Place, placeOf, type Rectangle, rectangleProjection } from './box-test.ts';
import { CLICK_PX } from './click.ts';

export interface BoxDragOptions {
  readonly canvas: HTMLCanvasElement;
  readonly mirror: SceneMirror;
  readonly session: Session;
  readonly overlay: Overlay;
  /** The next click has another meaning. */
  isTaken(): boolean;
  redraw(): void;
  holdCamera(held: boolean): void;
  onClick(event: PointerEvent): void;
}

interface Box {
  readonly pointerId: number;
  readonly from: Pixel;
  to: Pixel;
}

export class BoxDrag {
  readonly #options: BoxDragOptions;
  #box: Box | null = null;

  constructor(options: BoxDragOptions) {
    this.#options = options;
    const { canvas } = options;
    const capture = { capture: true };
    canvas.addEventListener('pointerdown', (event) => this.#down(event), capture);
    canvas.addEventListener('pointermove', (event) => this.#move(event), capture);
    canvas.addEventListener('pointerup', (event) => this.#up(event), capture);
    canvas.addEventListener('pointercancel', () => this.#end(), capture);
    window.addEventListener(
      'keydown',
      (event) => {
        if (!this.#box || event.key !== 'Escape') return;
        event.stopImmediatePropagation();
        this.#end();
      },
      capture,
    );
  }

  draw(context: CanvasRenderingContext2D): void {
    if (!this.#box || !hasSize(this.#box)) return;
    const { from, to } = this.#box;
    const area = [from.x, from.y, to.x - from.x, to.y - from.y] as const;
    context.save();
    context.fillStyle = 'rgba(234, 165, 75, 0.12)';
    context.fillRect(...area);
    context.lineWidth = 3;
    context.strokeStyle = 'rgba(0, 0, 0, 0.5)';
    context.strokeRect(...area);
    context.lineWidth = 1;
    context.strokeStyle = '#eaa54b';
    // A broken line: what it touches counts, too.
    if (to.x < from.x) context.setLineDash([5, 4]);
    context.strokeRect(...area);
    context.restore();
  }

  #at(event: PointerEvent): Pixel {
    const box = this.#options.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  #down(event: PointerEvent): void {
    const { canvas, session, isTaken, holdCamera } = this.#options;
    if (this.#box) {
      event.stopImmediatePropagation();
      return;
    }
    // With Alt a drag turns the environment.
    const wanted = !event.altKey && (event.shiftKey || session.state.value.tool === 'box');
    if (event.button !== 0 || !wanted || isTaken()) return;
    event.stopImmediatePropagation();
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    canvas.setPointerCapture(event.pointerId);
    holdCamera(true);
    const at = this.#at(event);
    this.#box = { pointerId: event.pointerId, from: at, to: at };
  }

  #move(event: PointerEvent): void {
    if (!this.#box || event.pointerId !== this.#box.pointerId) return;
    event.stopImmediatePropagation();
    this.#box.to = this.#at(event);
    this.#options.redraw();
  }

  #up(event: PointerEvent): void {
    const box = this.#box;
    if (!box || event.pointerId !== box.pointerId) return;
    event.stopImmediatePropagation();
    this.#end();
    if (hasSize(box)) this.#select(box, event);
    else this.#options.onClick(event);
  }

  #end(): void {
    if (!this.#box) return;
    this.#box = null;
    this.#options.holdCamera(false);
    this.#options.redraw();
  }

  #select(box: Box, event: PointerEvent): void {
    const { from, to } = box;
    const { shiftKey, ctrlKey, metaKey } = event;
    const { state, store } = this.#options.session;
    const found = this.#within(from, to);
    if (found instanceof Promise) {
      const { objects, camera } = store.document;
      void found.then(() => {
        // What the box was drawn around is no longer there.
        if (store.document.objects === objects && store.document.camera === camera) this.#select(box, event);
      }, ignoreEnd);
      return;
    }
    const isFound = (entity: Entity) =>
      found.some(({ kind, id }) => kind === entity.kind && id === entity.id);
    const { selected } = state.value;
    const others = selected.filter((entity) => !isFound(entity));
    if (ctrlKey || metaKey) state.selectAll(others);
    else state.selectAll(shiftKey ? [...others, ...found] : found);
  }

  /** A promise of when to ask again, while the tree of a large mesh is not there. */
  #within(from: Pixel, to: Pixel): Entity[] | Promise<void> {
    const { canvas, mirror, session, overlay } = this.#options;
    const { clientWidth: width, clientHeight: height } = canvas;
    const [left, right] = [Math.min(from.x, to.x), Math.max(from.x, to.x)];
    const [top, bottom] = [Math.min(from.y, to.y), Math.max(from.y, to.y)];
    const { camera } = mirror;
    camera.updateMatrixWorld();
    const rectangle: Rectangle = {
      left: (2 * left) / width - 1,
      right: (2 * right) / width - 1,
      bottom: 1 - (2 * bottom) / height,
      top: 1 - (2 * top) / height,
    };
    const toRectangle = rectangleProjection(
      new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
      rectangle,
    );
    let waiting: Promise<void> | null = null;
    const objects = Object.entries(session.store.document.objects).flatMap(([id, { locked }]): Entity[] => {
      const mesh = locked ? undefined : mirror.objectFor(id);
      if (!mesh?.visible) return [];
      mesh.updateWorldMatrix(true, false);
      const { geometry } = mesh;
      const own = toRectangle.clone().multiply(mesh.matrixWorld);
      const known = boundsOf(geometry, own);
      if (known !== 'across') return known === 'inside' ? [{ kind: 'objects', id }] : [];
      // Of many that have no tree, one is asked for at a time.
      if (waiting) return [];
      const tree = isSmall(geometry) ? null : pageMeshes.tree(geometry);
      if (tree instanceof Promise) {
        waiting = tree;
        return [];
      }
      const inside = isInRectangle(pageMeshes.shape(geometry), own, to.x < from.x, tree);
      return inside ? [{ kind: 'objects', id }] : [];
    });
    if (waiting) return waiting;
    const lights = overlay.lights
      .filter(({ x, y }) => x >= left && x <= right && y >= top && y <= bottom)
      .map(({ id }): Entity => ({ kind: 'lights', id }));
    return [...lights, ...objects];
  }
}

/** Where the bounds of a mesh are, which may be all that matters. */
function boundsOf(geometry: BufferGeometry, toRectangle: Matrix4): Place {
  if (!geometry.boundingBox) geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox ?? new Box3();
  return placeOf([...min.toArray(), ...max.toArray()], 0, toRectangle);
}

function hasSize({ from, to }: Box): boolean {
  return Math.hypot(to.x - from.x, to.y - from.y) > CLICK_PX;
}
