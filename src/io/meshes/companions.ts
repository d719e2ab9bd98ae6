/** Files that came together, such as a dropped folder: their bytes, or how to get them, by path. */
export type Companions<T = Uint8Array> = ReadonlyMap<string, T>;

/** The same by their way from a file's folder (`textures/a.png`, `../b.png`), the nearest first. */
export function companionsFrom<T>(path: string, companions: Companions<T>): Companions<T> {
  const folder = parts(path).slice(0, -1);
  const ways = [...companions].map(([other, content]) => {
    const there = parts(other);
    let shared = 0;
    while (shared < folder.length && shared < there.length - 1 && folder[shared] === there[shared])
      shared += 1;
    const up = folder.length - shared;
    return { way: [...Array<string>(up).fill('..'), ...there.slice(shared)].join('/'), up, content };
  });
  return new Map(ways.toSorted((a, b) => a.up - b.up).map(({ way, content }) => [way, content]));
}

/**
 * The file that a reference inside another one means: by its whole path, else the one whose path ends as the reference does,
 * as far up as it goes. Exporters write paths of the machine on which they ran, and case that its disk did not care for.
 */
export function findCompanion<T>(
  companions: Companions<T>,
  reference: string,
): { path: string; content: T } | null {
  // Formats of lines of text do not escape names, though a name may look as if they did.
  const wanted = [...new Set([unescaped(reference), reference])].map(parts);
  const lasts = new Set(wanted.map((way) => folded(way.at(-1) ?? '')));
  let best: { path: string; content: T } | null = null;
  let most = 0;
  for (const [path, content] of companions) {
    const there = parts(path);
    if (!lasts.has(folded(there.at(-1) ?? ''))) continue;
    for (const way of wanted) {
      if (way.join('/') === there.join('/')) return { path, content };
      const alike = alikeFromTheEnd(way, there);
      if (alike > most) [best, most] = [{ path, content }, alike];
    }
  }
  return best;
}

/** How many parts of two paths are the same from their ends on; a little more where case is, too. */
function alikeFromTheEnd(a: readonly string[], b: readonly string[]): number {
  let count = 0;
  let exact = 0;
  while (count < Math.min(a.length, b.length)) {
    const [x = '', y = ''] = [a.at(-1 - count), b.at(-1 - count)];
    if (folded(x) !== folded(y)) break;
    if (x === y) exact += 1;
    count += 1;
  }
  return count + (count > 0 && exact === count ? 0.5 : 0);
}

const folded = (name: string): string => name.toLowerCase();

/** Of a path, without steps that lead nowhere. Disks of macOS take letters and their accents apart. */
function parts(path: string): string[] {
  const found: string[] = [];
  for (const part of path.normalize('NFC').split(/[\\/]+/)) {
    if (part === '' || part === '.') continue;
    if (part === '..' && found.length > 0 && found.at(-1) !== '..') found.pop();
    else found.push(part);
  }
  return found;
}

export function unescaped(reference: string): string {
  try {
    return decodeURIComponent(reference);
  } catch {
    // Not an escaped name: taken as it is.
    return reference;
  }
}

/** Not a way to a file; one letter before a colon is a disk of Windows. */
export const isAddress = (reference: string): boolean => /^([a-z][a-z0-9+.-]+:|\/\/)/i.test(reference);

/** As a file system would say it, without escapes, backslashes and leading dots. */
export function pathIn(reference: string): string {
  return unescaped(reference)
    .replace(/\\/g, '/')
    .replace(/^(\.{1,2}\/)+/, '');
}

const mediaTypes: Readonly<Record<string, string>> = {
  png: 'image/png',
  jpg: 'image/jpeg',
  jpeg: 'image/jpeg',
  webp: 'image/webp',
  avif: 'image/avif',
  ktx2: 'image/ktx2',
};

export const UNKNOWN_TYPE = 'application/octet-stream';

/** Of an image file, by its name. */
export const imageType = (file: string): string =>
  mediaTypes[file.replace(/^.*\./, '').toLowerCase()] ?? UNKNOWN_TYPE;
