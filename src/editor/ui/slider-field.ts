/**
 * A slider with its number beside it. The slider spans the range the model's author found useful;
 * the number takes any value (Burley's principle 4: allow a parameter beyond its range where it
 * makes sense), and the slider then stands at its end.
 */

import { t } from '../language/language.ts';
import { h } from './dom.ts';
import { formatNumber, roundTo } from './expression.ts';
import { cancelGesture, type Gesture, newGesture } from './gesture.ts';
import { numberField } from './number-field.ts';

export interface SliderFieldOptions {
  min: number;
  max: number;
  /** Hard limits of the typed number, where a value beyond makes no sense. */
  hardMin?: number | undefined;
  hardMax?: number | undefined;
  integer?: boolean;
  /** 'log' spreads values of many magnitudes, such as luminous intensities. */
  scale?: 'linear' | 'log';
  unit?: string | undefined;
  label: string;
  onChange(value: number, gesture: Gesture): void;
}

export interface SliderField {
  readonly element: HTMLElement;
  show(value: number): void;
}

const KEYS: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

/** Positions on the track; fine enough that no pixel of a wide track is skipped. */
const TICKS = 1000;

export function sliderField(options: SliderFieldOptions): SliderField {
  const { min, max } = options;
  const log = options.scale === 'log';
  const step = log ? 0 : options.integer ? 1 : niceStep((max - min) / 100);
  const toTick = (value: number) => {
    if (!log) return ((value - min) / (max - min)) * TICKS;
    return value <= min ? 0 : (Math.log(value / min) / Math.log(max / min)) * TICKS;
  };
  const toValue = (tick: number) => {
    if (!log) return roundTo(min + ((max - min) * tick) / TICKS, options.integer ? 1 : step / 10);
    if (tick <= 0) return options.hardMin ?? min;
    return Number((min * (max / min) ** (tick / TICKS)).toPrecision(3));
  };

  let gesture: Gesture;
  /** Escape has given the drag up, and the pointer is still down. */
  let givenUp = false;
  let shown = min;
  const range = h('input', { type: 'range', min: 0, max: TICKS, step: 1, 'aria-label': options.label });
  const number = numberField({
    label: t('{label}, number', { label: options.label }),
    min: options.hardMin,
    max: options.hardMax,
    unit: options.unit,
    integer: options.integer,
    step: log ? niceStep(max / 1000) : step,
    onChange: (value, key) => {
      paint(value);
      options.onChange(value, key);
    },
  });
  /** The track counts its positions; what they mean is the number. */
  const tell = (value: number) =>
    range.setAttribute('aria-valuetext', [formatNumber(value), options.unit].filter(Boolean).join(' '));
  const paint = (value: number) => {
    const tick = Math.min(TICKS, Math.max(0, toTick(value)));
    range.value = String(Math.round(tick));
    range.style.setProperty('--fill', String(tick / TICKS));
    range.classList.toggle('beyond', value < min - 1e-9 || value > max + 1e-9);
    tell(value);
  };
  range.addEventListener('pointerdown', () => {
    gesture = newGesture();
    givenUp = false;
  });
  range.addEventListener('input', () => {
    if (givenUp) {
      paint(shown);
      return;
    }
    gesture ??= newGesture();
    const value = toValue(Number(range.value));
    range.style.setProperty('--fill', String(Number(range.value) / TICKS));
    range.classList.remove('beyond');
    number.show(value);
    tell(value);
    options.onChange(value, gesture);
  });
  range.addEventListener('change', () => {
    gesture = undefined;
    givenUp = false;
  });
  // The browser's own steps are the track's positions, far too fine for a key.
  range.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && gesture !== undefined) {
      event.stopPropagation();
      const drag = gesture;
      gesture = undefined;
      givenUp = true;
      cancelGesture(range, drag);
      return;
    }
    const direction = KEYS[event.key];
    if (!direction) return;
    event.preventDefault();
    const size = (TICKS / 100) * (event.shiftKey ? 0.1 : 1);
    range.value = String(Number(range.value) + direction * size);
    range.dispatchEvent(new Event('input'));
    range.dispatchEvent(new Event('change'));
  });
  // A mouse drag must not leave the focus on the track: arrow keys and shortcuts belong to the page.
  range.addEventListener('pointerup', () => range.blur());

  return {
    element: h('div', { class: 'slider' }, range, number.element),
    show(value) {
      shown = value;
      number.show(value);
      if (gesture === undefined) paint(value);
    },
  };
}

/** 1, 2 or 5 times a power of ten, near the given size. */
function niceStep(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const factor = size / power;
  return power * (factor < 1.5 ? 1 : factor < 3.5 ? 2 : factor < 7.5 ? 5 : 10);
}
