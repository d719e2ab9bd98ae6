/** A light: every field of its schema, its brightness in the unit that the person prefers. */

import { setLightType } from '../../../scene/commands.ts';
import { type LightType, lightDefaults, lightShapes, lightTypes } from '../../../scene/light-schema.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { section } from '../../ui/section.ts';
import { pathCell } from './cell.ts';
import { type Bound, choiceLabel, labelOf, shapeFields } from './field.ts';
import { placeField } from './locked.ts';
import type { InspectorPanel } from './panel.ts';
import { chosenUnit, isPhotometric, photometricRow } from './photometric.ts';
import { isTemperature, temperatureRow } from './temperature.ts';

/** The panel has to be made anew when this changes. */
export function lightStructure(session: Session, id: string): string {
  const type = session.store.document.lights[id]?.type;
  return type ? `${id} ${type} ${chosenUnit(session, type)}` : '';
}

export function lightPanel(session: Session, id: string): InspectorPanel {
  const { store, state } = session;
  const light = store.document.lights[id];
  const bound: Bound[] = [];
  if (light) {
    bound.push(typeChoice(session, id));
    bound.push(
      ...shapeFields(lightShapes[light.type], {
        cell: (name, label) =>
          pathCell(store, ['lights', id, name], t('Change {label}', { label: label.toLowerCase() })),
        defaults: { ...lightDefaults[light.type] },
        skip: ['name'],
        custom(name, info, cell) {
          if (isPhotometric(light.type, name)) return photometricRow(session, id, light.type, info, cell);
          if (isTemperature(info)) return temperatureRow(labelOf(name), info, cell);
          return placeField(session, { kind: 'lights', id }, name, info, cell);
        },
      }),
    );
  }
  const title = 'Light';
  return {
    element: h(
      'div',
      {},
      section(
        translate(title),
        state.value.folded.includes(title),
        (folded) => state.fold(title, folded),
        ...bound.map((field) => field.element),
      ),
    ),
    update() {
      for (const field of bound) field.update();
    },
  };
}

function typeChoice({ store }: Session, id: string): Bound {
  const choices = lightTypes.map((value) => ({ value, label: choiceLabel(value) }));
  const field = selectField(t('Type'), choices, (value) => {
    attempt(t('The type stays as it was'), () => setLightType(store, id, value as LightType));
  });
  return {
    element: row({ label: t('Type'), tip: t('Another type of light in the same place') }, field.element),
    update: () => field.show(store.document.lights[id]?.type ?? ''),
  };
}
