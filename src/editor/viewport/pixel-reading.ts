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
  const read = async ({ clientX, clientY, buttons }: PointerEvent): Promise<void> => {
    if (reading || buttons !== 0 || session.state.value.rendering !== 'interactive') return;
    if (session.store.document.view.show === 'picture') return;
    const box = canvas.getBoundingClientRect();
    reading = true;
    try {
      show.read(await renderer.readPixel((clientX - box.left) / box.width, (clientY - box.top) / box.height));
    } finally {
      reading = false;
    }
  };
  canvas.addEventListener('pointermove', (event) => void read(event));
  canvas.addEventListener('pointerleave', () => show.read(null));
}
