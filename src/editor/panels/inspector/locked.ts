/** What is locked stays where it is: the fields of its place cannot be used. */
import type { MemberRef } from '../../../scene/entity.ts';
import type { FieldInfo } from '../../../scene/fields.ts';
import { lightDefaults } from '../../../scene/light-schema.ts';
import { objectDefaults } from '../../../scene/schema.ts';
import type { Session } from '../../session.ts';
import type { Cell } from './cell.ts';
import { type Bound, infoField, labelOf } from './field.ts';
import { PLACEMENT } from './many-cell.ts';

/** The field of a place; undefined for other fields. */
export function placeField(
  { store }: Session,
  { kind, id }: MemberRef,
  name: string,
  info: FieldInfo,
  cell: Cell,
): Bound | undefined {
  if (!PLACEMENT.has(name)) return undefined;
  const light = store.document.lights[id];
  const defaults: object = kind === 'objects' ? objectDefaults : light ? lightDefaults[light.type] : {};
  const field = infoField(labelOf(name), info, cell, (defaults as Record<string, unknown>)[name]);
  return (
    field && {
      element: field.element,
      update() {
        field.update();
        field.element.inert = store.document[kind][id]?.locked === true;
      },
    }
  );
}
