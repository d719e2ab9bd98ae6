/** Frame time over time: a bar per frame, newest at the right, spikes in a colour of their own. */

import { t } from '../../language/language.ts';
import { computedColor, onThemeChange } from '../../theme/theme.ts';
import type { FrameTimes } from './frame-times.ts';

const BAR_PX = 3;
const LABEL_PX = 42;
/** Round tops of the axis; a scale that jumps with every frame cannot be read. */
const SCALES = [10, 20, 33.3, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 60_000];

export interface FrameGraph {
  readonly element: HTMLCanvasElement;
  draw(): void;
}

export function createFrameGraph(times: FrameTimes): FrameGraph {
  const element = document.createElement('canvas');
  element.className = 'frame-graph';
  element.setAttribute('role', 'img');
  element.setAttribute('aria-label', t('Frame time over time'));
  const context = element.getContext('2d');

  const draw = () => {
    const { clientWidth: width, clientHeight: height } = element;
    if (!context || width === 0 || height === 0) return;
    const ratio = devicePixelRatio;
    element.width = Math.round(width * ratio);
    element.height = Math.round(height * ratio);
    context.scale(ratio, ratio);

    const plot = width - LABEL_PX;
    const shown = times.samples.slice(-Math.floor(plot / BAR_PX));
    const worst = Math.max(0, ...shown.map((sample) => sample.ms));
    const top = SCALES.find((scale) => scale >= worst * 1.05) ?? worst;
    const y = (ms: number) => height - 1 - (ms / top) * (height - 4);

    drawAxis(context, plot, top, y);
    shown.forEach((sample, i) => {
      const x = plot - (shown.length - i) * BAR_PX;
      context.fillStyle = computedColor(sample.spike ? 'var(--error)' : 'var(--plot-bar)');
      const level = y(sample.ms);
      context.fillRect(x, level, BAR_PX - 1, height - 1 - level);
    });
  };
  new ResizeObserver(draw).observe(element);
  onThemeChange(draw);
  return { element, draw };
}

function drawAxis(
  context: CanvasRenderingContext2D,
  plot: number,
  top: number,
  y: (ms: number) => number,
): void {
  context.font = '10px system-ui, sans-serif';
  context.textBaseline = 'middle';
  for (const ms of [top, top / 2]) {
    const level = Math.round(y(ms)) + 0.5;
    context.fillStyle = computedColor('var(--line)');
    context.fillRect(0, level - 0.5, plot, 1);
    context.fillStyle = computedColor('var(--text-faint)');
    const label = ms >= 1000 ? `${ms / 1000} s` : `${Number(ms.toFixed(1))}`;
    context.fillText(ms === top && ms < 1000 ? `${label} ms` : label, plot + 4, Math.max(6, level));
  }
}
