/**
 * What one tab remembers of itself, for when it is reloaded or comes back after a crash; and which tab has
 * which document open, so that two never write the same one.
 */

import { t } from '../language/language.ts';
import type { EntityKind, Selection } from '../state.ts';

export interface SessionRecord {
  /** What followed the page's address: a tab that was sent elsewhere since has nothing to come back to. */
  readonly address: string;
  /** The kept document that was open. */
  readonly document: string | null;
  readonly selection: Selection;
}

const KEY = 'irradia.session';

export function writeSession(record: SessionRecord): void {
  try {
    sessionStorage.setItem(KEY, JSON.stringify(record));
  } catch {
    // Storage may be forbidden or full; the tab then opens what its address says.
  }
}

/** Null for a new tab. */
export function readSession(): SessionRecord | null {
  try {
    const record: unknown = JSON.parse(sessionStorage.getItem(KEY) ?? 'null');
    if (typeof record !== 'object' || record === null) return null;
    const { address, document, selection } = record as Record<string, unknown>;
    if (typeof address !== 'string' || (document !== null && typeof document !== 'string')) return null;
    return { address, document, selection: selectionOf(selection) };
  } catch {
    return null;
  }
}

const kinds: readonly EntityKind[] = ['lights', 'objects', 'materials'];

function selectionOf(value: unknown): Selection {
  if (typeof value !== 'object' || value === null) return null;
  const { kind, id } = value as Record<string, unknown>;
  const known = kinds.find((name) => name === kind);
  return known && typeof id === 'string' ? { kind: known, id } : null;
}

const lockName = (id: string) => `irradia/document/${id}`;

/** Returns what lets go of the document, or null when another tab has it. A tab that ends lets go by itself. */
export function hold(id: string): Promise<(() => void) | null> {
  return new Promise((resolve, reject) => {
    navigator.locks
      .request(lockName(id), { ifAvailable: true }, (lock) => {
        if (!lock) {
          resolve(null);
          return undefined;
        }
        return new Promise<void>((release) => resolve(release));
      })
      .catch(reject);
  });
}

/** Does something to a document that no tab has open, nor can open meanwhile. */
export async function whileHeld(id: string, what: () => Promise<void>): Promise<void> {
  const release = await hold(id);
  if (!release) throw new Error(t('Another tab has it open.'));
  try {
    await what();
  } finally {
    release();
  }
}

/** The documents that some tab, this one too, has open. */
export async function heldDocuments(): Promise<ReadonlySet<string>> {
  const { held = [] } = await navigator.locks.query();
  const prefix = lockName('');
  const names = held.map(({ name = '' }) => name).filter((name) => name.startsWith(prefix));
  return new Set(names.map((name) => name.slice(prefix.length)));
}
