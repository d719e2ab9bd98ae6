/** What is plotted: colour, name, the value under the pointer; pin, solo, remove. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import type { Rgb } from '../../../analysis/plots/curve.ts';
import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { dashOf } from './frame.ts';
import { shortNumber } from './scale.ts';
import type { Subject } from './series.ts';
import { type BenchSettings, CURRENT } from './settings.ts';

const SVG = 'http://www.w3.org/2000/svg';

export interface LegendActions {
  pin(): void;
  solo(id: string): void;
  remove(id: string): void;
}

export interface Legend {
  readonly element: HTMLElement;
  show(subjects: readonly Subject[], settings: BenchSettings): void;
  /** Of each curve at the probe; empty without one. */
  showValues(where: string, values: ReadonlyMap<string, Rgb>, channel: BenchSettings['channel']): void;
}

export function createLegend(actions: LegendActions): Legend {
  const rows = h('ul', { class: 'bench-legend' });
  const where = h('span', { class: 'bench-where', role: 'status' });
  const pin = h(
    'button',
    {
      type: 'button',
      class: 'text-button',
      tip: t('Keep a copy of the model and its parameters to compare with'),
    },
    t('Pin'),
  );
  pin.addEventListener('click', () => actions.pin());
  const values = new Map<string, HTMLElement>();
  let structure = '';

  const legendRow = ({ id, name, model }: Subject, swatch: SVGElement, solo: string | null) => {
    const value = h('span', { class: 'bench-value' });
    values.set(id, value);
    const alone = h(
      'button',
      {
        type: 'button',
        class: 'icon-button',
        'aria-label': t('Solo {name}', { name }),
        'aria-pressed': String(solo === id),
        tip: t('Draw this one alone'),
      },
      icon(solo !== null && solo !== id ? 'eyeOff' : 'eye'),
    );
    alone.classList.toggle('on', solo === id);
    alone.addEventListener('click', () => actions.solo(id));
    const remove = h(
      'button',
      { type: 'button', class: 'icon-button', 'aria-label': t('Remove {name}', { name }) },
      icon('close'),
    );
    remove.addEventListener('click', () => actions.remove(id));
    const item = h(
      'li',
      { class: solo !== null && solo !== id ? 'off' : undefined },
      swatch,
      h('span', { class: 'bench-name', tip: `${name} · ${model}` }, name),
      value,
      alone,
      id === CURRENT ? h('span', { class: 'icon-button' }) : remove,
    );
    item.dataset.curve = id;
    return item;
  };

  return {
    element: h(
      'section',
      { 'aria-label': t('Curves') },
      h('div', { class: 'bench-legend-head' }, where, pin),
      rows,
    ),
    show(subjects, { solo, channel }) {
      pin.disabled = subjects[0]?.id !== CURRENT;
      const next = JSON.stringify([
        solo,
        channel === 'rgb',
        subjects.map(({ id, name, model, color }) => [id, name, model, color]),
      ]);
      if (next === structure) return;
      structure = next;
      values.clear();
      rows.replaceChildren(
        ...subjects.map((subject, i) => {
          const mark = channel === 'rgb' ? swatch('currentColor', dashOf(i)) : swatch(subject.color, []);
          return legendRow(subject, mark, solo);
        }),
      );
    },
    showValues(text, found, channel) {
      where.textContent = text;
      for (const [id, element] of values) {
        const rgb = found.get(id);
        if (!rgb) element.textContent = '';
        else if (channel === 'rgb')
          element.textContent = rgb.map((value) => shortNumber(Number(value.toPrecision(3)))).join('  ');
        else element.textContent = shortNumber(channelOf(rgb, channel));
      }
    },
  };
}

/** The line as it is in the plot. */
function swatch(color: string, dash: readonly number[]): SVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('class', 'bench-swatch');
  svg.setAttribute('aria-hidden', 'true');
  const line = document.createElementNS(SVG, 'path');
  line.setAttribute('d', 'M0 6h24');
  line.style.stroke = color;
  line.setAttribute('stroke-width', '2.5');
  line.setAttribute('stroke-dasharray', dash.join(' '));
  svg.append(line);
  return svg;
}
