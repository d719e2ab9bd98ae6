/** Two or three numbers in a row, one per axis. */
import { h } from './dom.ts';
import type { Gesture } from './gesture.ts';
import { numberField } from './number-field.ts';

export type Vector = readonly number[];

export interface VectorFieldOptions {
  label: string;
  size: 2 | 3;
  step?: number | undefined;
  onChange(value: Vector, gesture: Gesture): void;
}

export interface VectorField {
  readonly element: HTMLElement;
  show(value: Vector): void;
}

const AXES = ['x', 'y', 'z'] as const;

export function vectorField(options: VectorFieldOptions): VectorField {
  let value: Vector = [];
  const numbers = AXES.slice(0, options.size).map((axis, i) =>
    numberField({
      label: `${options.label} ${axis}`,
      step: options.step ?? 0.05,
      onChange: (component, gesture) => {
        const next = [...value];
        next[i] = component;
        value = next;
        options.onChange(next, gesture);
      },
    }),
  );
  numbers.forEach((number, i) => {
    number.element.classList.add(`axis-${AXES[i]}`);
  });
  return {
    element: h('div', { class: 'vector' }, ...numbers.map((number) => number.element)),
    show(next) {
      value = next;
      numbers.forEach((number, i) => {
        number.show(next[i] ?? 0);
      });
    },
  };
}
