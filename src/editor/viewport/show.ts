/** What the viewport shows instead of the picture: the choice, and a legend that says what its colours mean. */
import { COUNT_COLORS, ZONE_COLORS, ZONES_EACH_SIDE, zoneBound } from '../../color/false-color.ts';
import { focusDistance } from '../../scene/lens.ts';
import type { Document, View } from '../../scene/schema.ts';
import { SHOWN } from '../../scene/stage-schema.ts';
import { t } from '../language/language.ts';
import { tryEdit } from '../panels/inspector/cell.ts';
import { choiceLabel } from '../panels/inspector/field.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { selectField } from '../ui/fields.ts';

type Show = View['show'];

/** Shows the next of all that can be shown, or the one before. */
export function stepShown({ store }: Session, step: 1 | -1): void {
  const next = SHOWN.indexOf(store.document.view.show) + step;
  show(store, SHOWN[(next + SHOWN.length) % SHOWN.length] as Show);
}

function show(store: Session['store'], value: Show): void {
  tryEdit(store, t('Show {label}', { label: choiceLabel(value).toLowerCase() }), (draft) => {
    draft.view.show = value;
  });
}

export interface ShowView {
  readonly element: HTMLElement;
  /** @param exposure in EV, of the picture as it is shown */
  update(exposure: number): void;
  /** What the pixel under the pointer holds; null where there is none. */
  read(pixel: readonly [number, number, number, number] | null): void;
}

export function createShowView(session: Session): ShowView {
  const { store } = session;
  const choices = SHOWN.map((value) => ({ value, label: choiceLabel(value) }));
  const field = selectField(t('Show'), choices, (value) => show(store, value as Show));
  const choice = h(
    'label',
    { class: 'show-choice', tip: t('The picture, or what is behind it'), keys: 'view.nextData' },
    h('span', {}, t('Show')),
    field.element,
  );
  const legend = h('div', { class: 'show-legend' });
  const reading = h('div', { class: 'show-reading', role: 'status' });
  const key = h('div', { class: 'show-key' }, legend, reading);
  let drawn = '';
  const update = (exposure: number) => {
    const { document } = store;
    const shown = document.view.show;
    field.show(shown);
    choice.classList.toggle('on', shown !== 'picture');
    key.hidden = shown === 'picture';
    // Rounded to what the numbers show, so that it is not built anew with every frame.
    const scale =
      shown === 'luminance' ? exposure.toFixed(2) : shown === 'depth' ? focusDistance(document.camera) : '';
    const state = `${shown} ${scale}`;
    if (state === drawn) return;
    drawn = state;
    reading.textContent = '';
    legend.replaceChildren(...legendOf(document, exposure));
  };
  return {
    element: h('div', { class: 'show-view' }, choice, key),
    update,
    read(pixel) {
      reading.textContent = pixel === null ? '' : readingOf(store.document.view.show, pixel);
    },
  };
}

/** Three digits, as a person writes them. */
export function nits(value: number): string {
  if (!(value > 0)) return '0';
  if (value >= 1e5 || value < 1e-3) return value.toExponential(1).replace('e+', 'e');
  return String(Number(value.toPrecision(value >= 1000 ? 4 : 3)));
}

const css = ([r, g, b]: readonly [number, number, number]) => `rgb(${r} ${g} ${b})`;

function legendOf(document: Document, exposure: number): HTMLElement[] {
  switch (document.view.show) {
    case 'picture':
      return [];
    case 'luminance':
      return [
        h('div', { class: 'show-title' }, t('Luminance, nits; a stop each')),
        ...ZONE_COLORS.map((color, i) => zoneRow(color, i - ZONES_EACH_SIDE, exposure)).reverse(),
      ];
    case 'overdraw':
      return counts(t('Times that a pixel is drawn'));
    case 'cascades':
      return counts(t('Shadow map of the sun, 1 the finest'));
    case 'ambientOcclusion':
      return [
        h('div', { class: 'show-title' }, t('Ambient occlusion')),
        row('rgb(255 255 255)', t('open, or not looked for')),
        row('rgb(0 0 0)', t('closed')),
      ];
    case 'lights':
      return counts(t('Lamps that reach a pixel'));
    case 'depth': {
      const distance = Number(focusDistance(document.camera).toPrecision(3));
      return [
        h('div', { class: 'show-title' }, t('Distance along the view')),
        row('rgb(255 255 255)', '0 m'),
        row('rgb(128 128 128)', t('{distance} m, in focus', { distance })),
        row('rgb(0 0 0)', t('far away')),
      ];
    }
    case 'textureCoordinates':
      return [
        h('div', { class: 'show-title' }, t('Texture coordinates')),
        row('rgb(255 0 0)', 'u = 1'),
        row('rgb(0 255 0)', 'v = 1'),
      ];
    case 'motion':
      return [
        h('div', { class: 'show-title' }, t('Motion, pixels a frame')),
        row('rgb(255 128 128)', t('32 to the right')),
        row('rgb(128 255 128)', t('32 down')),
        row('rgb(128 128 128)', t('none')),
      ];
    default:
      return [
        h('div', { class: 'show-title' }, t('Direction in the world')),
        row('rgb(255 128 128)', '+x'),
        row('rgb(128 255 128)', '+y'),
        row('rgb(128 128 255)', '+z'),
      ];
  }
}

function zoneRow(color: readonly [number, number, number], zone: number, exposure: number): HTMLElement {
  const least = zoneBound(zone, exposure);
  const stops = zone > 0 ? `+${zone}` : zone < 0 ? `−${-zone}` : t('middle grey');
  if (zone === -ZONES_EACH_SIDE)
    return row(css(color), t('below {value}', { value: nits(zoneBound(zone + 1, exposure)) }), stops);
  return row(
    css(color),
    zone === ZONES_EACH_SIDE ? t('above {value}', { value: nits(least) }) : nits(least),
    stops,
  );
}

function counts(title: string): HTMLElement[] {
  const last = COUNT_COLORS.length - 1;
  return [
    h('div', { class: 'show-title' }, title),
    ...COUNT_COLORS.map((color, i) =>
      row(css(color), i === last ? t('{count} and more', { count: i }) : String(i)),
    ),
  ];
}

function row(color: string, text: string, more = ''): HTMLElement {
  const swatch = h('span', { class: 'show-swatch' });
  swatch.style.background = color;
  return h(
    'div',
    { class: 'show-row' },
    swatch,
    h('span', {}, text),
    h('span', { class: 'show-more' }, more),
  );
}

function readingOf(shown: Show, [r, g, b, a]: readonly [number, number, number, number]): string {
  if (shown === 'luminance') return `${nits(0.2126 * r + 0.7152 * g + 0.0722 * b)} nits`;
  if (shown === 'overdraw' || shown === 'lights' || shown === 'cascades') return String(Math.round(r));
  if (a === 0) return t('nothing');
  const digits = (x: number) => (Math.abs(x) < 0.0005 ? 0 : x).toFixed(3);
  if (shown === 'depth') return `${digits(r)} m`;
  if (shown === 'ambientOcclusion') return digits(r);
  if (shown === 'textureCoordinates') return `u ${digits(r)}, v ${digits(g)}`;
  if (shown === 'motion') return `${digits(r)}, ${digits(g)} px`;
  return [r, g, b].map(digits).join(', ');
}
