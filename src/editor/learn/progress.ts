/** How far the person has come in each lesson, kept in the browser. */

export interface Progress {
  /** The step last seen, from 0. */
  readonly step: number;
  /** The last step has been seen. */
  readonly done: boolean;
}

const KEY = 'irradia.lessons';
/** Lessons at addresses come and go. */
const MOST = 100;

export function progressOf(name: string): Progress | undefined {
  return read().get(name);
}

export function keepProgress(name: string, step: number, last: boolean): void {
  const kept = read();
  const done = last || kept.get(name)?.done === true;
  kept.delete(name);
  kept.set(name, { step, done });
  try {
    localStorage.setItem(KEY, JSON.stringify([...kept].slice(-MOST)));
  } catch {
    // Storage may be forbidden or full; the course then begins anew next time.
  }
}

/** What an older or a tampered page left in storage is taken only where it has the right shape. */
function read(): Map<string, Progress> {
  const kept = new Map<string, Progress>();
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    for (const entry of Array.isArray(stored) ? stored : []) {
      const [name, progress] = Array.isArray(entry) ? entry : [];
      const { step, done } = (progress ?? {}) as Record<string, unknown>;
      if (typeof name === 'string' && Number.isInteger(step) && (step as number) >= 0)
        kept.set(name, { step: step as number, done: done === true });
    }
  } catch {
    // As if there were none.
  }
  return kept;
}
