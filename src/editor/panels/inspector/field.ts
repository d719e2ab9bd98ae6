/** Fields generated from the schema: one function from a field's description to its control. */
import { type FieldInfo, fieldInfo } from '../../../scene/fields.ts';
import { t, translate } from '../../language/language.ts';
import type { Rgb } from '../../ui/color.ts';
import { colorField } from '../../ui/color-field.ts';
import { row, selectField, switchField, textField } from '../../ui/fields.ts';
import { numberField } from '../../ui/number-field.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { type Vector, vectorField } from '../../ui/vector-field.ts';
import type { Cell } from './cell.ts';

/** A field on the page that can show the document's present value. */
export interface Bound {
  readonly element: HTMLElement;
  update(): void;
}

type Shape = Readonly<Record<string, unknown>>;

export interface ShapeFieldsOptions {
  cell(name: string, label: string): Cell;
  /** Fields that the panel shows in its own way, or not at all. */
  skip?: readonly string[];
  /** What a field is reset to; without it a double click does nothing. */
  defaults?: Readonly<Record<string, unknown>> | undefined;
  /** A control of the panel's own for one field; undefined takes the generated one. */
  custom?(name: string, info: FieldInfo, cell: Cell): Bound | undefined;
}

/** Every field of a schema's shape, in its order. */
export function shapeFields(shape: Shape, options: ShapeFieldsOptions): Bound[] {
  const fields: Bound[] = [];
  for (const [name, schema] of Object.entries(shape)) {
    const info = fieldInfo(schema as Parameters<typeof fieldInfo>[0]);
    if (!info || options.skip?.includes(name)) continue;
    const label = labelOf(name);
    const cell = options.cell(name, label);
    const field =
      options.custom?.(name, info, cell) ?? infoField(label, info, cell, options.defaults?.[name]);
    if (field) fields.push(field);
  }
  return fields;
}

/** The row for one field: label, tooltip, control, reset. */
export function infoField(label: string, info: FieldInfo, cell: Cell, reset?: unknown): Bound | undefined {
  const control = controlFor(label, info, cell);
  if (!control) return undefined;
  const onReset = reset === undefined ? undefined : () => cell.set(structuredClone(reset));
  const element = row(
    {
      label,
      tip: `${translate(info.description)}${onReset ? `\n${t('Double click: default')}` : ''}`,
      ...(onReset && { onReset }),
    },
    control.element,
  );
  return { element, update: control.update };
}

function controlFor(label: string, info: FieldInfo, cell: Cell): Bound | undefined {
  switch (info.kind) {
    case 'number':
    case 'integer':
      return numberControl(label, info, cell);
    case 'boolean': {
      const field = switchField(label, (value) => cell.set(value));
      return { element: field.element, update: () => field.show(cell.get() === true) };
    }
    case 'color': {
      const field = colorField({
        label,
        max: info.max,
        onChange: (value, gesture) => cell.set([...value], gesture),
      });
      return { element: field.element, update: () => field.show(cell.get() as Rgb) };
    }
    case 'vector3':
    case 'vector2': {
      const field = vectorField({
        label,
        size: info.kind === 'vector3' ? 3 : 2,
        step: info.step,
        onChange: (value, gesture) => cell.set([...value], gesture),
      });
      return { element: field.element, update: () => field.show(cell.get() as Vector) };
    }
    case 'choice': {
      const none = info.nullable ? [{ value: '', label: t('None') }] : [];
      const choices = (info.choices ?? []).map((value) => ({ value, label: choiceLabel(value) }));
      const field = selectField(label, [...none, ...choices], (value) =>
        cell.set(value === '' ? null : value),
      );
      return { element: field.element, update: () => field.show(String(cell.get() ?? '')) };
    }
    case 'text': {
      const field = textField(label, (value) => cell.set(value));
      return { element: field.element, update: () => field.show(String(cell.get() ?? '')) };
    }
    case 'reference':
    case 'group':
      return undefined;
  }
}

/** A slider where there is a range worth dragging through, else a number to scrub. */
export function numberControl(label: string, info: FieldInfo, cell: Cell): Bound {
  const integer = info.kind === 'integer';
  const onChange = (value: number, gesture: string | undefined) =>
    cell.set(integer ? Math.round(value) : value, gesture);
  const unit = info.unit && info.unit !== '×' ? unitText(info.unit) : undefined;
  const slider = info.slider ?? (info.min === 0 && info.max === 1 ? ([0, 1] as const) : undefined);
  const field = slider
    ? sliderField({
        label,
        min: slider[0],
        max: slider[1],
        hardMin: info.min,
        hardMax: info.max,
        integer,
        unit,
        onChange,
      })
    : numberField({ label, min: info.min, max: info.max, step: info.step, unit, onChange });
  return { element: field.element, update: () => field.show(Number(cell.get() ?? 0)) };
}

/** The schema abbreviates nit as nt. */
export function unitText(unit: string): string {
  return unit === 'nt' ? 'nits' : unit;
}

/** `emissiveIntensity` as "Emissive intensity", in the page's language. */
export function labelOf(name: string): string {
  return translate(wordsOf(name));
}

/** The same in English, whatever the language: it names what it labels. */
export function wordsOf(name: string): string {
  const words = name
    .replace(/[_-]+/g, ' ')
    .replace(/([a-z\d])([A-Z])/g, (_, a: string, b: string) => `${a} ${b.toLowerCase()}`);
  return ABBREVIATIONS[name] ?? words.charAt(0).toUpperCase() + words.slice(1);
}

const ABBREVIATIONS: Readonly<Record<string, string>> = {
  msaa: 'MSAA',
  fxaa: 'FXAA',
  smaa: 'SMAA',
  ior: 'IOR',
  kd: 'kd',
  aces: 'ACES',
  agx: 'AgX',
  srgb: 'sRGB',
  fov: 'Field of view',
  iso: 'ISO',
  fStop: 'f-number',
  uv: 'UV set',
  utcOffset: 'UTC offset',
};

export function choiceLabel(value: string): string {
  return labelOf(value);
}
