/** The studio's part of the inspector: arrangements, the picture of the soft boxes, and the fields of the chosen one. */
import {
  addSoftBox,
  changeSoftBox,
  removeSoftBox,
  setEnvironmentSource,
} from '../../../scene/environment-commands.ts';
import { MAX_SOFT_BOXES, softBoxDefaults, softBoxShape } from '../../../scene/environment-schema.ts';
import {
  type ArrangementName,
  arrangementNames,
  arrangementOf,
  arrangements,
  studioOf,
} from '../../../scene/studio-arrangements.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { iconButton } from '../../ui/icon-button.ts';
import type { Cell } from '../inspector/cell.ts';
import { type Bound, labelOf, shapeFields } from '../inspector/field.ts';
import { isTemperature, temperatureRow } from '../inspector/temperature.ts';
import { studioPicture } from './picture.ts';

/** Where the picture shows it in its middle; all else is a soft box's own. */
const IN_FRONT = { azimuth: 180, elevation: 30 } as const;

export function studioPanel(session: Session): Bound {
  const { store } = session;
  let selected = 0;
  const boxes = () => {
    const { source } = store.document.environment;
    return source.type === 'studio' ? source.boxes : [];
  };
  const select = (index: number) => {
    if (selected === index) return;
    selected = index;
    update();
  };
  const picture = studioPicture({ session, selected: () => selected, select });
  const arrangement = arrangementRow(session);

  const count = h('span', { class: 'studio-count' });
  const failed = t('The studio stays as it is');
  const add = iconButton('plus', t('Add a soft box'), () => {
    const index = attempt(failed, () => addSoftBox(store, IN_FRONT));
    if (index !== undefined) select(index);
  });
  const copy = iconButton('copy', t('Duplicate the soft box at the other side'), () => {
    const box = boxes()[selected];
    if (box === undefined) return;
    const azimuth = (360 - box.azimuth + 360) % 360;
    const index = attempt(failed, () => addSoftBox(store, { ...box, azimuth, roll: -box.roll }));
    if (index !== undefined) select(index);
  });
  const remove = iconButton('trash', t('Delete the soft box'), () =>
    attempt(failed, () => removeSoftBox(store, selected)),
  );
  const fields = shapeFields(softBoxShape, {
    cell: (name, label) => boxCell(name, t('Change {label}', { label: label.toLowerCase() })),
    defaults: softBoxDefaults,
    custom: (name, info, cell) =>
      isTemperature(info) ? temperatureRow(labelOf(name), info, cell) : undefined,
  });
  function boxCell(name: string, label: string): Cell {
    return {
      get: () => (boxes()[selected] as Record<string, unknown> | undefined)?.[name],
      set: (value, gesture) =>
        attempt(t('The soft box stays as it is'), () =>
          changeSoftBox(
            store,
            selected,
            { [name]: value },
            label,
            gesture && `soft box ${selected} ${name} ${gesture}`,
          ),
        ),
    };
  }
  const chosen = h('div', { class: 'studio-fields' }, ...fields.map(({ element }) => element));
  const update = () => {
    const { length } = boxes();
    selected = Math.min(Math.max(selected, 0), length - 1);
    picture.update();
    arrangement.update();
    count.textContent =
      length === 0
        ? t('No soft boxes')
        : t('Soft box {number} of {count}', { number: selected + 1, count: length });
    add.disabled = length >= MAX_SOFT_BOXES;
    copy.disabled = length === 0 || length >= MAX_SOFT_BOXES;
    remove.disabled = length === 0;
    chosen.hidden = length === 0;
    if (length > 0) for (const field of fields) field.update();
  };
  return {
    element: h(
      'div',
      { class: 'studio' },
      arrangement.element,
      picture.element,
      h('div', { class: 'studio-bar' }, count, add, copy, remove),
      chosen,
    ),
    update,
  };
}

const OWN = 'own';

function arrangementRow({ store }: Session): Bound {
  const choices = arrangementNames.map((name) => ({
    value: name as string,
    label: translate(arrangements[name].title),
  }));
  const field = selectField(t('Arrangement'), choices, (value) => {
    if (value !== OWN)
      attempt(t('The studio stays as it is'), () =>
        setEnvironmentSource(store, studioOf(value as ArrangementName)),
      );
  });
  const tip = arrangementNames
    .map((name) => `${translate(arrangements[name].title)}: ${translate(arrangements[name].description)}`)
    .join('\n');
  return {
    element: row({ label: t('Arrangement'), tip }, field.element),
    update() {
      const { source } = store.document.environment;
      if (source.type !== 'studio') return;
      const name = arrangementOf(source);
      field.setChoices(name === null ? [{ value: OWN, label: t('One’s own') }, ...choices] : choices);
      field.show(name ?? OWN);
    },
  };
}
