/** A picture of the view as a file, of any size, by either renderer. */
import type { RealtimeRenderer, Size } from '../../../realtime/renderer.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import type { FromPicture, PictureFormat, ToPicture } from './picture-messages.ts';
import { readLinear, readScreen, renderTiles } from './tiles.ts';
import { renderTraced } from './traced.ts';

export interface PictureRequest extends Size {
  readonly source: 'interactive' | 'traced';
  readonly format: PictureFormat;
  /** Of the path tracer, per pixel. */
  readonly samples: number;
}

export interface PictureContext {
  readonly renderer: RealtimeRenderer;
  readonly mirror: SceneMirror;
  /** With the camera where it is seen from. */
  readonly document: Document;
  /** The viewport has to be drawn again: its canvas was used for something else. */
  redraw(): void;
  /** Resolves when everything in the scene can be drawn. */
  whole(): Promise<void>;
}

export async function makePicture(
  { renderer, mirror, document, redraw, whole }: PictureContext,
  { source, format, width, height, samples }: PictureRequest,
  signal: AbortSignal,
  onProgress: (text: string, fraction: number) => void,
): Promise<Blob> {
  const exposure = renderer.exposure(document.view);
  const head = { width, height, format, transparent: document.background.type === 'transparent' };
  if (source === 'traced') {
    const traced = await renderTraced({ document, width, height, samples, exposure, signal, onProgress });
    if (format === 'exr') return new Blob([traced.exr], { type: 'image/x-exr' });
    return assembled(signal, head, async (send) => {
      const { pixels } = traced.picture;
      send({ kind: 'radiance', pixels, display: { exposure, toneMapping: document.view.toneMapping } }, [
        pixels.buffer,
      ]);
    });
  }
  await whole();
  const still = showStill(renderer, document);
  try {
    return await assembled(signal, head, (send) =>
      renderTiles({
        renderer,
        mirror,
        document,
        size: { width, height },
        read: format === 'exr' ? readLinear : readScreen,
        signal,
        onTile(tile, pixels, done) {
          onProgress(t('Drawing'), done);
          send({ kind: 'tile', tile, pixels }, [pixels.buffer]);
        },
      }),
    );
  } finally {
    redraw();
    still.remove();
  }
}

/** What the viewport shows, before its canvas: tiles are drawn on that. */
function showStill(renderer: RealtimeRenderer, document: Document): HTMLCanvasElement {
  const { canvas } = renderer;
  const still = h('canvas', { class: 'still', width: canvas.width, height: canvas.height });
  // A canvas of the GPU may be read only in the task that drew it.
  renderer.renderAgain(document);
  still.getContext('2d')?.drawImage(canvas, 0, 0);
  canvas.after(still);
  return still;
}

type Send = (message: ToPicture, transfer?: Transferable[]) => void;

async function assembled(
  signal: AbortSignal,
  head: Omit<Extract<ToPicture, { kind: 'begin' }>, 'kind'>,
  fill: (send: Send) => Promise<void>,
): Promise<Blob> {
  const worker = new Worker(new URL('./picture-worker.ts', import.meta.url), { type: 'module' });
  const send: Send = (message, transfer = []) => worker.postMessage(message, transfer);
  try {
    const file = new Promise<Blob>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.addEventListener('error', (event) =>
        reject(new Error(event.message || t('the picture does not fit into memory'))),
      );
      worker.addEventListener('message', ({ data }: MessageEvent<FromPicture>) => {
        if (data.kind === 'file') resolve(data.file);
        else reject(new Error(data.message));
      });
    });
    // Awaited below, after what may fail before it.
    file.catch(() => {});
    send({ kind: 'begin', ...head });
    await fill(send);
    send({ kind: 'finish' });
    return await file;
  } finally {
    worker.terminate();
  }
}
