/** The path traced picture at any size, by a director of its own: the viewport's goes on as it was. */
import type { Document } from '../../../scene/schema.ts';
import { t } from '../../language/language.ts';
import { changeOf } from '../../path-tracing/document-change.ts';
import type { FromDirector, ToDirector, TracedPicture } from '../../path-tracing/messages.ts';
import { originOf } from '../../path-tracing/origin.ts';

export interface TracedOptions {
  readonly document: Document;
  readonly width: number;
  readonly height: number;
  /** Per pixel. */
  readonly samples: number;
  readonly exposure: number;
  readonly signal: AbortSignal;
  onProgress(text: string, fraction: number): void;
}

export interface Traced {
  readonly picture: TracedPicture;
  /** The film as an EXR file. */
  readonly exr: Uint8Array<ArrayBuffer>;
}

/** A pixel of a film and of what is sent takes about so many bytes; a browser gives a thread some two gigabytes. */
export const MOST_TRACED_PIXELS = 4096 * 4096;

export async function renderTraced(options: TracedOptions): Promise<Traced> {
  const { document, width, height, samples, signal, onProgress } = options;
  const worker = new Worker(new URL('../../path-tracing/director-worker.ts', import.meta.url), {
    type: 'module',
  });
  const send = (message: ToDirector) => worker.postMessage(message);
  try {
    const origin = await originOf(document, options.exposure);
    signal.throwIfAborted();
    return await new Promise<Traced>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.addEventListener('error', (event) =>
        reject(new Error(event.message || t('the path tracer did not start'))),
      );
      let picture: TracedPicture | null = null;
      worker.addEventListener('message', ({ data }: MessageEvent<FromDirector>) => {
        if (data.kind === 'failed') reject(new Error(data.message));
        else if (data.kind === 'phase')
          onProgress(PHASES[data.phase], data.phase === 'tracing' ? 0 : data.part);
        else if (data.kind === 'picture') {
          onProgress(PHASES.tracing, data.figures.samples / samples);
          picture = data.picture;
          if (data.figures.reached !== null) send({ kind: 'exr', origin, denoised: false });
        } else if (data.kind === 'exr' && picture !== null) {
          if (data.file === null) reject(new Error(t('the path tracer gave no picture')));
          else resolve({ picture, exr: data.file });
        }
      });
      const { maxDepth, seed, clamp } = document.pathTracing;
      send({ kind: 'goal', goal: { samples, error: 0 } });
      send({
        kind: 'render',
        ticket: 1,
        change: changeOf(null, document),
        camera: document.camera,
        settings: { width, height, maxDepth, seed, clamp, strategy: 'mis' },
      });
    });
  } finally {
    worker.terminate();
  }
}

const PHASES = {
  packing: t('Preparing the scene'),
  compiling: t('Compiling the path tracer'),
  tracing: t('Tracing paths'),
} as const;
