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
import { type Cell, pathCell } from './cell.ts';
import { type Bound, numberControl, shapeFields } from './field.ts';

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
function heightRow({ store }: Session, info: FieldInfo, cell: Cell): Bound {
  const lowest = () => Math.round(1000 * lowestObject(store.document)) / 1000;
  const toggle = switchField(t('Height by a number'), (isNumber) => cell.set(isNumber ? lowest() : null));
  const number = numberControl(t('Height'), info, { ...cell, get: () => cell.get() ?? lowest() });
  return {
    element: row(
      { label: t('Height'), tip: translate(info.description), onReset: () => cell.set(null) },
      h('div', { class: 'switched' }, toggle.element, number.element),
    ),
    update() {
      const isNumber = typeof cell.get() === 'number';
      toggle.show(isNumber);
      number.element.inert = !isNumber;
      number.update();
    },
  };
}
