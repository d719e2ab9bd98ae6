/**
 * What has to be sent of a document so that another thread has it, too. Entries that are the same object as before
 * are named and not sent: there they stay the same object, by which decoded images and packed meshes are found again.
 */
import { type Collection, collections, type Document, type Single, singles } from '../../scene/schema.ts';

/** Entries in their order; those without a value are as they were. */
type Entries = readonly (readonly [id: string, entry?: unknown])[];

export interface DocumentChange {
  readonly singles: Partial<Pick<Document, Single>>;
  readonly collections: Partial<Record<Collection, Entries>>;
}

/** @param before what the other side has, null for nothing */
export function changeOf(before: Document | null, now: Document): DocumentChange {
  const changed = singles.filter((name) => before?.[name] !== now[name]);
  const touched = collections.filter((name) => before?.[name] !== now[name]);
  const entries = (name: Collection): Entries =>
    Object.entries(now[name]).map(([id, entry]) => (before?.[name][id] === entry ? [id] : [id, entry]));
  return {
    singles: Object.fromEntries(changed.map((name) => [name, now[name]])),
    collections: Object.fromEntries(touched.map((name) => [name, entries(name)])),
  };
}

export function applyChange(before: Document | null, change: DocumentChange): Document {
  const parts = Object.entries(change.collections).map(([name, entries]) => [
    name,
    Object.fromEntries(
      entries.map(([id, ...sent]) => [id, sent.length > 0 ? sent[0] : before?.[name as Collection][id]]),
    ),
  ]);
  return { ...before, ...change.singles, ...Object.fromEntries(parts) } as Document;
}

/** What the packed scene depends on; of the rest a rendering is told with its camera and settings. */
const packed = [
  'fog',
  'environment',
  'background',
  'lights',
  'objects',
  'materials',
  'models',
  'assets',
] as const satisfies readonly (keyof Document)[];

export function sameScene(a: Document, b: Document): boolean {
  return packed.every((name) => a[name] === b[name]);
}
