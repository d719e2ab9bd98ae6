/** Files that came together, such as a dropped folder: bytes by path. */
export type Companions = ReadonlyMap<string, Uint8Array>;

/** The file that a reference inside another one means: by its whole path, by the end of it, or by its name alone. */
export function findCompanion(
  companions: Companions,
  reference: string,
): { path: string; bytes: Uint8Array } | null {
  const wanted = pathIn(reference);
  const last = wanted.replace(/^.*\//, '').toLowerCase();
  let sameName: { path: string; bytes: Uint8Array } | null = null;
  for (const [path, bytes] of companions) {
    if (path === wanted || path.endsWith(`/${wanted}`)) return { path, bytes };
    // Exporters write paths of the machine on which they ran, and case that its disk did not care for.
    if (path.replace(/^.*\//, '').toLowerCase() === last) sameName ??= { path, bytes };
  }
  return sameName;
}

/** As a file system would say it, without escapes, backslashes and leading dots. */
export function pathIn(reference: string): string {
  let text = reference;
  try {
    text = decodeURIComponent(reference);
  } catch {
    // Not an escaped name: taken as it is.
  }
  return text.replace(/\\/g, '/').replace(/^(\.{1,2}\/)+/, '');
}

const mediaTypes: Readonly<Record<string, string>> = {
  png: 'image/png',
  jpg: 'image/jpeg',
  jpeg: 'image/jpeg',
  webp: 'image/webp',
  avif: 'image/avif',
  ktx2: 'image/ktx2',
};

/** Of an image file, by its name. */
export const imageType = (file: string): string =>
  mediaTypes[file.replace(/^.*\./, '').toLowerCase()] ?? 'application/octet-stream';
