/**
 * A light's brightness in the unit that a person thinks in. The document keeps the unit that the
 * shading equation wants; other units are only another way to read and type the same value.
 */
import { falloffAt } from '../../../lights/falloff.ts';
import {
  pointFlux,
  pointIntensity,
  spotFlux,
  spotIntensity,
  surfaceFlux,
  surfaceLuminance,
} from '../../../lights/units.ts';
import type { FieldInfo } from '../../../scene/fields.ts';
import { type LightOf, type LightType, lightDefaults } from '../../../scene/light-schema.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import type { Cell } from './cell.ts';
import { type Bound, labelOf } from './field.ts';

interface PhotometricUnit<T extends LightType> {
  readonly unit: string;
  readonly tip: string;
  fromStored(value: number, light: LightOf<T>): number;
  toStored(value: number, light: LightOf<T>): number;
}

interface Photometric<T extends LightType> {
  readonly field: string;
  readonly units: readonly PhotometricUnit<T>[];
}

const stored = (unit: string, tip: string) => ({
  unit,
  tip,
  fromStored: (value: number) => value,
  toStored: (value: number) => value,
});

/** Light of the same luminance from everywhere above a surface gives it pi times as many lux. */
const surround = [
  stored('nits', t('Luminance')),
  {
    unit: 'lx',
    tip: t('Illuminance of a surface that nothing shades'),
    fromStored: (value: number) => Math.PI * value,
    toStored: (value: number) => value / Math.PI,
  },
];

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const area = (light: LightOf<'rectangle'>) => light.width * light.height;

function atTarget(light: LightOf<'spot'>): number {
  const distance = Math.hypot(...light.position.map((x, i) => x - (light.target[i] ?? 0)));
  return falloffAt(distance, light.falloff, light.range);
}

const PHOTOMETRIC: { readonly [T in LightType]: Photometric<T> } = {
  ambient: { field: 'luminance', units: surround },
  hemisphere: { field: 'luminance', units: surround },
  directional: { field: 'illuminance', units: [stored('lx', t('Illuminance'))] },
  point: {
    field: 'intensity',
    units: [
      stored('cd', t('Luminous intensity')),
      {
        unit: 'lm',
        tip: t('Luminous flux, into all directions'),
        fromStored: pointFlux,
        toStored: pointIntensity,
      },
    ],
  },
  spot: {
    field: 'intensity',
    units: [
      stored('cd', t('Luminous intensity along the axis')),
      {
        unit: 'lm',
        tip: t('Luminous flux of the cone'),
        fromStored: (value, light) => spotFlux(value, radians(light.cutoff), light.exponent),
        toStored: (value, light) => spotIntensity(value, radians(light.cutoff), light.exponent),
      },
      {
        unit: 'lx',
        tip: t('Illuminance at the target, facing the light'),
        fromStored: (value, light) => value * atTarget(light),
        toStored: (value, light) => value / atTarget(light),
      },
    ],
  },
  rectangle: {
    field: 'luminance',
    units: [
      stored('nits', t('Luminance of the lit face')),
      {
        unit: 'lm',
        tip: t('Luminous flux of the lit face'),
        fromStored: (value, light) => surfaceFlux(value, area(light)),
        toStored: (value, light) => surfaceLuminance(value, area(light)),
      },
      {
        unit: 'cd',
        tip: t('Luminous intensity straight ahead'),
        fromStored: (value, light) => value * area(light),
        toStored: (value, light) => value / area(light),
      },
    ],
  },
};

/** Whether this field of the light type is its brightness. */
export function isPhotometric(type: LightType, field: string): boolean {
  return PHOTOMETRIC[type].field === field;
}

/** The unit that the person chose for this type of light. */
export function chosenUnit(session: Session, type: LightType): string {
  const chosen = session.state.value.units[type];
  const { units } = PHOTOMETRIC[type];
  return units.find(({ unit }) => unit === chosen)?.unit ?? units[0]?.unit ?? '';
}

export function photometricRow<T extends LightType>(
  session: Session,
  id: string,
  type: T,
  info: FieldInfo,
  cell: Cell,
): Bound {
  const { store, state } = session;
  const { field, units } = PHOTOMETRIC[type] as Photometric<T>;
  const name = chosenUnit(session, type);
  const unit = units.find((candidate) => candidate.unit === name) ?? units[0];
  const light = () => store.document.lights[id] as LightOf<T>;
  const read = (value: number) => unit?.fromStored(value, light()) ?? value;
  const label = labelOf(field);
  const [min, max] = info.slider ?? [0, 1];
  const slider = sliderField({
    label,
    min: read(min),
    max: Number(read(max).toPrecision(2)),
    hardMin: 0,
    onChange: (value, gesture) => {
      const next = unit?.toStored(value, light()) ?? value;
      if (Number.isFinite(next)) cell.set(Number(next.toPrecision(12)), gesture);
    },
  });
  const choices = units.map(({ unit: value }) => ({ value, label: value }));
  const choice = selectField(t('Unit of {label}', { label: label.toLowerCase() }), choices, (value) =>
    state.set({ units: { ...state.value.units, [type]: value } }),
  );
  choice.show(name);
  const fallback: Readonly<Record<string, unknown>> = lightDefaults[type];
  return {
    element: row(
      {
        label,
        tip: `${unit?.tip ?? translate(info.description)}\n${t('Double click: default')}`,
        onReset: () => cell.set(fallback[field]),
      },
      h('div', { class: 'with-unit' }, slider.element, choice.element),
    ),
    update: () => {
      if (light()) slider.show(read(Number(cell.get() ?? 0)));
    },
  };
}
