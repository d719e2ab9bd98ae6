/**
 * The BRDF bench: a dock under the viewport, or the whole page, that plots the selected material's model as it is
 * changed, and copies of earlier states beside it. Only l, kept in step with a light, changes the document.
 */
import type { BufferGeometry } from 'three/webgpu';
import type { Rgb } from '../../../analysis/plots/curve.ts';
import type { WorstCase } from '../../../analysis/verdict/types.ts';
import type { RealtimeRenderer } from '../../../realtime/renderer.ts';
import { attempt, toggleBenchPage } from '../../commands.ts';
import { download, fileNameOf } from '../../io/files.ts';
import { t } from '../../language/language.ts';
import { selectedMaterial } from '../../selected-material.ts';
import type { Session } from '../../session.ts';
import { onThemeChange } from '../../theme/theme.ts';
import { h } from '../../ui/dom.ts';
import { newGesture } from '../../ui/gesture.ts';
import { icon } from '../../ui/icons.ts';
import { menuButton } from '../../ui/menu.ts';
import { toastError } from '../../ui/toast.ts';
import { Background } from './background.ts';
import { createControls } from './controls.ts';
import { exportCsv, exportPng, exportSvg } from './export.ts';
import type { Plot, Probe } from './frame.ts';
import { createGrid } from './grid.ts';
import { createLegend } from './legend.ts';
import { installLightDrag } from './light-drag.ts';
import { litObject, meshOf } from './object-mesh.ts';
import { plotData } from './plot-data.ts';
import { clampHeight, createSash } from './sash.ts';
import { placeSceneLight, sameAngles, sceneLightAngles } from './scene-light.ts';
import { Evaluators, numbersOf, subjectsOf, sweptParameter, termsOf } from './series.ts';
import { type BenchSettings, CURRENT, freeColor, paneSettings } from './settings.ts';
import { createTabs } from './tabs.ts';
import { createVerdictPanel } from './verdict.ts';
import { viewInfo } from './views.ts';
import { putWorstCase, worstSettings } from './worst-case.ts';

export interface BenchOptions {
  /** The geometry of an object in the scene; undefined while it is loading. */
  geometryOf(object: string): BufferGeometry | undefined;
  /** Where the scene is drawn: the light is turned there, too. */
  readonly viewport: HTMLElement;
  /** What draws it, once it has started: the verdict asks its GPU. */
  renderer(): RealtimeRenderer | null;
}

export function createBench(session: Session, { geometryOf, viewport, renderer }: BenchOptions): HTMLElement {
  const { store, state } = session;
  installLightDrag(viewport, session);
  const evaluators = new Evaluators();
  const background = new Background(() => wantFrame());
  const change = (patch: Partial<BenchSettings>) => state.set({ bench: { ...state.value.bench, ...patch } });
  const subjects = () => subjectsOf(store.document, state.value.selection, state.value.bench.pins);
  const activeView = () => paneSettings(state.value.bench, state.value.bench.active).view;

  const putCase = (worst: WorstCase, label?: string) => {
    const id = selectedMaterial(store.document, state.value.selection);
    if (id !== undefined) attempt(t('The case cannot be shown'), () => putWorstCase(store, id, worst, label));
  };
  const verdict = createVerdictPanel({
    renderer,
    showCase(worst) {
      putCase(worst);
      const { bench, benchPage } = state.value;
      // In the dock the verdict itself is in the way of what there is to see.
      const panes = benchPage ? bench.panes : bench.panes.with(bench.active, 'lobe');
      change({ ...worstSettings(worst), panes });
    },
    showCell(cell) {
      putCase(cell, t('Parameters from the map'));
      change(worstSettings(cell));
    },
  });
  const grid = createGrid({
    wantFrame: () => wantFrame(),
    change,
    activate: (active) => change({ active }),
    choose: (pane, view) => change({ active: pane, panes: state.value.bench.panes.with(pane, view) }),
    panel: () => verdict.element,
  });
  const tabs = createTabs((view) => {
    const { panes, active } = state.value.bench;
    change({ panes: panes.with(active, view) });
  });
  const controls = createControls({
    change,
    placeLight: () => placeSceneLight(store, state.value.bench),
  });
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
    'aria-label': t('Computing the plot'),
    hidden: true,
  });
  const page = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Fill the page with the bench'),
      tip: t('Fill the page, six views at once'),
      keys: 'view.benchPage',
    },
    icon('expand'),
  );
  page.addEventListener('click', () => toggleBenchPage(state));
  const close = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Close the bench'),
      tip: t('Close'),
      keys: 'view.bench',
    },
    icon('close'),
  );
  close.addEventListener('click', () => state.set({ benchOpen: false, benchPage: false }));

  const mesh = () => {
    const object = litObject(store.document, state.value.selection);
    const geometry = object === null ? undefined : geometryOf(object);
    return geometry ? meshOf(geometry) : null;
  };

  /** What is on the screen, at the parameters of this moment; in float64 as far as slices go, where `exact`. */
  const present = (pane: number, probe: Probe | null, exact = false): { plot: Plot; progress: number } => {
    const all = subjects();
    const terms = all[0] ? termsOf(all[0]) : [];
    const { bench } = state.value;
    const parameter = sweptParameter(all[0], bench.parameter);
    const settings = {
      ...paneSettings(bench, pane),
      // Another model may not have the term; its whole is then shown, and the term again when it is back.
      term: terms.includes(bench.term) ? bench.term : 'BRDF',
      parameter: parameter?.name ?? '',
    };
    const data = plotData(all, settings, { evaluators, background, mesh, parameter, exact });
    return { plot: { settings, curves: data.curves, probe, parameter }, progress: data.progress };
  };

  /** A file of a curve that is not complete would be taken for the whole; a panel is no plot. */
  const cannotExport = () =>
    viewInfo[activeView()].view === null || present(state.value.bench.active, null).progress < 1;

  const save = async (extension: 'svg' | 'png' | 'csv') => {
    const { active } = state.value.bench;
    const { plot } = present(active, null, true);
    const { width, height } = grid.pane(active).size();
    const name = `${fileNameOf(subjects()[0]?.name ?? 'brdf')}-${plot.settings.view}.${extension}`;
    try {
      if (extension === 'svg') download(name, exportSvg(plot, width, height));
      else if (extension === 'png') download(name, await exportPng(plot, width, height));
      else download(name, exportCsv(plot));
    } catch (error) {
      toastError(t('The plot was not saved'), error);
    }
  };

  const sash = createSash(
    () => element.offsetHeight,
    (benchHeight) => state.set({ benchHeight }),
  );
  const element: HTMLElement = h(
    'section',
    { class: 'bench', 'aria-label': t('BRDF bench') },
    sash,
    h(
      'div',
      { class: 'bench-bar' },
      tabs.element,
      progress,
      h('span', { class: 'spacer' }),
      menuButton(t('Export'), () => [
        { label: 'SVG', icon: 'image', disabled: cannotExport(), run: () => void save('svg') },
        { label: 'PNG', icon: 'image', disabled: cannotExport(), run: () => void save('png') },
        {
          label: 'CSV',
          icon: 'file',
          tip: t('The numbers, in full precision'),
          disabled: cannotExport(),
          run: () => void save('csv'),
        },
      ]),
      page,
      close,
    ),
    grid.element,
    h('div', { class: 'bench-side' }, legend.element, controls.element),
  );

  const draw = () => {
    const all = subjects();
    const { bench } = state.value;
    const visible = state.value.benchPage ? bench.panes.map((_, pane) => pane) : [bench.active];
    grid.show(bench, visible);
    tabs.show(activeView());
    let done = 1;
    let reading: Plot | null = null;
    for (const pane of visible) {
      if (viewInfo[paneSettings(bench, pane).view].view === null) {
        verdict.show(all[0]?.id === CURRENT ? all[0] : undefined);
        continue;
      }
      const { probe } = grid.pane(pane);
      const now = present(pane, probe);
      grid.pane(pane).draw(now.plot);
      done = Math.min(done, now.progress);
      if (probe || pane === bench.active) reading ??= now.plot;
      if (probe) reading = now.plot;
    }
    const settings = reading?.settings ?? { ...bench, term: bench.term };
    controls.show(
      settings,
      visible.map((pane) => paneSettings(bench, pane).view),
      all[0] ? termsOf(all[0]) : [],
      numbersOf(all[0]).map(({ name }) => name),
    );
    legend.show(all, bench);
    const { where, values } = readings(reading);
    legend.showValues(where, values, bench.channel);
    progress.value = done;
    progress.hidden = done >= 1;
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
    const { benchOpen, benchPage, benchHeight } = state.value;
    element.hidden = !benchOpen;
    element.classList.toggle('page', benchPage);
    page.setAttribute('aria-pressed', String(benchPage));
    const height = clampHeight(benchHeight);
    element.style.height = benchPage ? '' : `${height}px`;
    sash.setAttribute('aria-valuenow', String(height));
    wantFrame();
  };

  /** One undo step for each time that the switch is on. */
  let merge: string | undefined;
  const lightFollows = (previous: BenchSettings) => {
    const { bench } = state.value;
    if (!bench.lightInStep) return;
    const light = sceneLightAngles(store.document);
    if (!previous.lightInStep) {
      // The scene is what the person made: the plots come to it, not it to them.
      merge = newGesture();
      if (light) change(light);
    } else if (!light || !sameAngles(light, bench)) placeSceneLight(store, bench, merge);
  };
  store.subscribe(() => {
    const { bench } = state.value;
    const light = bench.lightInStep ? sceneLightAngles(store.document) : null;
    if (light && !sameAngles(light, bench)) change(light);
    wantFrame();
  });
  state.subscribe((_, previous) => {
    if (previous.bench !== state.value.bench) lightFollows(previous.bench);
    layout();
  });
  window.addEventListener('resize', layout);
  onThemeChange(wantFrame);
  layout();
  return element;
}

/** The values under the pointer, and where it is. */
function readings(plot: Plot | null): { where: string; values: Map<string, Rgb> } {
  const values = new Map<string, Rgb>();
  const view = plot && viewInfo[plot.settings.view].view;
  if (!plot?.probe || !view) return { where: '', values };
  for (const curve of plot.curves) {
    const rgb = view.value(curve, plot.probe, plot);
    if (rgb) values.set(curve.id, rgb);
  }
  return { where: view.where(plot.probe, plot), values };
}
