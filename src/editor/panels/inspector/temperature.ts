/** The colour temperature of a light, which it may have or not. */
import type { FieldInfo } from '../../../scene/fields.ts';
import { t, translate } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { row, switchField } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import type { Cell } from './cell.ts';
import type { Bound } from './field.ts';

export const isTemperature = ({ unit, nullable }: FieldInfo): boolean => unit === 'K' && nullable === true;

/** About the white of daylight: where a temperature starts when it is switched on. */
const FIRST_TEMPERATURE = 6500;

/** A number that may be switched off: the light is then white. */
export function temperatureRow(label: string, info: FieldInfo, cell: Cell): Bound {
  const [min, max] = info.slider ?? [info.min ?? 0, info.max ?? 1];
  const toggle = switchField(t('{label} on', { label }), (on) => cell.set(on ? FIRST_TEMPERATURE : null));
  const slider = sliderField({
    label,
    min,
    max,
    hardMin: info.min,
    hardMax: info.max,
    unit: info.unit,
    onChange: (value, gesture) => cell.set(value, gesture),
  });
  return {
    element: row(
      { label, tip: translate(info.description), onReset: () => cell.set(null) },
      h('div', { class: 'switched' }, toggle.element, slider.element),
    ),
    update() {
      const value = cell.get();
      toggle.show(typeof value === 'number');
      slider.element.inert = typeof value !== 'number';
      slider.show(typeof value === 'number' ? value : FIRST_TEMPERATURE);
    },
  };
}
