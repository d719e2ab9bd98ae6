/**
 * A number in a box: type a value or an expression, use the arrow keys, or drag sideways over the
 * box to scrub (Shift: finer, Ctrl: coarser, Escape: as it was). Limits here are hard ones; a soft range belongs to the slider.
 */
import { h } from './dom.ts';
import { evaluateExpression, formatNumber, roundTo } from './expression.ts';
import { cancelGesture, type Gesture, newGesture } from './gesture.ts';

export interface NumberFieldOptions {
  min?: number | undefined;
  max?: number | undefined;
  /** What one arrow key adds, and what two pixels of scrubbing add. */
  step?: number | undefined;
  unit?: string | undefined;
  integer?: boolean | undefined;
  label: string;
  onChange(value: number, gesture: Gesture): void;
}

export interface NumberField {
  readonly element: HTMLElement;
  readonly input: HTMLInputElement;
  show(value: number): void;
}

/** Of the field's own, for a key: Shift makes them finer, Alt coarser. */
const STEPS: Readonly<Record<string, number>> = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
const SCRUB_THRESHOLD_PX = 3;
const PX_PER_STEP = 2;

export function numberField(options: NumberFieldOptions): NumberField {
  const step = options.step ?? 0.1;
  let value = 0;
  const input = h('input', {
    type: 'text',
    inputmode: 'decimal',
    'aria-label': options.label,
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const element = h(
    'div',
    { class: 'number' },
    input,
    options.unit ? h('span', { class: 'unit' }, options.unit) : null,
  );

  const clamp = (next: number) => {
    const inside = Math.min(options.max ?? Infinity, Math.max(options.min ?? -Infinity, next));
    return options.integer ? Math.round(inside) : inside;
  };
  const show = (next: number) => {
    value = next;
    if (document.activeElement !== input || !editing) input.value = formatNumber(next);
  };
  const change = (next: number, gesture: Gesture) => {
    const clamped = clamp(next);
    if (clamped === value) return;
    show(clamped);
    options.onChange(clamped, gesture);
  };

  let editing = false;
  const commit = () => {
    if (!editing) return;
    editing = false;
    const typed = input.value.trim() === formatNumber(value) ? value : evaluateExpression(input.value);
    if (typed !== null) change(typed, undefined);
    input.value = formatNumber(value);
  };
  input.addEventListener('focus', () => {
    editing = true;
    input.select();
  });
  input.addEventListener('blur', commit);
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') {
      commit();
      input.blur();
    } else if (event.key === 'Escape') {
      editing = false;
      input.value = formatNumber(value);
      input.blur();
      event.stopPropagation();
    } else if (STEPS[event.key]) {
      event.preventDefault();
      commit();
      const factor = event.shiftKey ? 0.1 : event.altKey ? 10 : 1;
      const by = step * factor * (STEPS[event.key] as number);
      change(roundTo(value + by, Math.min(step, Math.abs(by))), undefined);
      editing = true;
      input.value = formatNumber(value);
    }
  });

  // Scrubbing starts only past the threshold, so that a plain click still means "type here".
  input.addEventListener('pointerdown', (down) => {
    if (down.button !== 0 || document.activeElement === input || input.disabled) return;
    down.preventDefault();
    const start = value;
    let gesture: Gesture;
    let travelled = 0;
    let lastX = down.clientX;
    input.setPointerCapture(down.pointerId);
    const move = (event: PointerEvent) => {
      if (gesture === undefined && Math.abs(event.clientX - down.clientX) < SCRUB_THRESHOLD_PX) return;
      gesture ??= newGesture();
      element.classList.add('scrubbing');
      const coarse = event.ctrlKey || event.metaKey;
      travelled += (event.clientX - lastX) * (event.shiftKey ? 0.1 : coarse ? 10 : 1);
      lastX = event.clientX;
      change(roundTo(start + (travelled / PX_PER_STEP) * step, step / 10), gesture);
    };
    const giveUp = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || gesture === undefined) return;
      event.stopPropagation();
      cancelGesture(element, gesture);
      end();
    };
    const end = () => {
      window.removeEventListener('keydown', giveUp, true);
      input.removeEventListener('pointermove', move);
      input.removeEventListener('pointerup', end);
      input.removeEventListener('pointercancel', end);
      element.classList.remove('scrubbing');
      if (gesture === undefined) input.focus();
    };
    window.addEventListener('keydown', giveUp, true);
    input.addEventListener('pointermove', move);
    input.addEventListener('pointerup', end);
    input.addEventListener('pointercancel', end);
  });

  return { element, input, show };
}
