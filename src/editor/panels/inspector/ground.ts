/** The ground that shows shadows: one switch, and how it lies while it is on. */
import type { FieldInfo } from '../../../scene/fields.ts';
import { setShadowCatcher } from '../../../scene/ground-commands.ts';
import { groundDefaults, groundShape } from '../../../scene/ground-schema.ts';
import { lowestObject } from '../../../scene/placement.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, switchField } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { type Cell, pathCell } from './cell.ts';
import { type Bound, shapeFields } from './field.ts';

export function groundFields(session: Session): Bound[] {
  const { store } = session;
  const isOn = store.document.ground.shadowCatcher;
  return shapeFields(groundShape, {
    cell: (field, label) =>
      pathCell(store, ['ground', field], t('Change {label}', { label: label.toLowerCase() })),
    defaults: groundDefaults,
    skip: isOn ? [] : Object.keys(groundShape).filter((name) => name !== 'shadowCatcher'),
    custom: (name, info, cell) =>
      name === 'shadowCatcher'
        ? catcherRow(session, info)
        : name === 'height'
          ? heightRow(session, info, cell)
          : undefined,
  });
}

function catcherRow({ store }: Session, { description }: FieldInfo): Bound {
  const field = switchField(t('Shadow catcher'), (isShown) =>
    attempt(t('The ground stays as it is'), () => setShadowCatcher(store, isShown)),
  );
  return {
    element: row({ label: t('Shadow catcher'), tip: translate(description) }, field.element),
    update: () => field.show(store.document.ground.shadowCatcher),
  };
}

/** Where it lies by itself, or a number. */
function heightRow(
  { store }: Session,
  { description, unit, min, max, slider: range }: FieldInfo,
  cell: Cell,
): Bound {
  const [low, high] = range ?? [-5, 5];
  const lowest = () => Math.round(1000 * lowestObject(store.document)) / 1000;
  const toggle = switchField(t('Height by a number'), (isNumber) => cell.set(isNumber ? lowest() : null));
  const slider = sliderField({
    label: t('Height'),
    min: low,
    max: high,
    hardMin: min,
    hardMax: max,
    unit,
    onChange: (value, gesture) => cell.set(value, gesture),
  });
  return {
    element: row(
      { label: t('Height'), tip: translate(description), onReset: () => cell.set(null) },
      h('div', { class: 'switched' }, toggle.element, slider.element),
    ),
    update() {
      const value = cell.get();
      toggle.show(typeof value === 'number');
      slider.element.inert = typeof value !== 'number';
      slider.show(typeof value === 'number' ? value : lowest());
    },
  };
}
