/** The colour picker: saturation and value square, hue strip, and the three linear numbers. */

import { t } from '../language/language.ts';
import { fromHsv, type Rgb, toHsv, toLinear, toSrgb } from './color.ts';
import { h } from './dom.ts';
import { type Gesture, newGesture } from './gesture.ts';
import { numberField } from './number-field.ts';
import { openPopup } from './popup.ts';

export interface ColorPopupOptions {
  anchor: HTMLElement;
  label: string;
  max?: number | undefined;
  value: Rgb;
  onChange(linear: Rgb, gesture: Gesture): void;
  onClose(): void;
}

const CHANNELS = ['R', 'G', 'B'] as const;

/** Of the whole width or height: for an arrow key, with Shift, and with Alt. */
const KEY_STEP = 0.01;
const FINE_STEP = 0.001;
const COARSE_STEP = 0.1;
/** Red again would be at 360 degrees, and stand at the other end. */
const LAST_HUE = 359.99;
/** To the right and upwards. */
const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const inUnit = (value: number) => Math.max(0, Math.min(1, value));

export function openColorPopup(options: ColorPopupOptions): { show(linear: Rgb): void } {
  let linear = options.value;
  let hsv = toHsv(toSrgb(linear));
  let picking = false;

  const squareHandle = h('div', { class: 'handle' });
  const square = h(
    'div',
    {
      class: 'color-square',
      role: 'slider',
      tabindex: 0,
      'aria-label': t('{label}: saturation and value', { label: options.label }),
    },
    squareHandle,
  );
  const hueHandle = h('div', { class: 'handle' });
  const hue = h(
    'div',
    {
      class: 'color-hue',
      role: 'slider',
      tabindex: 0,
      'aria-valuemin': 0,
      'aria-valuemax': 360,
      'aria-label': t('{label}: hue', { label: options.label }),
    },
    hueHandle,
  );
  const numbers = CHANNELS.map((channel, i) =>
    numberField({
      label: t('{label}, linear {channel}', { label: options.label, channel }),
      min: 0,
      max: options.max,
      step: 0.01,
      onChange: (value, gesture) => {
        const next: [number, number, number] = [linear[0], linear[1], linear[2]];
        next[i] = value;
        options.onChange(next, gesture);
      },
    }),
  );

  const paint = () => {
    const [r, g, b] = fromHsv([hsv[0], 1, 1]).map((c) => Math.round(c * 255));
    square.style.backgroundColor = `rgb(${r} ${g} ${b})`;
    squareHandle.style.left = `${Math.min(1, hsv[1]) * 100}%`;
    squareHandle.style.top = `${(1 - Math.min(1, hsv[2])) * 100}%`;
    hueHandle.style.left = `${(hsv[0] / 360) * 100}%`;
    const [saturation, value] = [Math.round(hsv[1] * 100), Math.round(hsv[2] * 100)];
    square.setAttribute('aria-valuenow', String(saturation));
    square.setAttribute(
      'aria-valuetext',
      t('saturation {saturation} %, value {value} %', { saturation, value }),
    );
    hue.setAttribute('aria-valuenow', String(Math.round(hsv[0])));
    numbers.forEach((field, i) => {
      field.show(linear[i] ?? 0);
    });
  };
  const show = (next: Rgb) => {
    linear = next;
    if (!picking) {
      const fresh = toHsv(toSrgb(next));
      // A grey has no hue and black no saturation: keep what the person had chosen.
      hsv = [fresh[1] > 0 ? fresh[0] : hsv[0], fresh[2] > 0 ? fresh[1] : hsv[1], fresh[2]];
    }
    paint();
  };
  const drag = (area: HTMLElement, pick: (x: number, y: number) => Rgb) => {
    area.addEventListener('pointerdown', (down) => {
      down.preventDefault();
      area.setPointerCapture(down.pointerId);
      const gesture = newGesture();
      const move = (event: PointerEvent) => {
        const box = area.getBoundingClientRect();
        const x = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
        const y = Math.min(1, Math.max(0, (event.clientY - box.top) / box.height));
        hsv = pick(x, y);
        picking = true;
        options.onChange(toLinear(fromHsv(hsv)), gesture);
        picking = false;
      };
      const end = () => {
        area.removeEventListener('pointermove', move);
        area.removeEventListener('pointerup', end);
        area.removeEventListener('pointercancel', end);
      };
      area.addEventListener('pointermove', move);
      area.addEventListener('pointerup', end);
      area.addEventListener('pointercancel', end);
      move(down);
    });
  };
  const step = (area: HTMLElement, pick: (right: number, up: number) => Rgb) => {
    area.addEventListener('keydown', (event) => {
      const [right, up] = ARROWS[event.key] ?? [];
      if (right === undefined || up === undefined) return;
      event.preventDefault();
      const size = event.shiftKey ? FINE_STEP : event.altKey ? COARSE_STEP : KEY_STEP;
      hsv = pick(right * size, up * size);
      picking = true;
      options.onChange(toLinear(fromHsv(hsv)), undefined);
      picking = false;
    });
  };
  step(square, (right, up) => [hsv[0], inUnit(hsv[1] + right), inUnit(hsv[2] + up)]);
  step(hue, (right, up) => [Math.max(0, Math.min(LAST_HUE, hsv[0] + 360 * (right + up))), hsv[1], hsv[2]]);
  drag(square, (x, y) => [hsv[0], x, 1 - y]);
  drag(hue, (x) => [Math.min(LAST_HUE, x * 360), hsv[1], hsv[2]]);

  const content = h(
    'div',
    { class: 'color-popup' },
    square,
    hue,
    h(
      'div',
      { class: 'color-numbers' },
      ...numbers.map((field, i) => h('label', {}, h('span', {}, CHANNELS[i] ?? ''), field.element)),
    ),
    h('p', { class: 'hint' }, t('Linear Rec. 709, as the BRDF sees it')),
  );
  openPopup({ anchor: options.anchor, content, label: options.label, onClose: options.onClose });
  paint();
  // Its arrows are at hand at once.
  square.focus({ preventScroll: true });
  return { show };
}
