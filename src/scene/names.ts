/** Free ids and names for what is added to a document. */

/** An id that `taken` does not have: the base, or the base with a number. */
export function freeId(base: string, taken: Readonly<Record<string, unknown>>): string {
  return firstFree(slugOf(base), (id) => Object.hasOwn(taken, id)).id;
}

/** Ids for many things at once: what was given is taken, and no number is tried twice. */
export class FreeIds {
  readonly #taken: Set<string>;
  readonly #next = new Map<string, number>();

  constructor(taken: Iterable<string>) {
    this.#taken = new Set(taken);
  }

  take(base: string): string {
    const slug = slugOf(base);
    const { id, next } = firstFree(slug, (id) => this.#taken.has(id), this.#next.get(slug));
    this.#next.set(slug, next);
    this.#taken.add(id);
    return id;
  }
}

function slugOf(base: string): string {
  const slug = base
    .normalize('NFD')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^[^a-z]+|-+$/g, '')
    .slice(0, 48)
    .replace(/-+$/, '');
  return slug === '' ? 'item' : slug;
}

function firstFree(slug: string, isTaken: (id: string) => boolean, from = 1): { id: string; next: number } {
  const numbered = (n: number) => (n === 1 ? slug : `${slug}-${n}`);
  let n = from;
  while (isTaken(numbered(n))) n += 1;
  return { id: numbered(n), next: n + 1 };
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
    const number = / \d{1,6}$/.exec(base)?.[0];
    const root = base.slice(0, base.length - (number?.length ?? 0)).slice(0, 180);
    if (number === undefined && !this.#taken.has(root)) return root;
    let n = Math.max(this.#next.get(root) ?? 2, Number(number ?? 0) + 1);
    while (this.#taken.has(`${root} ${n}`)) n += 1;
    this.#next.set(root, n + 1);
    return `${root} ${n}`;
  }
}
