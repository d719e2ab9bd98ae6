/** What a click on the picture does. */
import type { SceneMirror } from '../../scene/mirror.ts';
import type { Session } from '../session.ts';
import type { FocusPicking } from './focus-picking.ts';
import type { Overlay } from './overlay.ts';
import { pickObject } from './picking.ts';

/** A pointer that moves further than this while it is down drags. */
const CLICK_PX = 4;

export interface PointerOptions {
  readonly canvas: HTMLCanvasElement;
  readonly mirror: SceneMirror;
  readonly session: Session;
}

export function installPointer(
  { canvas, mirror, session }: PointerOptions,
  overlay: Overlay,
  focusPicking: FocusPicking,
  onDoubleClick: () => void,
): void {
  let down: { x: number; y: number } | null = null;
  canvas.addEventListener('pointerdown', (event) => {
    down = event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
    // Typing ends where the picture is touched.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  });
  canvas.addEventListener('pointerup', (event) => {
    if (!down || Math.hypot(event.clientX - down.x, event.clientY - down.y) > CLICK_PX) return;
    const box = canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    const [u, v] = [(x / box.width) * 2 - 1, 1 - (y / box.height) * 2];
    if (focusPicking.on) {
      focusPicking.at(u, v);
      return;
    }
    const light = overlay.lightAt(x, y);
    const object = light ? null : pickObject(mirror, u, v);
    if (light) session.state.select({ kind: 'lights', id: light });
    else session.state.select(object ? { kind: 'objects', id: object } : null);
  });
  canvas.addEventListener('dblclick', onDoubleClick);
}
