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

/** What the packed scene depends on as a whole; of the rest a rendering is told with its camera and settings. */
const packed = ['fog', 'environment', 'background', 'ground'] as const satisfies readonly Single[];

/** Of each thing, what is for people alone; nor is the order of things seen. */
const unseen = {
  lights: ['name', 'locked', 'group'],
  objects: ['name', 'locked', 'group'],
  materials: ['name'],
  models: [],
  assets: ['name'],
} as const satisfies Partial<Record<Collection, readonly string[]>>;

/** Whether the same light is in both. */
export function sameScene(a: Document, b: Document): boolean {
  return (
    packed.every((name) => a[name] === b[name]) &&
    (Object.keys(unseen) as (keyof typeof unseen)[]).every(
      (name) => a[name] === b[name] || sameEntries(a[name], b[name], unseen[name]),
    )
  );
}

type Things = Readonly<Record<string, object>>;

function sameEntries(a: Things, b: Things, but: readonly string[]): boolean {
  const ids = Object.keys(a);
  return ids.length === Object.keys(b).length && ids.every((id) => sameFields(a[id], b[id], but));
}

/** Fields that have not changed are the same value: documents share them. */
function sameFields(a: object | undefined, b: object | undefined, but: readonly string[]): boolean {
  if (a === b) return true;
  if (a === undefined || b === undefined) return false;
  const other = new Map(Object.entries(b));
  const entries = Object.entries(a);
  return (
    entries.length === other.size &&
    entries.every(([name, value]) => but.includes(name) || (other.has(name) && other.get(name) === value))
  );
}
