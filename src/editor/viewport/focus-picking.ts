/** A click on the picture says what the lens is focused on. */
import { Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../scene/mirror.ts';
import { attempt } from '../commands.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { ignoreEnd } from '../threads/thread.ts';
import { toast } from '../ui/toast.ts';
import { type Picked, rayAt, whenPicked } from './selecting/picking.ts';

export interface FocusPickingOptions {
  readonly canvas: HTMLCanvasElement;
  readonly mirror: SceneMirror;
  readonly session: Session;
}

export class FocusPicking {
  readonly #options: FocusPickingOptions;
  #on = false;

  constructor(options: FocusPickingOptions) {
    this.#options = options;
    window.addEventListener(
      'keydown',
      (event) => {
        if (event.key !== 'Escape' || !this.#on) return;
        // What is selected stays so.
        event.stopPropagation();
        this.#set(false);
      },
      { capture: true },
    );
  }

  /** The next click says what is to be in focus. */
  get on(): boolean {
    return this.#on;
  }

  toggle(): void {
    this.#set(!this.#on);
  }

  #set(on: boolean): void {
    this.#on = on;
    this.#options.canvas.classList.toggle('picking-focus', on);
  }

  /** Focuses on what is at normalised device coordinates. */
  at(x: number, y: number): void {
    const { mirror, session } = this.#options;
    this.#set(false);
    const { store } = session;
    const state = () => [store.document.objects, store.document.camera];
    void whenPicked(mirror, rayAt(mirror, x, y), state, ([first]) => this.#focusOn(first)).catch(ignoreEnd);
  }

  #focusOn(found: Picked | undefined): void {
    const { mirror, session } = this.#options;
    if (!found) {
      toast('info', t('Nothing is there to focus on'), t('The distance that is in focus is as it was.'));
      return;
    }
    const { store } = session;
    const forward = mirror.camera.getWorldDirection(new Vector3());
    // Along the view.
    const distance = found.point.clone().sub(mirror.camera.position).dot(forward);
    const name = store.document.objects[found.id]?.name ?? t('the picture');
    attempt(t('The focus stays as it was'), () =>
      store.edit(t('Focus the lens on {name}', { name }), (draft) => {
        draft.camera.focusDistance = Number(distance.toPrecision(6));
      }),
    );
    if (store.document.camera.fStop === 0)
      toast('info', t('All is in focus'), t('The camera is a pinhole: its f-number is 0.'));
  }
}
