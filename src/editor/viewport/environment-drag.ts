/**
 * Alt and a drag sideways turn the light from all around, sun and background with it, whichever renderer draws. A click with
 * Alt that does not move is somebody else's: it selects what is behind.
 */
import { attempt } from '../commands.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { newGesture } from '../ui/gesture.ts';

export interface EnvironmentDragOptions {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly session: Session;
  /** Somebody else has a use for the drag. */
  isTaken(event: PointerEvent): boolean;
  /** While the environment is dragged, the camera is not. */
  holdCamera(held: boolean): void;
}

const DEGREES_PER_PIXEL = 0.4;
/** What moves less is a click. */
const CLICK_PX = 4;

const wrap = (degrees: number): number => ((((degrees + 180) % 360) + 360) % 360) - 180;

export function installEnvironmentDrag({
  element,
  canvas,
  session,
  isTaken,
  holdCamera,
}: EnvironmentDragOptions): void {
  const { store } = session;
  const readout = h('output', { class: 'environment-readout', hidden: true });
  element.append(readout);

  const begin = (start: PointerEvent) => {
    const { source, rotation } = store.document.environment;
    const { benchOpen, bench } = session.state.value;
    // Then it is a lamp that this turns (panels/bench/light-drag.ts).
    const isLamp = benchOpen && bench.lightInStep;
    if (!start.altKey || start.button !== 0 || start.target !== canvas || isLamp || source.type === 'none')
      return;
    if (isTaken(start)) return;
    const gesture = newGesture();
    let isDrag = false;
    holdCamera(true);
    const move = (event: PointerEvent) => {
      const across = event.clientX - start.clientX;
      isDrag ||= Math.abs(across) > CLICK_PX;
      if (!isDrag) return;
      // What is in front goes with the pointer.
      const next = Math.round(wrap(rotation - across * DEGREES_PER_PIXEL) * 10) / 10;
      turn(next, gesture);
      readout.hidden = false;
      readout.textContent = t('Environment {degrees}°', { degrees: next.toFixed(1) });
    };
    const end = (event: PointerEvent) => {
      if (event.pointerId !== start.pointerId) return;
      window.removeEventListener('pointermove', move);
      window.removeEventListener('pointerup', end);
      window.removeEventListener('pointercancel', end);
      window.removeEventListener('keydown', cancel, true);
      holdCamera(false);
      readout.hidden = true;
      store.endMerge();
    };
    const cancel = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || !isDrag) return;
      event.stopPropagation();
      turn(rotation, gesture);
      end(start);
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', end);
    window.addEventListener('pointercancel', end);
    window.addEventListener('keydown', cancel, true);
  };
  const turn = (rotation: number, gesture: string) =>
    attempt(t('The environment stays as it is'), () =>
      store.edit(
        t('Turn the environment'),
        (draft) => {
          draft.environment.rotation = rotation;
        },
        { merge: `environment rotation ${gesture}` },
      ),
    );
  // Before the camera hears of it.
  element.addEventListener('pointerdown', begin, { capture: true });
}
