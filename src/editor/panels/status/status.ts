/** The strip under the viewport: what is rendered, by what, and how long frames take. */

import type { GpuTimesBoard } from '../../gpu-times.ts';
import { t } from '../../language/language.ts';
import type { EditorStateStore } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { createFrameGraph } from './frame-graph.ts';
import type { FrameStatistics, FrameTimes } from './frame-times.ts';
import { createGpuTimesPanel } from './gpu-times.ts';

export interface RenderFigures {
  width: number;
  height: number;
  vertices: number;
  triangles: number;
  drawCalls: number;
  backend: string;
  /** Part of the resolution that is drawn while things move, along each side; 1 is all. */
  factor: number;
}

export interface StatusPanel {
  readonly element: HTMLElement;
  show(figures: RenderFigures): void;
}

const REFRESH_MS = 250;

export function createStatus(
  state: EditorStateStore,
  times: FrameTimes,
  gpuTimes: GpuTimesBoard,
): StatusPanel {
  const figure = (label: string, tip: string) => {
    const value = h('dd', {}, '–');
    return { value, element: h('div', { class: 'figure', tip }, h('dt', {}, label), value) };
  };
  const resolution = figure(
    t('Resolution'),
    t('Pixels that are rendered; in percent: along each side, to hold the target frame time'),
  );
  const vertices = figure(t('Vertices'), t('Vertices of what is drawn'));
  const triangles = figure(t('Triangles'), t('Triangles that are drawn'));
  const calls = figure(t('Draw calls'), t('Draw calls of a frame'));
  const backend = figure('GPU', t('The interface that the browser gave'));
  const fps = figure('FPS', t('Frames shown in the last second; none are drawn while nothing changes'));
  const p50 = figure('p50', t('Half of the frames took at most this'));
  const p95 = figure('p95', t('95 % of the frames took at most this'));
  const p99 = figure('p99', t('99 % of the frames took at most this'));
  const spikes = figure(
    t('Spikes'),
    t('Frames that took half as long again as those before them, and at least 4 ms more'),
  );
  const graph = createFrameGraph(times);

  const continuous = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Render continuously'),
      tip: t('Render every frame, to measure; off: only when something changes'),
    },
    icon('loop'),
  );
  continuous.addEventListener('click', () => state.set({ continuous: !state.value.continuous }));
  const gpu = createGpuTimesPanel(state, gpuTimes);
  const fold = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': t('Frame time graph') },
    icon('chevronDown'),
  );
  fold.addEventListener('click', () => state.set({ statusOpen: !state.value.statusOpen }));

  const element = h(
    'footer',
    { class: 'status', 'aria-label': t('Status') },
    h(
      'div',
      { class: 'figures' },
      h(
        'dl',
        { class: 'figures-list' },
        ...[resolution, vertices, triangles, calls, backend].map((item) => item.element),
      ),
      h('dl', { class: 'figures-list fixed' }, fps.element),
      continuous,
      gpu.button,
      fold,
    ),
    h(
      'div',
      { class: 'timing' },
      h(
        'div',
        {
          class: 'timing-graph',
          tip: t(
            'Frame time in ms, newest at the right; spikes in red.\nBetween frames that follow one another: the time from one to the next. A single frame: until the GPU has finished it.',
          ),
        },
        graph.element,
      ),
      gpu.element,
      h('dl', { class: 'percentiles' }, ...[p50, p95, p99, spikes].map((item) => item.element)),
    ),
  );

  const apply = () => {
    const { continuous: on, statusOpen } = state.value;
    continuous.classList.toggle('on', on);
    continuous.setAttribute('aria-pressed', String(on));
    element.classList.toggle('folded', !statusOpen);
    fold.setAttribute('aria-expanded', String(statusOpen));
  };
  state.subscribe(apply);
  apply();

  let drawn = -1;
  window.setInterval(() => {
    const statistics = times.statistics(performance.now());
    put(fps.value, framesPerSecond(statistics, state.value.continuous));
    if (drawn === lastAt(times)) return;
    drawn = lastAt(times);
    showStatistics(statistics);
    if (state.value.statusOpen) graph.draw();
  }, REFRESH_MS);

  const showStatistics = (statistics: FrameStatistics) => {
    put(p50.value, milliseconds(statistics.p50));
    put(p95.value, milliseconds(statistics.p95));
    put(p99.value, milliseconds(statistics.p99));
    put(spikes.value, String(statistics.spikes));
    spikes.element.classList.toggle('bad', statistics.spikes > 0);
  };

  return {
    element,
    show(figures) {
      const part = figures.factor < 1 ? ` · ${Math.round(100 * figures.factor)} %` : '';
      put(resolution.value, `${figures.width} × ${figures.height}${part}`);
      put(vertices.value, grouped(figures.vertices));
      put(triangles.value, grouped(figures.triangles));
      put(calls.value, grouped(figures.drawCalls));
      put(backend.value, figures.backend);
    },
  };
}

function lastAt(times: FrameTimes): number {
  return times.samples.at(-1)?.at ?? -1;
}

function put(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

function framesPerSecond({ fps, p50 }: FrameStatistics, continuous: boolean): string {
  if (fps > 1) return String(fps);
  // Less than a frame or two a second cannot be counted in a second.
  if (continuous && p50 > 0) return (1000 / p50).toFixed(1);
  return fps === 1 ? '1' : t('idle');
}

function milliseconds(value: number): string {
  if (Number.isNaN(value)) return '–';
  if (value >= 1000) return `${(value / 1000).toFixed(2)} s`;
  return `${value < 100 ? value.toFixed(1) : Math.round(value)} ms`;
}

function grouped(value: number): string {
  return value.toLocaleString('en').replace(/,/g, '\u202f');
}
