/**
 * The BRDF bench: a dock under the viewport that plots the selected material's model as it is changed, and
 * copies of earlier states beside it. It reads the document and never changes it.
 */
import type { Rgb } from '../../../analysis/plots/curve.ts';
import { imageSliceAt } from '../../../analysis/plots/image-slice.ts';
import { download, fileNameOf } from '../../io/files.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { menuButton } from '../../ui/menu.ts';
import { toastError } from '../../ui/toast.ts';
import { Background } from './background.ts';
import { createPlotCanvas } from './canvas.ts';
import { createControls } from './controls.ts';
import { exportCsv, exportPng, exportSvg } from './export.ts';
import type { Plot, Probe } from './frame.ts';
import { createLegend } from './legend.ts';
import { plotData } from './plot-data.ts';
import { clampHeight, createSash } from './sash.ts';
import { Evaluators, subjectsOf, termsOf } from './series.ts';
import { type BenchSettings, CURRENT, freeColor } from './settings.ts';
import { createTabs } from './tabs.ts';

export function createBench({ store, state }: Session): HTMLElement {
  const evaluators = new Evaluators();
  const background = new Background(() => wantFrame());
  const change = (patch: Partial<BenchSettings>) => state.set({ bench: { ...state.value.bench, ...patch } });
  const subjects = () => subjectsOf(store.document, state.value.selection, state.value.bench.pins);

  const tabs = createTabs((view) => change({ view }));
  const controls = createControls(change);
  const canvas = createPlotCanvas(
    () => wantFrame(),
    (thetaV) => change({ thetaV }),
  );
  const legend = createLegend({
    pin: () => {
      const [current] = subjects();
      if (current?.id !== CURRENT) return;
      const { pins } = state.value.bench;
      const { name, model, source, parameters } = current;
      const pin = { id: crypto.randomUUID(), name: `${name} ${pins.length + 1}`, model, source, parameters };
      change({ pins: [...pins, { ...pin, color: freeColor(pins) }] });
    },
    solo: (id) => change({ solo: state.value.bench.solo === id ? null : id }),
    remove: (id) => {
      const { pins, solo } = state.value.bench;
      change({ pins: pins.filter((pin) => pin.id !== id), solo: solo === id ? null : solo });
    },
  });
  const progress = h('progress', {
    class: 'bench-progress',
    max: 1,
    'aria-label': 'Computing the plot',
    hidden: true,
  });
  const close = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': 'Close the bench', tip: 'Close (B)' },
    icon('close'),
  );
  close.addEventListener('click', () => state.set({ benchOpen: false }));

  /** What is on the screen, at the parameters of this moment. */
  const present = (probe: Probe | null): { plot: Plot; progress: number } => {
    const all = subjects();
    const terms = all[0] ? termsOf(all[0]) : [];
    const { bench } = state.value;
    // Another model may not have the term; its whole is then shown, and the term again when it is back.
    const settings = terms.includes(bench.term) ? bench : { ...bench, term: 'BRDF' };
    const data = plotData(all, settings, evaluators, background);
    return { plot: { settings, curves: data.curves, probe }, progress: data.progress };
  };

  /** A file of a curve that is not complete would be taken for the whole. */
  const computing = () => present(null).progress < 1;

  const save = async (extension: 'svg' | 'png' | 'csv') => {
    const { plot } = present(null);
    const { width, height } = canvas.size();
    const name = `${fileNameOf(subjects()[0]?.name ?? 'brdf')}-${plot.settings.view}.${extension}`;
    try {
      if (extension === 'svg') download(name, exportSvg(plot, width, height));
      else if (extension === 'png') download(name, await exportPng(plot, width, height));
      else download(name, exportCsv(plot));
    } catch (error) {
      toastError('The plot was not saved', error);
    }
  };

  const element: HTMLElement = h(
    'section',
    { class: 'bench', 'aria-label': 'BRDF bench' },
    createSash(
      () => element.offsetHeight,
      (benchHeight) => state.set({ benchHeight }),
    ),
    h(
      'div',
      { class: 'bench-bar' },
      tabs.element,
      progress,
      h('span', { class: 'spacer' }),
      menuButton('Export', () => [
        { label: 'SVG', icon: 'image', disabled: computing(), run: () => void save('svg') },
        { label: 'PNG', icon: 'image', disabled: computing(), run: () => void save('png') },
        {
          label: 'CSV',
          icon: 'file',
          tip: 'The numbers, in full precision',
          disabled: computing(),
          run: () => void save('csv'),
        },
      ]),
      close,
    ),
    h('div', { class: 'bench-view' }, canvas.element),
    h('div', { class: 'bench-side' }, legend.element, controls.element),
  );

  const draw = () => {
    const all = subjects();
    const now = present(canvas.probe);
    const { settings } = now.plot;
    tabs.show(settings.view);
    controls.show(settings, all[0] ? termsOf(all[0]) : []);
    legend.show(all, settings);
    canvas.draw(now.plot);
    const { where, values } = readings(now.plot);
    legend.showValues(where, values, settings.channel);
    progress.value = now.progress;
    progress.hidden = now.progress >= 1;
  };

  let wanted = false;
  const wantFrame = () => {
    if (wanted || !state.value.benchOpen) return;
    wanted = true;
    requestAnimationFrame(() => {
      wanted = false;
      if (state.value.benchOpen) draw();
    });
  };
  const layout = () => {
    element.hidden = !state.value.benchOpen;
    element.style.height = `${clampHeight(state.value.benchHeight)}px`;
    wantFrame();
  };
  store.subscribe(wantFrame);
  state.subscribe(layout);
  window.addEventListener('resize', layout);
  layout();
  return element;
}

const SYMBOLS = { polar: 'θl', thetaL: 'θl', thetaH: 'θh', thetaD: 'θd', albedo: 'θv', image: 'θh' } as const;

/** The values under the pointer, and where it is. */
function readings({ settings, curves, probe }: Plot): { where: string; values: Map<string, Rgb> } {
  const values = new Map<string, Rgb>();
  if (!probe) return { where: '', values };
  const { angle, y } = probe;
  for (const { id, f, at } of curves) {
    const rgb =
      y === undefined
        ? at(angle)?.rgb
        : imageSliceAt(f, Math.sqrt(angle / 90), y, { phiD: 90, cosine: settings.cosine });
    if (rgb) values.set(id, rgb);
  }
  const degrees = (value: number) => `${value.toFixed(1).replace('-', '−')}°`;
  const second = y === undefined ? '' : `   θd ${degrees(90 * y)}`;
  return { where: `${SYMBOLS[settings.view]} ${degrees(angle)}${second}`, values };
}
