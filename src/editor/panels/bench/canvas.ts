/** The plot on the page: redraws at the size it has, reads the pointer, drags theta_v. */
import { h } from '../../ui/dom.ts';
import { canvasPainter } from './canvas-painter.ts';
import { drawPlot, probeAt } from './draw.ts';
import type { Plot, Probe } from './frame.ts';
import type { BenchView } from './settings.ts';

export interface PlotCanvas {
  readonly element: HTMLCanvasElement;
  readonly probe: Probe | null;
  size(): { width: number; height: number };
  draw(plot: Plot): void;
}

const MOST = 89;
const draggable = (view: BenchView) => view === 'polar' || view === 'thetaL';

export function createPlotCanvas(wantFrame: () => void, setThetaV: (degrees: number) => void): PlotCanvas {
  const element = h('canvas', {
    id: 'bench-plot',
    class: 'bench-plot',
    tabindex: 0,
    role: 'img',
    'aria-label': 'Plot of the BRDF. Left and right arrow keys turn the viewer.',
  });
  let shown: Plot | null = null;
  let probe: Probe | null = null;
  let dragging = false;

  const follow = (event: PointerEvent) => {
    if (!shown) return;
    probe = probeAt(shown, element.clientWidth, element.clientHeight, [event.offsetX, event.offsetY]);
    element.classList.toggle('turns', probe !== null && draggable(shown.settings.view));
    if (dragging && probe) setThetaV(Math.min(MOST, Math.round(10 * Math.abs(probe.angle)) / 10));
    wantFrame();
  };
  element.addEventListener('pointermove', follow);
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || !shown || !draggable(shown.settings.view)) return;
    element.setPointerCapture(event.pointerId);
    dragging = true;
    follow(event);
  });
  element.addEventListener('lostpointercapture', () => {
    dragging = false;
  });
  element.addEventListener('pointerleave', () => {
    probe = null;
    wantFrame();
  });
  element.addEventListener('keydown', (event) => {
    const direction = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!direction || !shown || !draggable(shown.settings.view)) return;
    event.preventDefault();
    const step = event.shiftKey ? 10 : 1;
    setThetaV(Math.max(0, Math.min(MOST, shown.settings.thetaV + direction * step)));
  });
  new ResizeObserver(wantFrame).observe(element);

  const size = () => ({ width: element.clientWidth, height: element.clientHeight });
  return {
    element,
    get probe() {
      return probe;
    },
    size,
    draw(plot) {
      shown = plot;
      const { width, height } = size();
      if (width > 0 && height > 0) drawPlot(canvasPainter(element, width, height, devicePixelRatio), plot);
    },
  };
}
