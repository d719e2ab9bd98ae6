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
  return firstFree(
    start,
    (id) => Object.hasOwn(taken, id),
    (n) => `${start}-${n}`,
  );
}

/** A name that none of `taken` has: the base, or the base with a number. */
export function freeName(base: string, taken: Iterable<string>): string {
  const names = new Set(taken);
  // "Point light 2" is followed by "Point light 3", not by "Point light 2 2".
  const root = base.replace(/ \d{1,6}$/, '').slice(0, 180);
  if (!names.has(base) && base.length <= 200) return base;
  return firstFree(
    root,
    (name) => names.has(name),
    (n) => `${root} ${n}`,
  );
}

function firstFree(base: string, isTaken: (name: string) => boolean, numbered: (n: number) => string) {
  if (!isTaken(base)) return base;
  let n = 2;
  while (isTaken(numbered(n))) n += 1;
  return numbered(n);
}
