/** Alt and a drag over the viewport turn the light while the bench keeps it in step with a light of the scene. */
import type { Session } from '../../session.ts';
import { tenths, wrapped } from './frame.ts';
import { STEEPEST } from './settings.ts';

/** Across a viewport of usual size from the zenith to the horizon and half around. */
const DEGREES_PER_PIXEL = 0.3;

export function installLightDrag(canvas: HTMLElement, { state }: Session): void {
  const isOn = () => state.value.benchOpen && state.value.bench.lightInStep;
  let held: { readonly pointer: number; x: number; y: number } | null = null;
  canvas.addEventListener(
    'pointerdown',
    (event) => {
      if (!isOn() || !event.altKey || event.button !== 0 || held) return;
      // Neither the camera turns nor is anything selected.
      event.stopImmediatePropagation();
      held = { pointer: event.pointerId, x: event.clientX, y: event.clientY };
      canvas.setPointerCapture(event.pointerId);
    },
    { capture: true },
  );
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerId !== held?.pointer || !isOn()) return;
    const { bench } = state.value;
    const across = event.clientX - held.x;
    const thetaL = bench.thetaL + DEGREES_PER_PIXEL * (event.clientY - held.y);
    held = { ...held, x: event.clientX, y: event.clientY };
    state.set({
      bench: {
        ...bench,
        // Upwards is towards the zenith; to the right goes against the clock, seen from above.
        thetaL: tenths(Math.min(STEEPEST, Math.max(0, thetaL))),
        phiL: wrapped(tenths(bench.phiL + DEGREES_PER_PIXEL * across)),
      },
    });
  });
  const end = (event: PointerEvent) => {
    if (event.pointerId !== held?.pointer) return;
    event.stopImmediatePropagation();
    held = null;
  };
  canvas.addEventListener('pointerup', end, { capture: true });
  canvas.addEventListener('pointercancel', end, { capture: true });
}
