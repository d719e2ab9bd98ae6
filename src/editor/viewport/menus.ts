/** Menus at the pointer: what can be done to what is there, what can be added, how things are aligned. */
import type { SceneMirror } from '../../scene/mirror.ts';
import { actionEntry } from '../actions/entry.ts';
import { t } from '../language/language.ts';
import { addEntries } from '../panels/add-menu.ts';
import { selectionEntries } from '../panels/selection-menu.ts';
import type { Session } from '../session.ts';
import type { Entity } from '../state.ts';
import { h } from '../ui/dom.ts';
import { type MenuEntry, openMenu } from '../ui/menu.ts';
import { type Alignment, alignSelected } from './placing/align.ts';
import { CLICK_PX } from './selecting/click.ts';

export interface MenusOptions {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly session: Session;
  readonly mirror: SceneMirror;
  /** What is under the pointer, once it is known. */
  pick(event: MouseEvent, use: (found: Entity | null) => void): void;
}

interface Place {
  readonly x: number;
  readonly y: number;
}

export class Menus {
  readonly #options: MenusOptions;
  /** Where the pointer was last over the picture, in CSS pixels of the page. */
  #at: Place | null = null;

  constructor(options: MenusOptions) {
    this.#options = options;
    const { canvas } = options;
    let down: Place | null = null;
    const placeOf = ({ clientX, clientY }: MouseEvent): Place => ({ x: clientX, y: clientY });
    canvas.addEventListener('pointermove', (event) => {
      this.#at = placeOf(event);
    });
    canvas.addEventListener('pointerleave', () => {
      this.#at = null;
    });
    canvas.addEventListener('pointerdown', (event) => {
      down = event.button === 2 ? placeOf(event) : null;
    });
    // A drag with this button moves the camera; browsers differ in when they ask for a menu.
    canvas.addEventListener('pointerup', (event) => {
      const still = down && Math.hypot(event.clientX - down.x, event.clientY - down.y) <= CLICK_PX;
      down = null;
      if (event.button === 2 && still) this.#openFor(event);
    });
    // A finger that rests, and the key for it.
    canvas.addEventListener('contextmenu', (event) => {
      event.preventDefault();
      const isKey = event.button !== 2;
      if (!event.isTrusted || isKey) this.#openFor(event);
    });
  }

  /** What can be added, at the pointer. */
  openAdd(): void {
    this.#open(t('Add'), addEntries(this.#options.session));
  }

  /** How what is selected can be aligned, at the pointer. */
  openAlign(): void {
    const { session, mirror } = this.#options;
    const label: Readonly<Record<Alignment, string>> = {
      low: t('Lower ends'),
      middle: t('Middles'),
      high: t('Upper ends'),
      spread: t('Distribute evenly'),
    };
    const entries = (['x', 'y', 'z'] as const).flatMap((name, axis): MenuEntry[] => [
      { heading: t('Along {axis}', { axis: name }) },
      ...(Object.keys(label) as Alignment[]).map((alignment) => ({
        label: label[alignment],
        run: () => alignSelected(session, mirror, axis as 0 | 1 | 2, alignment),
      })),
    ]);
    this.#open(t('Align'), entries);
  }

  #openFor(event: MouseEvent): void {
    const { session, pick } = this.#options;
    const { state, store, actions } = session;
    const at = { x: event.clientX, y: event.clientY };
    this.#at = at;
    pick(event, (found) => {
      if (found === null) {
        this.#open(
          t('Add'),
          [
            actionEntry(actions, 'edit.paste'),
            actionEntry(actions, 'edit.selectAll'),
            actionEntry(actions, 'edit.showAll'),
            actionEntry(actions, 'view.frameAll'),
            'separator',
            ...addEntries(session),
          ],
          at,
        );
        return;
      }
      // What belongs to what is selected stands for all of it.
      if (!state.isSelected(found)) state.select(found);
      this.#open(store.document[found.kind][found.id]?.name ?? '', selectionEntries(session), at);
    });
  }

  #open(label: string, entries: readonly MenuEntry[], place = this.#at): void {
    const { element, canvas } = this.#options;
    const box = canvas.getBoundingClientRect();
    const { x, y } = place ?? { x: box.left + box.width / 2, y: box.top + box.height / 3 };
    const anchor = h('div', { class: 'menu-anchor' });
    anchor.style.left = `${x - box.left}px`;
    anchor.style.top = `${y - box.top}px`;
    element.append(anchor);
    openMenu(anchor, label, entries, () => anchor.remove());
  }
}
