import { DocumentError, pathText } from './error.ts';
import type { Collection, Document } from './schema.ts';

/** What can be selected. */
export type EntityKind = 'lights' | 'objects' | 'materials';

/** A light, an object or a material of a document. */
export interface EntityRef {
  readonly kind: EntityKind;
  readonly id: string;
}

/** What can be in a group, hidden and locked. */
export type MemberKind = 'lights' | 'objects';
export interface MemberRef extends EntityRef {
  readonly kind: MemberKind;
}

export const memberKinds: readonly MemberKind[] = ['lights', 'objects'];

export const isMember = (ref: EntityRef): ref is MemberRef => ref.kind !== 'materials';

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

const KIND_WORDS: Readonly<Record<EntityKind, readonly [one: string, many: string]>> = {
  lights: ['light', 'lights'],
  objects: ['object', 'objects'],
  materials: ['material', 'materials'],
};

/** For labels: the name of one, the numbers of many. */
export function describeEntities(document: Document, refs: readonly EntityRef[]): string {
  const [first] = refs;
  if (first && refs.length === 1) return entity(document, first.kind, first.id).name;
  const counts = (Object.keys(KIND_WORDS) as EntityKind[])
    .map((kind) => [kind, refs.filter((ref) => ref.kind === kind).length] as const)
    .filter(([, count]) => count > 0)
    .map(([kind, count]) => `${count} ${KIND_WORDS[kind][count === 1 ? 0 : 1]}`);
  return counts.join(' and ').replace(/ and (?=.* and )/g, ', ');
}
