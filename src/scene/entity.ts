import { DocumentError, pathText } from './error.ts';
import type { Collection, Document } from './schema.ts';

export const namesOf = (entities: Readonly<Record<string, { name: string }>>): string[] =>
  Object.values(entities).map((entity) => entity.name);

type EntityOf = { [C in Collection]: Document[C][string] };

/** The entity of that id; DocumentError if there is none. */
export function entity<C extends Collection>(document: Document, collection: C, id: string): EntityOf[C] {
  const entities = document[collection] as Readonly<Record<string, EntityOf[C]>>;
  const found = Object.hasOwn(entities, id) ? entities[id] : undefined;
  if (found === undefined)
    throw new DocumentError('scene', [{ path: pathText([collection, id]), message: 'does not exist' }]);
  return found;
}
