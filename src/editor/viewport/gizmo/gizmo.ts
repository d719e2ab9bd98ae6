/**
 * The gizmo under the pointer: finds the handle, and edits the document as it is dragged.
 *
 * A drag edits the document with every move, as a slider does, and does not only move the picture's meshes: the path
 * traced picture, the inspector's numbers and the motion that effects read all follow the document, and none of them
 * has to be told of another state. An edit that moves something sets matrices, which compiles nothing.
 */

import { isMember } from '../../../scene/entity.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import { duplicateEntities } from '../../../scene/selection-commands.ts';
import { type PlacedEntity, place } from '../../../scene/transform-commands.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { newGesture } from '../../ui/gesture.ts';
import type { Pixel } from '../projector.ts';
import { pointerRay } from './camera-view.ts';
import { type Pointer, startDrag } from './drag.ts';
import { drawGizmo, drawTarget } from './draw.ts';
import { handleAt } from './handles.ts';
import { changeOf, constrain, type Grip, type Held } from './held.ts';
import { moversOf } from './movers.ts';
import { pictureOf } from './picture.ts';
import { changed, handStep } from './placed.ts';
import { labelOf, type Stand, Stands } from './stand.ts';
import { aimAt, type Target, targetsOf } from './targets.ts';
import { typedAfter } from './typed.ts';

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
/** CSS pixels from the middle to where something is held without a pointer. */
const ARM_PX = 80;
/** A pointer that has moved less has not dragged. */
const DRAG_PX = 3;

export class Gizmo {
  readonly #options: GizmoOptions;
  readonly #stands: Stands;
  #hovered: Grip | null = null;
  #held: Held | null = null;
  /** Where the pointer was last, on the page. */
  #at: { readonly clientX: number; readonly clientY: number } | null = null;

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
    canvas.addEventListener('pointerleave', () => {
      this.#at = null;
      this.#hover(null);
    });
    window.addEventListener('pointerdown', (event) => this.#press(event), capture);
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
        ? {
            handle,
            change: held.change,
            from: held.stand,
            start: held.start,
            at: held.last.pointer.at,
            typed: held.typed,
          }
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
    // Shift selects.
    if (event.button !== 0 || event.shiftKey || isTaken()) return;
    const start = this.#pointer(event);
    const grip = this.#gripAt(start.at, event.pointerType === 'mouse' ? REACH.mouse : REACH.touch);
    // With Alt copies are dragged; of a target there are none.
    if (!grip || (event.altKey && 'target' in grip)) return;
    event.stopImmediatePropagation();
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    canvas.setPointerCapture(event.pointerId);
    this.#hold(event.pointerId, grip, start, event);
  }

  #hold(
    pointerId: number | null,
    grip: Grip,
    start: Pointer,
    { altKey, ctrlKey, metaKey }: Pick<PointerEvent, 'altKey' | 'ctrlKey' | 'metaKey'>,
  ): void {
    this.#options.holdCamera(true);
    const stand = this.#stand();
    const { selected, steps } = this.#options.session.state.value;
    this.#held = {
      pointerId,
      grip,
      stand,
      drag:
        stand && 'handle' in grip
          ? startDrag(stand.tool, grip.handle, stand.frame, stand.view, start, steps)
          : null,
      start,
      merge: newGesture(),
      ...{ selected, steps },
      last: { pointer: start, ctrl: ctrlKey || metaKey },
      change: null,
      moved: false,
      typed: '',
      copies: altKey,
    };
    this.#hover(grip);
    this.#options.redraw();
  }

  /** Whether the pointer would take hold of something here. */
  isAt(event: PointerEvent): boolean {
    return this.#gripAt(this.#pointer(event).at, REACH.mouse) !== null;
  }

  /** Takes hold of what is selected without a button: it follows the pointer, or what is typed, until a click or Enter. */
  grab(): void {
    const { canvas, session, isTaken } = this.#options;
    if (this.#held || isTaken()) return;
    const { tool } = session.state.value;
    if (tool === 'select' || tool === 'box') session.state.set({ tool: 'move' });
    const stand = this.#stand();
    const middle = stand?.view.project(stand.frame.pivot);
    if (!stand || !middle) return;
    const box = canvas.getBoundingClientRect();
    // Beside the middle, about which it turns, where there is no pointer.
    const at = this.#at ?? { clientX: box.left + middle.x + ARM_PX, clientY: box.top + middle.y };
    const handle = stand.tool === 'rotate' ? 'view' : 'centre';
    const start = pointerRay(this.#options.mirror.camera, canvas, at);
    this.#hold(null, { handle }, start, { altKey: false, ctrlKey: false, metaKey: false });
  }

  /** A click anywhere ends what follows the pointer without a button; the right one puts it back. */
  #press(event: PointerEvent): void {
    if (!this.#held || this.#held.pointerId !== null) return;
    if (event.target === this.#options.canvas) event.stopImmediatePropagation();
    if (event.button === 2) this.#abandon();
    else this.#confirm();
  }

  #move(event: PointerEvent): void {
    const held = this.#held;
    this.#at = event;
    if (!held) {
      if (event.buttons === 0 && event.pointerType !== 'touch')
        this.#hover(this.#gripAt(this.#pointer(event).at, REACH.mouse));
      return;
    }
    event.stopImmediatePropagation();
    if (held.pointerId !== null && event.pointerId !== held.pointerId) return;
    // The right button, too: it is put back.
    if (held.pointerId !== null && event.buttons & 2) {
      this.#abandon();
      return;
    }
    const pointer = this.#pointer(event);
    held.last = { pointer, ctrl: event.ctrlKey || event.metaKey };
    held.moved ||= Math.hypot(pointer.at.x - held.start.at.x, pointer.at.y - held.start.at.y) >= DRAG_PX;
    if (held.moved) this.#apply(held);
  }

  #apply(held: Held): void {
    const { session } = this.#options;
    const snap = held.last.ctrl !== session.state.value.snap;
    if ('target' in held.grip) this.#aim(held, held.grip.target, snap ? held.steps.move : null);
    else this.#transform(held, snap);
    // A pointer that moves where the document stays as it is still moves the numbers beside it.
    this.#options.redraw();
  }

  #transform(held: Held, snap: boolean): void {
    if (held.copies) this.#copy(held);
    const change = changeOf(held, snap);
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

  /** What is dragged from now on are copies, in the same step of undo. */
  #copy(held: Held): void {
    const { store, state } = this.#options.session;
    held.copies = false;
    const members = held.selected.filter(isMember);
    const copies = attempt(t('Not duplicated'), () => duplicateEntities(store, members, held.merge));
    if (!copies || !held.stand) return;
    state.selectAll(copies);
    held.stand = { ...held.stand, movers: moversOf(store.document, copies) };
  }

  #aim(held: Held, target: Target, step: number | null): void {
    const { mirror } = this.#options;
    const position = aimAt(mirror, target, held.last.pointer, step);
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
    this.#confirm();
    if (held.moved || !('handle' in held.grip)) return;
    // The middle covers what it moves, and a click with Alt is for what is behind; the other handles are nobody else's.
    if (held.grip.handle === 'centre' || event.altKey) this.#options.onClick(event);
  }

  #confirm(): void {
    if (!this.#held) return;
    this.#release();
    this.#options.session.store.endMerge();
  }

  #abandon(): void {
    const held = this.#held;
    if (!held) return;
    this.#release();
    const { store, state } = this.#options.session;
    store.abandon(held.merge);
    state.selectAll(held.selected);
  }

  #release(): void {
    this.#held = null;
    this.#options.holdCamera(false);
    this.#hover(null);
    this.#options.redraw();
  }

  /**
   * Escape puts it back, Enter ends it, Ctrl goes to steps and back, x, y and z hold it to an axis, and numbers say how far;
   * nothing else happens to the scene during a drag.
   */
  #key(event: KeyboardEvent): void {
    const held = this.#held;
    if (!held) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    const { key, type, shiftKey } = event;
    if (key === 'Control' || key === 'Meta') held.last = { ...held.last, ctrl: type === 'keydown' };
    else if (type === 'keyup') return;
    else if (key === 'Escape') {
      this.#abandon();
      return;
    } else if (key === 'Enter') {
      this.#confirm();
      return;
    } else if (event.ctrlKey || event.metaKey || event.altKey || !('handle' in held.grip)) return;
    else if (constrain(held, key, shiftKey)) this.#hover(held.grip);
    else {
      const typed = typedAfter(held.typed, key);
      if (typed === null) return;
      held.typed = typed;
      held.moved = true;
    }
    if (held.moved) this.#apply(held);
    else this.#options.redraw();
  }
}
