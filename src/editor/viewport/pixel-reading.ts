/** Says what the pixel under the pointer holds, where data are shown. */
import type { RealtimeRenderer } from '../../realtime/renderer.ts';
import type { Session } from '../session.ts';
import type { ShowView } from './show.ts';

export interface PixelReadingOptions {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: RealtimeRenderer;
  readonly session: Session;
}

export function installPixelReading(options: PixelReadingOptions, show: ShowView): void {
  const { canvas, renderer, session } = options;
  let reading = false;
  /** Where the pointer is now: while a pixel is read it goes on, and rests where nobody has read yet. */
  let at: PointerEvent | null = null;
  const read = async (): Promise<void> => {
    if (reading) return;
    reading = true;
    try {
      while (at !== null) {
        const { clientX, clientY, buttons } = at;
        at = null;
        if (buttons !== 0 || session.state.value.rendering !== 'interactive') continue;
        if (session.store.document.view.show === 'picture') continue;
        const box = canvas.getBoundingClientRect();
        show.read(
          await renderer.readPixel((clientX - box.left) / box.width, (clientY - box.top) / box.height),
        );
      }
    } finally {
      reading = false;
    }
  };
  canvas.addEventListener('pointermove', (event) => {
    at = event;
    void read();
  });
  canvas.addEventListener('pointerleave', () => show.read(null));
}
