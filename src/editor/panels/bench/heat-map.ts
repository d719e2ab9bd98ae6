/** A law over two parameters of the model, under the verdict: each cell reads its worst case, and a click shows it. */
import { cellParameters, type HeatMap, MAPPED, worstCell } from '../../../analysis/verdict/heat-map.ts';
import { FIGURES, heatColor } from '../../../analysis/verdict/heat-map-picture.ts';
import type { WorstCase } from '../../../analysis/verdict/types.ts';
import type { FloatParameter } from '../../../brdf/model.ts';
import { t, translate } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { selectField } from '../../ui/fields.ts';
import type { HeatMapAnswer, HeatMapJob } from './heat-map-job.ts';
import { shortNumber } from './scale.ts';
import { modelOf } from './series.ts';
import type { VerdictJob } from './verdict-job.ts';

export interface HeatMapPanel {
  readonly element: HTMLElement;
  /** Begins with the map of a model over the parameters that matter most; null clears. */
  show(job: VerdictJob | null): void;
}

interface Cell {
  readonly column: number;
  readonly row: number;
}

/** Pixels of a cell; the page scales the picture. */
const CELL = 12;

export function createHeatMapPanel(showCell: (worst: WorstCase) => void): HeatMapPanel {
  let asked: HeatMapJob | null = null;
  let worker: Worker | null = null;
  let map: HeatMap | null = null;
  let at: Cell | null = null;

  const law = selectField(
    t('Law of the map'),
    MAPPED.map((value) => ({ value, label: translate(FIGURES[value]) })),
    (value) => change({ property: MAPPED.find((name) => name === value) ?? 'energy' }),
  );
  const axis = (label: string, put: (name: string) => readonly [string, string]) => {
    const field = selectField(label, [], (name) => change({ axes: put(name) }));
    field.element.classList.add('heat-map-axis');
    return field;
  };
  /** Those that were asked for last, for the map of before may still be in sight. */
  const axes = () => asked?.axes ?? ([map?.x.name ?? '', map?.y.name ?? ''] as const);
  // Choosing what the other axis has swaps the two.
  const across = axis(t('Parameter to the right'), (name) => {
    const [x, y] = axes();
    return [name, name === y ? x : y];
  });
  const upwards = axis(t('Parameter upwards'), (name) => {
    const [x, y] = axes();
    return [name === x ? y : x, name];
  });
  const canvas = h('canvas', { class: 'heat-map-picture', tabindex: 0, role: 'img' });
  const reading = h('p', { class: 'heat-map-reading', role: 'status' });
  const progress = h('progress', { class: 'bench-progress', max: 1, 'aria-label': t('Drawing the map') });
  const ends = { left: h('span'), right: h('span'), bottom: h('span'), top: h('span') };
  const plane = h(
    'div',
    { class: 'heat-map-plane' },
    h('div', { class: 'heat-map-up' }, ends.top, upwards.element, ends.bottom),
    canvas,
    h('div', { class: 'heat-map-across' }, ends.left, across.element, ends.right),
  );
  const element = h(
    'section',
    { class: 'heat-map', 'aria-label': t('Map over two parameters'), hidden: true },
    h('div', { class: 'verdict-head' }, `${t('Map:')} `, law.element, progress),
    plane,
    reading,
  );

  const change = (patch: Partial<HeatMapJob>) => {
    if (asked) begin({ ...asked, ...patch });
  };
  const begin = (job: HeatMapJob) => {
    asked = job;
    worker?.terminate();
    progress.hidden = false;
    progress.value = 0;
    worker = new Worker(new URL('./heat-map-worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<HeatMapAnswer>) => {
      if (data.kind === 'progress') {
        progress.value = data.done;
        return;
      }
      worker?.terminate();
      worker = null;
      progress.hidden = true;
      if (data.kind === 'map') take(data.map);
      else reading.textContent = data.message;
    });
    worker.postMessage(job);
  };
  const take = (next: HeatMap) => {
    map = next;
    at = null;
    plane.hidden = false;
    const { x, y } = next;
    for (const [field, { name }] of [
      [across, x],
      [upwards, y],
    ] as const) {
      field.setChoices(names().map((value) => ({ value, label: value })));
      field.show(name);
    }
    law.show(next.property);
    ends.left.textContent = shortNumber(x.min);
    ends.right.textContent = shortNumber(x.max);
    ends.bottom.textContent = shortNumber(y.min);
    ends.top.textContent = shortNumber(y.max);
    draw();
  };
  const names = () => {
    const parameters = (asked && modelOf(asked)?.parameters) ?? [];
    return parameters.filter(({ type }) => type === 'float').map(({ name }) => name);
  };
  const draw = () => {
    if (!map) return;
    const { size, cells, property } = map;
    const worst = worstCell(map);
    canvas.width = size * CELL;
    canvas.height = size * CELL;
    const context = canvas.getContext('2d') as CanvasRenderingContext2D;
    for (const [i, { value }] of cells.entries()) {
      context.fillStyle = `rgb(${heatColor(property, value, worst.cell.value).join(' ')})`;
      context.fillRect((i % size) * CELL, (size - 1 - Math.floor(i / size)) * CELL, CELL, CELL);
    }
    const { column, row } = at ?? worst;
    context.strokeStyle = '#fff';
    context.lineWidth = 2;
    context.strokeRect(column * CELL + 1, (size - 1 - row) * CELL + 1, CELL - 2, CELL - 2);
    reading.textContent = at ? words(map, at) : t('Worst: {case}', { case: words(map, worst) });
    canvas.setAttribute('aria-label', reading.textContent);
  };
  const go = (next: Cell | null) => {
    at = next;
    draw();
  };
  const choose = ({ column, row }: Cell) => {
    if (!map) return;
    const { l, v } = cellAt(map, { column, row });
    showCell({ term: 'BRDF', parameters: cellParameters(map, column, row), l, v });
  };
  const under = ({ clientX, clientY }: MouseEvent): Cell | null => {
    if (!map) return null;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const index = (share: number, size: number) => Math.min(size - 1, Math.max(0, Math.floor(share * size)));
    return {
      column: index((clientX - left) / width, map.size),
      row: map.size - 1 - index((clientY - top) / height, map.size),
    };
  };
  canvas.addEventListener('pointermove', (event) => go(under(event)));
  canvas.addEventListener('pointerleave', () => go(null));
  canvas.addEventListener('click', (event) => {
    const cell = under(event);
    if (cell) choose(cell);
  });
  canvas.addEventListener('keydown', (event) => {
    if (!map) return;
    const { column, row } = at ?? worstCell(map);
    if (event.key === 'Enter') choose({ column, row });
    const step = STEPS[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const within = (i: number) => Math.min((map as HeatMap).size - 1, Math.max(0, i));
    go({ column: within(column + step[0]), row: within(row + step[1]) });
  });

  return {
    element,
    show(job) {
      element.hidden = !job;
      worker?.terminate();
      worker = null;
      if (!job) return;
      reading.textContent = '';
      plane.hidden = true;
      map = null;
      begin({ ...job, property: asked?.property ?? 'energy', axes: null });
    },
  };
}

const STEPS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const cellAt = ({ cells, size }: HeatMap, { column, row }: Cell) =>
  cells[row * size + column] as HeatMap['cells'][number];

function words(map: HeatMap, cell: Cell): string {
  const set = cellParameters(map, cell.column, cell.row);
  const part = ({ name }: FloatParameter) => `${name} ${shortNumber(set[name] as number)}`;
  const { value } = cellAt(map, cell);
  return t('{figure} {value} at {place}', {
    figure: translate(FIGURES[map.property]),
    value: shortNumber(value),
    place: `${part(map.x)}, ${part(map.y)}`,
  });
}
