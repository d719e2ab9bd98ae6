/** The keys that the person has chosen, by the action's id, in place of those that actions come with. */
import { isKeys } from './keys.ts';

export type ChosenKeys = Readonly<Record<string, readonly string[]>>;

export class Keymap {
  #chosen: ChosenKeys;
  readonly #keep: (chosen: ChosenKeys) => void;
  readonly #listeners = new Set<() => void>();

  /** @param keep is told of each change, so that it outlasts the page */
  constructor(chosen: ChosenKeys = {}, keep: (chosen: ChosenKeys) => void = () => {}) {
    this.#chosen = chosen;
    this.#keep = keep;
  }

  /** Undefined where nothing was chosen; no keys at all can be chosen, too. */
  get(id: string): readonly string[] | undefined {
    return this.#chosen[id];
  }

  /** In one step, so that two actions can swap their keys. Undefined: those that the action comes with. */
  set(changes: Readonly<Record<string, readonly string[] | undefined>>): void {
    this.#chosen = Object.fromEntries(
      Object.entries({ ...this.#chosen, ...changes }).filter(
        (entry): entry is [string, readonly string[]] => entry[1] !== undefined,
      ),
    );
    this.#keep(this.#chosen);
    for (const listener of [...this.#listeners]) listener();
  }

  /** Back to what all actions come with. */
  reset(): void {
    this.set(Object.fromEntries(Object.keys(this.#chosen).map((id) => [id, undefined])));
  }

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}

const STORAGE_KEY = 'irradia.keys';
/** More than anybody has; a tampered storage must not slow each key. */
const MOST = 500;
const MOST_KEYS = 8;

/** What this browser has kept. */
export function keptKeymap(): Keymap {
  return new Keymap(parseChosen(read()), (chosen) => {
    try {
      localStorage.setItem(STORAGE_KEY, JSON.stringify(chosen));
    } catch {
      // Storage may be forbidden or full; the keys are then those of this visit.
    }
  });
}

function read(): string | null {
  try {
    return localStorage.getItem(STORAGE_KEY);
  } catch {
    return null;
  }
}

/** Of what an older or a tampered page left in storage, that which has the right shape. */
export function parseChosen(stored: string | null): ChosenKeys {
  let value: unknown;
  try {
    value = JSON.parse(stored ?? '{}');
  } catch {
    return {};
  }
  if (typeof value !== 'object' || value === null) return {};
  const entries = Object.entries(value).filter(
    (entry): entry is [string, string[]] =>
      /^\w+\.\w+$/.test(entry[0]) &&
      Array.isArray(entry[1]) &&
      entry[1].length <= MOST_KEYS &&
      entry[1].every((keys) => typeof keys === 'string' && isKeys(keys)),
  );
  return Object.fromEntries(entries.slice(0, MOST));
}
