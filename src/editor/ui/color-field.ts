/**
 * A colour: a swatch that opens the picker, and its sRGB hex code. Plain DOM because the toolkit's
 * picker rounds to 8 bits, which would change a linear colour by being looked at.
 */

import { t } from '../language/language.ts';
import { cssColor, fromHex, type Rgb, toHex } from './color.ts';
import { openColorPopup } from './color-popup.ts';
import { h } from './dom.ts';
import type { Gesture } from './gesture.ts';

export interface ColorFieldOptions {
  label: string;
  /** The largest linear component; without it a component may be typed beyond 1. */
  max?: number | undefined;
  onChange(linear: Rgb, gesture: Gesture): void;
}

export interface ColorField {
  readonly element: HTMLElement;
  show(linear: Rgb): void;
}

export function colorField(options: ColorFieldOptions): ColorField {
  let value: Rgb = [0, 0, 0];
  let popup: { show(linear: Rgb): void } | null = null;
  const swatch = h('button', {
    type: 'button',
    class: 'swatch',
    'aria-label': t('{label}: open the colour picker', { label: options.label }),
  });
  const hex = h('input', {
    type: 'text',
    class: 'hex',
    'aria-label': t('{label}, sRGB hex', { label: options.label }),
    autocomplete: 'off',
    spellcheck: 'false',
    maxlength: 7,
  });

  const show = (linear: Rgb) => {
    value = linear;
    swatch.style.backgroundColor = cssColor(linear);
    if (document.activeElement !== hex) hex.value = toHex(linear);
    popup?.show(linear);
  };
  const change = (linear: Rgb, gesture: Gesture) => {
    show(linear);
    options.onChange(linear, gesture);
  };
  swatch.addEventListener('click', () => {
    popup = openColorPopup({
      anchor: swatch,
      label: options.label,
      max: options.max,
      value,
      onChange: change,
      onClose: () => {
        popup = null;
      },
    });
  });
  const commit = () => {
    const typed = fromHex(hex.value);
    if (typed && toHex(typed) !== toHex(value)) change(typed, undefined);
    hex.value = toHex(value);
  };
  hex.addEventListener('focus', () => hex.select());
  hex.addEventListener('blur', commit);
  hex.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      hex.value = toHex(value);
      event.stopPropagation();
    }
    if (event.key === 'Enter' || event.key === 'Escape') hex.blur();
  });
  return { element: h('div', { class: 'color' }, swatch, hex), show };
}
