/**
 * A cell is one value of the document, as an inspector's field reads and writes it. Fields are
 * generated from schemas and model files, so the place of a value is a path, not a typed property;
 * the store validates every edit against the schema.
 */
import type { Path } from '../../../scene/error.ts';
import type { Document } from '../../../scene/schema.ts';
import type { DocumentStore } from '../../../scene/store.ts';
import { t } from '../../language/language.ts';
import type { Gesture } from '../../ui/gesture.ts';
import { toastError } from '../../ui/toast.ts';

export interface Cell {
  get(): unknown;
  /** Undefined removes the value, which for a model's parameter means its default. */
  set(value: unknown, gesture?: Gesture): void;
}

export function readPath(document: Document, path: Path): unknown {
  let value: unknown = document;
  for (const key of path) {
    if (typeof value !== 'object' || value === null) return undefined;
    value = (value as Record<string | number, unknown>)[key];
  }
  return value;
}

export function writePath(document: Document, path: Path, value: unknown): void {
  const parent = readPath(document, path.slice(0, -1));
  const key = path.at(-1);
  if (typeof parent !== 'object' || parent === null || key === undefined) return;
  if (value === undefined) delete (parent as Record<string | number, unknown>)[key];
  else (parent as Record<string | number, unknown>)[key] = value;
}

/** What else an edit of a field changes, in the same step. */
export type AlongWith = Readonly<Record<string, (draft: Document) => void>>;

export function pathCell(
  store: DocumentStore,
  path: Path,
  label: string,
  along?: (draft: Document) => void,
): Cell {
  return {
    get: () => readPath(store.document, path),
    set: (value, gesture) => {
      tryEdit(
        store,
        label,
        (draft) => {
          writePath(draft, path, value);
          along?.(draft);
        },
        gesture && `${path.join('.')} ${gesture}`,
      );
    },
  };
}

/** An edit that the schema refuses changes nothing and says why. */
export function tryEdit(
  store: DocumentStore,
  label: string,
  recipe: (draft: Document) => void,
  merge?: string,
): boolean {
  try {
    store.edit(label, recipe, merge ? { merge } : {});
    return true;
  } catch (error) {
    toastError(t('That value is not possible'), error);
    return false;
  }
}
