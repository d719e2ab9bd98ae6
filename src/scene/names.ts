/** Free ids and names for what is added to a document. */

/** An id that `taken` does not have: the base, or the base with a number. */
export function freeId(base: string, taken: Readonly<Record<string, unknown>>): string {
  const slug = base
    .normalize('NFD')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^[^a-z]+|-+$/g, '')
    .slice(0, 48)
    .replace(/-+$/, '');
  const start = slug === '' ? 'item' : slug;
  if (!Object.hasOwn(taken, start)) return start;
  let n = 2;
  while (Object.hasOwn(taken, `${start}-${n}`)) n += 1;
  return `${start}-${n}`;
}

/** A name that none of `taken` has: the base, or the base with a number. */
export function freeName(base: string, taken: Iterable<string>): string {
  return new FreeNames(taken).take(base);
}

/** Names for many things at once: what was given is taken, and no number is tried twice. */
export class FreeNames {
  readonly #taken: Set<string>;
  readonly #next = new Map<string, number>();

  constructor(taken: Iterable<string>) {
    this.#taken = new Set(taken);
  }

  take(base: string): string {
    const name = this.#free(base);
    this.#taken.add(name);
    return name;
  }

  #free(base: string): string {
    if (!this.#taken.has(base) && base.length <= 200) return base;
    // "Point light 2" is followed by "Point light 3", not by "Point light 2 2".
    const root = base.replace(/ \d{1,6}$/, '').slice(0, 180);
    if (!this.#taken.has(root)) return root;
    let n = this.#next.get(root) ?? 2;
    while (this.#taken.has(`${root} ${n}`)) n += 1;
    this.#next.set(root, n + 1);
    return `${root} ${n}`;
  }
}
