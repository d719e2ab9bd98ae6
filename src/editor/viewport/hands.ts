/** Working with the hands in the picture: what is drawn over it, what is selected, moved and looked at. */
import type { PerspectiveCamera, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../scene/mirror.ts';
import { plural, t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { CameraControl, CameraStep } from './camera.ts';
import { FocusPicking } from './focus-picking.ts';
import { Gizmo } from './gizmo/gizmo.ts';
import { Menus } from './menus.ts';
import { type AxesGizmo, createAxesGizmo } from './navigation/axes-gizmo.ts';
import { boundsOf } from './navigation/bounds.ts';
import {
  type AxisDirection,
  directionOf,
  nearestAxis,
  type ViewAxes,
  viewAxes,
} from './navigation/view-axes.ts';
import { createOverlay, type Overlay } from './overlay.ts';
import { dropSelection, nudgeSelection } from './placing/drop.ts';
import { BoxDrag } from './selecting/box-drag.ts';
import { clickAt, installClicks, pickFirst } from './selecting/click.ts';
import { createToolbar } from './toolbar.ts';

export interface HandsOptions {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly session: Session;
  readonly mirror: SceneMirror;
  readonly camera: CameraControl;
}

/** A way along an axis of the view. */
export interface Nudge {
  readonly along: keyof ViewAxes;
  /** m */
  readonly by: number;
}

export class Hands {
  readonly #options: HandsOptions;
  readonly #overlay: Overlay;
  readonly #gizmo: Gizmo;
  readonly #box: BoxDrag;
  readonly #axes: AxesGizmo;
  readonly #focusPicking: FocusPicking;
  readonly #menus: Menus;
  #scheduled = false;

  constructor(options: HandsOptions) {
    const { element, canvas, session, mirror, camera } = options;
    this.#options = options;
    this.#overlay = createOverlay();
    this.#focusPicking = new FocusPicking({ canvas, mirror, session });
    const picking = { canvas, mirror, session, overlay: this.#overlay, focusPicking: this.#focusPicking };
    const dragging = {
      ...picking,
      isTaken: () => this.#focusPicking.on,
      redraw: () => this.#schedule(),
      holdCamera: (held: boolean) => camera.hold(held),
      onClick: (event: PointerEvent) => clickAt(picking, event),
    };
    // The gizmo is in front: it hears of the pointer first.
    this.#gizmo = new Gizmo(dragging);
    this.#box = new BoxDrag(dragging);
    installClicks(picking, () => this.focusSelection());
    this.#menus = new Menus({ ...options, pick: (event, use) => pickFirst(picking, event, use) });
    this.#axes = createAxesGizmo((direction) => this.look(direction));
    element.addEventListener('pointermove', (event) => this.#passOn(event), { capture: true });
    element.append(this.#overlay.element, this.#axes.element, createToolbar(session));
    session.state.subscribe((now, before) => {
      if (now.selected !== before.selected) this.#schedule();
      canvas.classList.toggle('box-tool', now.tool === 'box');
    });
  }

  get #camera(): PerspectiveCamera {
    return this.#options.mirror.camera;
  }

  /** Once a frame; what changes without one asks for itself. */
  draw(): void {
    const { session, mirror } = this.#options;
    const { selected } = session.state.value;
    this.#axes.update(mirror.camera);
    this.#overlay.draw({
      document: session.store.document,
      camera: mirror.camera,
      selected,
      tools: (context) => {
        this.#gizmo.draw(context);
        this.#box.draw(context);
      },
    });
  }

  /** A handle of the gizmo that lies under the line between two pictures is in front of it. */
  #passOn(event: PointerEvent): void {
    const { target, buttons } = event;
    const { classList } = this.#options.element;
    const isOnLine = target instanceof Element && target.closest('.split-line') !== null;
    if (buttons === 0 && (isOnLine || classList.contains('on-handle')))
      classList.toggle('on-handle', this.isOnHandle(event));
  }

  #schedule(): void {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      this.draw();
    });
  }

  /** The next click on the picture sets the distance that is in focus; Escape lets it be. */
  pickFocus(): void {
    this.#focusPicking.toggle();
  }

  /** Looks at all that is selected, or at everything. */
  focusSelection(): void {
    const { session, mirror, camera } = this.#options;
    const { selected } = session.state.value;
    const { document } = session.store;
    const [first] = selected;
    const name = (first && document[first.kind][first.id]?.name) ?? t('the scene');
    const label =
      selected.length < 2
        ? t('Focus {name}', { name })
        : plural(selected.length, 'Focus {name}', 'Focus {count} things', { name });
    camera.focus(boundsOf(document, mirror, selected), label);
  }

  /** Looks at everything, whatever is selected. */
  frameAll(): void {
    const { session, mirror, camera } = this.#options;
    camera.focus(boundsOf(session.store.document, mirror, []), t('Look at everything'));
  }

  /** Goes round what is looked at, or nearer to it. */
  step(by: CameraStep): void {
    this.#options.camera.step(by);
  }

  /** Looks from that side; from there already, from the other side. */
  look(direction: AxisDirection): void {
    const from = directionOf(direction);
    const isThere = this.#side().dot(from) > 1 - 1e-4;
    this.#lookFrom(isThere ? from.negate() : from);
  }

  /** Looks along the same axis from behind. */
  lookFromOtherSide(): void {
    this.#lookFrom(directionOf(nearestAxis(this.#side())).negate());
  }

  #lookFrom(from: Vector3): void {
    this.#options.camera.lookFrom(from, t('Look along an axis'));
  }

  /** Where the camera is, seen from what it looks at. */
  #side(): Vector3 {
    const { position, target } = this.#options.camera.pose();
    return this.#camera.position
      .clone()
      .fromArray(position)
      .sub(this.#camera.position.clone().fromArray(target))
      .normalize();
  }

  /** Whether the pointer is on a handle of the gizmo. */
  isOnHandle(event: PointerEvent): boolean {
    return this.#gizmo.isAt(event);
  }

  /** What is selected follows the pointer, or what is typed, with the tool that is chosen. */
  grab(): void {
    this.#gizmo.grab();
  }

  /** What can be added, in a menu at the pointer. */
  openAddMenu(): void {
    this.#menus.openAdd();
  }

  /** How what is selected can be aligned, in a menu at the pointer. */
  openAlignMenu(): void {
    this.#menus.openAlign();
  }

  nudge({ along, by }: Nudge): void {
    nudgeSelection(this.#options.session, viewAxes(this.#camera)[along].clone().multiplyScalar(by));
  }

  drop(): void {
    void dropSelection(this.#options.session, this.#options.mirror);
  }
}
