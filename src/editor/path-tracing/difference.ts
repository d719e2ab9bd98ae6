/** The map of how different a person would find the two renderings, with its key and mean, over the viewport. */

import { magma } from '../../analysis/flip/magma.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { toastError } from '../ui/toast.ts';
import type { FlipPicture } from './flip-worker.ts';
import type { PathTracing } from './path-tracing.ts';

/** Both renderings as a screen shows them: RGBA bytes in sRGB, row 0 at the top. */
export interface ImagePair {
  readonly width: number;
  readonly height: number;
  readonly interactive: Uint8Array;
  readonly traced: Uint8Array;
}

/** So many times the samples of the last map are worth another one: the noise has fallen by a fifth. */
const WORTHWHILE = 1.5;

export interface DifferenceView {
  readonly element: HTMLElement;
  /** Null while no map is shown. */
  readonly canvas: HTMLCanvasElement | null;
  /** Over the map, for the outlines of what is selected. */
  readonly lines: HTMLCanvasElement;
}

export function createDifference(
  { store, state }: Session,
  tracing: PathTracing,
  readPair: () => Promise<ImagePair | null>,
  onMap: () => void,
): DifferenceView {
  const canvas = h('canvas', {
    class: 'difference-map',
    'aria-label': t('Map of the difference'),
    role: 'img',
  });
  const lines = h('canvas', { class: 'difference-lines', 'aria-hidden': 'true' });
  const mean = h('output', { class: 'difference-mean' });
  const element = h(
    'div',
    { class: 'difference', hidden: true },
    canvas,
    lines,
    h(
      'div',
      { class: 'difference-key', tip: KEY_TIP },
      h('div', { class: 'difference-line' }, h('span', {}, t('FLIP: visible difference')), mean),
      colorBar(),
      h('div', { class: 'difference-line' }, h('span', {}, t('0 none')), h('span', {}, t('1 largest'))),
    ),
  );
  const compare = comparer();
  let busy = false;
  /** What the map shows. */
  let shown: { samples: number; denoised: number | null; view: unknown } | null = null;

  const isNews = () => {
    if (tracing.state.kind !== 'picture' || state.value.rendering !== 'difference') return false;
    const { samples, reached } = tracing.state.figures;
    if (shown === null || shown.view !== store.document.view) return true;
    if (tracing.denoised !== shown.denoised) return true;
    if (samples === shown.samples) return false;
    return samples >= WORTHWHILE * shown.samples || reached !== null || state.value.tracingPaused;
  };

  const show = async () => {
    const { rendering } = state.value;
    element.hidden = rendering !== 'difference';
    if (tracing.state.kind !== 'picture') shown = null;
    canvas.hidden = shown === null;
    lines.hidden = canvas.hidden;
    if (shown === null) mean.textContent = t('not yet');
    if (busy || !isNews() || tracing.state.kind !== 'picture') return;
    busy = true;
    const { texture } = tracing;
    const next = {
      samples: tracing.state.figures.samples,
      denoised: tracing.denoised,
      view: store.document.view,
    };
    try {
      const pair = await readPair();
      const picture = pair && (await compare(pair));
      // What is looked at may be another picture by now.
      if (picture && texture === tracing.texture) {
        draw(canvas, picture);
        mean.textContent = t('mean {value}', { value: picture.mean.toFixed(4) });
        shown = next;
        canvas.hidden = false;
        lines.hidden = false;
        onMap();
      }
    } catch (error) {
      shown = next;
      toastError(t('The pictures could not be compared'), error);
    } finally {
      busy = false;
    }
    if (isNews()) void show();
  };
  tracing.subscribe(() => void show());
  state.subscribe(() => void show());
  store.subscribe(() => void show());
  void show();
  return {
    element,
    lines,
    get canvas() {
      return element.hidden || canvas.hidden ? null : canvas;
    },
  };
}

const KEY_TIP = t(
  'How different a person would find the two when flipping between them (FLIP, Andersson et al. 2020), on a screen with 67 pixels per degree. The mean is over all pixels.',
);

/** One comparison at a time; the thread is there from the first one on. */
function comparer(): (pair: ImagePair) => Promise<FlipPicture> {
  let worker: Worker | null = null;
  return ({ width, height, interactive, traced }) => {
    worker ??= new Worker(new URL('./flip-worker.ts', import.meta.url), { type: 'module' });
    const thread = worker;
    return new Promise((resolve, reject) => {
      thread.onmessage = ({ data }: MessageEvent<FlipPicture>) => resolve(data);
      thread.onerror = ({ message }) => {
        worker = null;
        reject(new Error(message || t('the worker could not be loaded')));
      };
      const reference = { width, height, pixels: traced };
      const test = { width, height, pixels: interactive };
      thread.postMessage({ reference, test });
    });
  };
}

function draw(canvas: HTMLCanvasElement, { width, height, pixels }: FlipPicture): void {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  canvas.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
}

function colorBar(): HTMLCanvasElement {
  const bar = h('canvas', { class: 'difference-bar', width: 256, height: 1, 'aria-hidden': 'true' });
  const context = bar.getContext('2d');
  for (let x = 0; context && x < 256; x++) {
    context.fillStyle = `rgb(${magma(x / 255).join(' ')})`;
    context.fillRect(x, 0, 1, 1);
  }
  return bar;
}
