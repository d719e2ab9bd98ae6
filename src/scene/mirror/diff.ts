/** What happened to a collection between two documents; equal references mean "nothing". */
export interface Changes<T> {
  removed(id: string): void;
  added(id: string, value: T): void;
  changed(id: string, value: T): void;
}

type Entries<T> = Readonly<Record<string, T>>;

export function diff<T>(before: Entries<T>, now: Entries<T>, changes: Changes<T>): void {
  if (before === now) return;
  for (const id of Object.keys(before)) if (!Object.hasOwn(now, id)) changes.removed(id);
  for (const [id, value] of Object.entries(now)) {
    if (!Object.hasOwn(before, id)) changes.added(id, value);
    else if (before[id] !== value) changes.changed(id, value);
  }
}
