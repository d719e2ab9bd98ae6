/**
 * The gizmo under the pointer: finds the handle, and edits the document as it is dragged.
 *
 * A drag edits the document with every move, as a slider does, and does not only move the picture's meshes: the path
 * traced picture, the inspector's numbers and the motion that effects read all follow the document, and none of them
 * has to be told of another state. An edit that moves something sets matrices, which compiles nothing.
 */
import type { SceneMirror } from '../../../scene/mirror.ts';
import { type PlacedEntity, place } from '../../../scene/transform-commands.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { newGesture } from '../../ui/gesture.ts';
import type { Pixel } from '../projector.ts';
import { pointerRay } from './camera-view.ts';
import { type Drag, type Pointer, startDrag } from './drag.ts';
import { drawGizmo, drawTarget } from './draw.ts';
import { type HandleId, handleAt } from './handles.ts';
import { pictureOf } from './picture.ts';
import { type Change, changed, handStep } from './placed.ts';
import { labelOf, type Stand, Stands } from './stand.ts';
import { aimAt, type Target, targetsOf } from './targets.ts';

export interface GizmoOptions {
  readonly canvas: HTMLCanvasElement;
  readonly mirror: SceneMirror;
  readonly session: Session;
  /** Draws the overlay anew; the picture under it is as it was. */
  redraw(): void;
  /** While something is dragged the camera stays. */
  holdCamera(held: boolean): void;
  /** The next click has another meaning. */
  isTaken(): boolean;
  /** The middle was touched and not dragged. */
  onClick(event: PointerEvent): void;
}

/** CSS pixels beside a line that still count, by what points. */
const REACH = { mouse: 7, touch: 18 } as const;
/** A pointer that has moved less has not dragged. */
const DRAG_PX = 3;

/** What the pointer is on: a handle, or the target of a light. */
type Grip = { readonly handle: HandleId } | { readonly target: Target };

interface Held {
  readonly pointerId: number;
  readonly grip: Grip;
  readonly stand: Stand | null;
  readonly drag: Drag | null;
  readonly start: Pointer;
  readonly merge: string;
  last: { readonly pointer: Pointer; readonly ctrl: boolean };
  change: Change | null;
  moved: boolean;
}

export class Gizmo {
  readonly #options: GizmoOptions;
  readonly #stands: Stands;
  #hovered: Grip | null = null;
  #held: Held | null = null;

  constructor(options: GizmoOptions) {
    this.#options = options;
    this.#stands = new Stands(options);
    const { canvas, session } = options;
    // Before the controls of the camera hear of it.
    const capture = { capture: true };
    canvas.addEventListener('pointerdown', (event) => this.#down(event), capture);
    canvas.addEventListener('pointermove', (event) => this.#move(event), capture);
    canvas.addEventListener('pointerup', (event) => this.#up(event), capture);
    canvas.addEventListener('pointercancel', () => this.#abandon(), capture);
    canvas.addEventListener('pointerleave', () => this.#hover(null));
    window.addEventListener('keydown', (event) => this.#key(event), capture);
    window.addEventListener('keyup', (event) => this.#key(event), capture);
    session.state.subscribe((now, before) => {
      if (now.tool !== before.tool || now.space !== before.space || now.pivot !== before.pivot)
        options.redraw();
    });
  }

  draw(context: CanvasRenderingContext2D): void {
    const held = this.#held;
    const grip = held?.grip ?? this.#hovered;
    for (const target of this.#targets()) {
      const chosen = grip !== null && 'target' in grip && grip.target.id === target.id;
      drawTarget(context, target.at, chosen);
    }
    const stand = this.#stand();
    if (!stand || (held && 'target' in held.grip)) return;
    const handle = grip && 'handle' in grip ? grip.handle : null;
    const dragged =
      handle !== null && held?.stand && held.change
        ? { handle, change: held.change, from: held.stand, start: held.start, at: held.last.pointer.at }
        : null;
    drawGizmo(context, pictureOf(stand, handle, dragged));
  }

  #stand(): Stand | null {
    // While it is turned, the gizmo stays as it was taken hold of.
    const held = this.#held?.stand;
    return this.#stands.of(held?.tool === 'rotate' ? held.frame.axes : null);
  }

  #targets(): Target[] {
    const { session, mirror, canvas } = this.#options;
    const { selected } = session.state.value;
    return targetsOf(
      session.store.document,
      selected,
      mirror.camera,
      canvas.clientWidth,
      canvas.clientHeight,
    );
  }

  #gripAt(at: Pixel, reach: number): Grip | null {
    const stand = this.#stand();
    const handle = stand && handleAt(stand.handles, at, reach);
    if (handle) return { handle };
    const target = this.#targets().find((one) => Math.hypot(one.at.x - at.x, one.at.y - at.y) <= reach + 3);
    return target ? { target } : null;
  }

  #pointer(event: PointerEvent): Pointer {
    const { canvas, mirror } = this.#options;
    return pointerRay(mirror.camera, canvas, event);
  }

  #hover(grip: Grip | null): void {
    if (JSON.stringify(grip) === JSON.stringify(this.#hovered)) return;
    this.#hovered = grip;
    this.#options.canvas.classList.toggle('on-handle', grip !== null);
    this.#options.redraw();
  }

  #down(event: PointerEvent): void {
    // A second finger leaves the drag of the first alone.
    if (this.#held) {
      event.stopImmediatePropagation();
      return;
    }
    const { canvas, isTaken } = this.#options;
    // Shift and Alt select.
    if (event.button !== 0 || event.shiftKey || event.altKey || isTaken()) return;
    const start = this.#pointer(event);
    const grip = this.#gripAt(start.at, event.pointerType === 'mouse' ? REACH.mouse : REACH.touch);
    if (!grip) return;
    event.stopImmediatePropagation();
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    canvas.setPointerCapture(event.pointerId);
    this.#options.holdCamera(true);
    const stand = this.#stand();
    const drag =
      stand && 'handle' in grip ? startDrag(stand.tool, grip.handle, stand.frame, stand.view, start) : null;
    this.#held = {
      pointerId: event.pointerId,
      grip,
      stand,
      drag,
      start,
      merge: newGesture(),
      last: { pointer: start, ctrl: event.ctrlKey || event.metaKey },
      change: null,
      moved: false,
    };
    this.#hover(grip);
    this.#options.redraw();
  }

  #move(event: PointerEvent): void {
    const held = this.#held;
    if (!held) {
      if (event.buttons === 0 && event.pointerType !== 'touch')
        this.#hover(this.#gripAt(this.#pointer(event).at, REACH.mouse));
      return;
    }
    event.stopImmediatePropagation();
    if (event.pointerId !== held.pointerId) return;
    const pointer = this.#pointer(event);
    held.last = { pointer, ctrl: event.ctrlKey || event.metaKey };
    held.moved ||= Math.hypot(pointer.at.x - held.start.at.x, pointer.at.y - held.start.at.y) >= DRAG_PX;
    if (held.moved) this.#apply(held);
  }

  #apply(held: Held): void {
    const { session } = this.#options;
    const snap = held.last.ctrl !== session.state.value.snap;
    if ('target' in held.grip) this.#aim(held, held.grip.target, snap);
    else this.#transform(held, snap);
    // A pointer that moves where the document stays as it is still moves the numbers beside it.
    this.#options.redraw();
  }

  #transform(held: Held, snap: boolean): void {
    const change = held.drag?.(held.last.pointer, snap);
    const { stand } = held;
    if (!change || !stand) return;
    held.change = change;
    const step = handStep(stand.view.pixel);
    const entities = stand.movers.map(
      ({ kind, id, placed, axes }): PlacedEntity => ({
        kind,
        id,
        placement: changed(placed, axes, change, stand.frame, step),
      }),
    );
    this.#write(held, labelOf(stand), entities);
  }

  #aim(held: Held, target: Target, snap: boolean): void {
    const { mirror } = this.#options;
    const position = aimAt(mirror, target, held.last.pointer, snap);
    if (position)
      this.#write(held, t('Aim {name}', { name: target.name }), [
        { kind: 'lights', id: target.id, placement: { target: position } },
      ]);
  }

  #write({ merge }: Held, label: string, entities: readonly PlacedEntity[]): void {
    const { store } = this.#options.session;
    attempt(t('It stays where it was'), () => place(store, label, entities, merge));
  }

  #up(event: PointerEvent): void {
    const held = this.#held;
    if (!held || event.pointerId !== held.pointerId) return;
    event.stopImmediatePropagation();
    this.#release();
    this.#options.session.store.endMerge();
    // The middle covers what it moves; the other handles are nobody else's.
    if (!held.moved && 'handle' in held.grip && held.grip.handle === 'centre') this.#options.onClick(event);
  }

  #abandon(): void {
    const held = this.#held;
    if (!held) return;
    this.#release();
    this.#options.session.store.abandon(held.merge);
  }

  #release(): void {
    this.#held = null;
    this.#options.holdCamera(false);
    this.#hover(null);
    this.#options.redraw();
  }

  /** Escape puts it back; Ctrl goes to steps and back; nothing else happens to the scene during a drag. */
  #key(event: KeyboardEvent): void {
    const held = this.#held;
    if (!held) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    if (event.key === 'Escape') this.#abandon();
    else if (event.key === 'Control' || event.key === 'Meta') {
      held.last = { ...held.last, ctrl: event.type === 'keydown' };
      if (held.moved) this.#apply(held);
    }
  }
}
