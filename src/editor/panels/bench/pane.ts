/** One view on the page: draws when something changed, reads the pointer, lets its handles be dragged. */

import { t } from '../../language/language.ts';
import { computedColor } from '../../theme/theme.ts';
import { h } from '../../ui/dom.ts';
import { canvasPainter } from './canvas-painter.ts';
import { colors, type Handle, type Plot, type Probe } from './frame.ts';
import type { Painter, Point } from './painter.ts';
import type { PaneSettings } from './settings.ts';
import { themed } from './themed-painter.ts';
import { viewInfo } from './views.ts';

export interface PlotPane {
  readonly element: HTMLCanvasElement;
  readonly probe: Probe | null;
  size(): { width: number; height: number };
  draw(plot: Plot): void;
}

export interface PaneActions {
  wantFrame(): void;
  change(patch: Partial<PaneSettings>): void;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function drawPlot(painter: Painter, plot: Plot): void {
  painter.fill({ x: 0, y: 0, width: painter.width, height: painter.height }, colors.background);
  viewInfo[plot.settings.view].view?.draw(painter, plot);
}

export function createPane({ wantFrame, change }: PaneActions): PlotPane {
  const element = h('canvas', { class: 'bench-plot', tabindex: 0, role: 'img' });
  let shown: Plot | null = null;
  let drawn: readonly unknown[] = [];
  let probe: Probe | null = null;
  let held: { handle: Handle; from: Point } | null = null;

  /** What is drawn next builds on it: several keys or moves can come before the next frame. */
  const apply = (patch: Partial<PaneSettings>) => {
    if (shown) shown = { ...shown, settings: { ...shown.settings, ...patch } };
    change(patch);
  };
  const size = () => ({ width: element.clientWidth, height: element.clientHeight });
  const view = () => shown && viewInfo[shown.settings.view].view;
  const pointOf = (event: PointerEvent): Point => [event.offsetX, event.offsetY];
  const gripAt = (at: Point): Handle | null => {
    const { width, height } = size();
    return (shown && view()?.grip?.(shown, width, height, at)) ?? null;
  };

  const follow = (event: PointerEvent) => {
    if (!shown) return;
    const at = pointOf(event);
    const { width, height } = size();
    probe = held?.handle === 'turn' ? null : (view()?.probe(shown, width, height, at) ?? null);
    element.dataset.grip = held?.handle ?? gripAt(at) ?? '';
    if (held) {
      const to: Point = held.handle === 'turn' ? [at[0] - held.from[0], at[1] - held.from[1]] : at;
      held = { ...held, from: at };
      apply(view()?.drag?.(shown, width, height, to, held.handle) ?? {});
    }
    wantFrame();
  };
  element.addEventListener('pointermove', follow);
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const from = pointOf(event);
    const handle = gripAt(from);
    if (!handle) return;
    element.setPointerCapture(event.pointerId);
    held = { handle, from };
    follow(event);
  });
  element.addEventListener('lostpointercapture', () => {
    held = null;
  });
  element.addEventListener('pointerleave', () => {
    probe = null;
    wantFrame();
  });
  element.addEventListener('keydown', (event) => {
    const arrow = ARROWS[event.key];
    const keys = view()?.keys;
    if (!arrow || !shown || !keys || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const step = event.shiftKey ? 10 : 1;
    apply(keys(shown.settings, arrow[0] * step, arrow[1] * step));
  });
  new ResizeObserver(wantFrame).observe(element);

  return {
    element,
    get probe() {
      return probe;
    },
    size,
    draw(plot) {
      shown = plot;
      const { width, height } = size();
      const now = [
        width,
        height,
        devicePixelRatio,
        computedColor(colors.background),
        plot.probe?.x,
        plot.probe?.y,
        ...partsOf(plot),
      ];
      if (now.length === drawn.length && now.every((part, i) => part === drawn[i])) return;
      drawn = now;
      element.setAttribute('aria-label', labelOf(plot));
      if (width > 0 && height > 0)
        drawPlot(themed(canvasPainter(element, width, height, devicePixelRatio)), plot);
    },
  };
}

/** Everything that a drawing is made of; each part is another object when it is another. */
function partsOf({ settings, curves, parameter }: Plot): unknown[] {
  return [
    JSON.stringify([{ ...settings, pins: null }, parameter]),
    ...curves.flatMap(({ id, name, color, points, sweep, lobe, picture }) => [
      id,
      name,
      color,
      points,
      sweep,
      lobe,
      picture,
    ]),
  ];
}

function labelOf({ settings }: Plot): string {
  const { label, view } = viewInfo[settings.view];
  return view?.keys
    ? t('Plot of the BRDF: {label}. Arrow keys turn it.', { label })
    : t('Plot of the BRDF: {label}.', { label });
}
