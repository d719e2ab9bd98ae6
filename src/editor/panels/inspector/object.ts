/** An object: what it is made of, where it is, its geometry; its material follows below. */

import { setGeometryType } from '../../../scene/commands.ts';
import {
  type AddableGeometry,
  addableGeometries,
  geometryDefaults,
  geometryNames,
  geometryShapes,
} from '../../../scene/geometry-schema.ts';
import { assignMaterial, giveOwnMaterials, putMaterial } from '../../../scene/material-commands.ts';
import { type Document, objectDefaults, objectShape } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { plural, t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { section } from '../../ui/section.ts';
import { pathCell, tryEdit } from './cell.ts';
import { type Bound, shapeFields } from './field.ts';
import { placeField } from './locked.ts';
import { materialPanel, materialStructure } from './material.ts';
import type { InspectorPanel } from './panel.ts';

export function objectStructure(document: Document, id: string): string {
  const object = document.objects[id];
  return object ? `${id} ${object.geometry.type} ${materialStructure(document, object.material)}` : '';
}

export function objectPanel(session: Session, id: string): InspectorPanel {
  const { store, state } = session;
  const object = store.document.objects[id];
  const geometry = object?.geometry;
  const placement = shapeFields(objectShape, {
    cell: (name, label) =>
      pathCell(store, ['objects', id, name], t('Change {label}', { label: label.toLowerCase() })),
    defaults: objectDefaults,
    skip: ['name'],
    custom: (name, info, cell) => placeField(session, { kind: 'objects', id }, name, info, cell),
  });
  const shape = geometry
    ? shapeFields(geometryShapes[geometry.type], {
        cell: (name, label) =>
          pathCell(
            store,
            ['objects', id, 'geometry', name],
            t('Change {label}', { label: label.toLowerCase() }),
          ),
        defaults: geometry.type === 'gltf' ? undefined : { ...geometryDefaults[geometry.type] },
      })
    : [];
  const type = geometryChoice(session, id);
  const assigned = materialChoice(session, id);
  const bound: Bound[] = [...placement, ...shape, type, assigned];
  const material = object ? materialPanel(session, object.material) : null;
  const fold = (title: string, ...children: Node[]) =>
    section(
      translate(title),
      state.value.folded.includes(title),
      (folded) => state.fold(title, folded),
      ...children,
    );
  return {
    element: h(
      'div',
      {},
      fold('Object', ...placement.map((field) => field.element), assigned.element),
      fold('Geometry', type.element, ...shape.map((field) => field.element)),
      material?.element,
    ),
    update() {
      for (const field of bound) field.update();
      material?.update();
    },
  };
}

function geometryChoice({ store }: Session, id: string): Bound {
  const choices = addableGeometries.map((value) => ({ value, label: translate(geometryNames[value]) }));
  const field = selectField(t('Shape'), choices, (value) => {
    attempt(t('The shape stays as it was'), () => setGeometryType(store, id, value as AddableGeometry));
  });
  return {
    element: row({ label: t('Shape'), tip: t('Another shape in the same place') }, field.element),
    update() {
      const type = store.document.objects[id]?.geometry.type ?? 'sphere';
      const imported = type === 'gltf' ? [{ value: type, label: translate(geometryNames[type]) }] : [];
      field.setChoices([...imported, ...choices]);
      field.show(type);
    },
  };
}

const NEW_MATERIAL = '+new';
const OWN_MATERIAL = '+own';

function materialChoice({ store }: Session, id: string): Bound {
  const shared = h('p', { class: 'hint shared-material' });
  const field = selectField(t('Material'), [], (value) => {
    if (value === OWN_MATERIAL) {
      attempt(t('The material stays as it was'), () => giveOwnMaterials(store, [id]));
      return;
    }
    if (value !== NEW_MATERIAL) {
      attempt(t('The material stays as it was'), () => assignMaterial(store, [id], value));
      return;
    }
    tryEdit(store, t('New material'), (draft) => {
      const object = draft.objects[id];
      if (object) object.material = putMaterial(draft, { name: object.name });
    });
  });
  return {
    element: h(
      'div',
      {},
      row({ label: t('Material'), tip: t('Objects may share a material') }, field.element),
      shared,
    ),
    update() {
      const { materials, objects } = store.document;
      const own = objects[id]?.material ?? '';
      const others = Object.values(objects).filter(({ material }) => material === own).length - 1;
      shared.hidden = others < 1;
      shared.textContent = plural(
        others,
        'One other object has it, too',
        '{count} other objects have it, too',
      );
      field.setChoices([
        ...Object.entries(materials).map(([value, material]) => ({ value, label: material.name })),
        { value: NEW_MATERIAL, label: t('New material') },
        ...(others < 1 ? [] : [{ value: OWN_MATERIAL, label: t('A copy of it for this object') }]),
      ]);
      field.show(own);
    },
  };
}
