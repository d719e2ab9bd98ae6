/** A file from an address, with the files that it refers to beside it. */
import { pathIn, unescaped } from '../../../io/meshes/companions.ts';
import { ModelFileError } from '../../../io/meshes/error.ts';
import { referencesOf } from '../../../io/meshes/references.ts';
import type { Progress } from './jobs.ts';

const MOST_BYTES = 512 * 1024 * 1024;
const MOST_PARTS = 500;

interface Fetched {
  path: string;
  bytes: Uint8Array<ArrayBuffer>;
}

/** The file itself comes first. @throws ModelFileError naming the address */
export async function fetchFiles(address: string, progress: Progress): Promise<Fetched[]> {
  const url = new URL(address);
  if (!/^https?:$/.test(url.protocol))
    throw new ModelFileError(address.slice(0, 200), '', 'only http and https addresses are fetched');
  const bytes = await fetchBytes(url, progress);
  const name = nameOf(url) || 'file';
  const path = /\.[a-z]\w{1,7}$/i.test(name) ? name : `${name}${endingOf(bytes)}`;
  const main = { path, bytes };
  const parts: Fetched[] = [];
  // What a .obj file names may name more, as materials name textures.
  let references = referencesOf(main.path, main.bytes);
  const known = new Set([path]);
  while (references.length > 0) {
    const wanted = references.filter((reference) => !known.has(reference));
    references = [];
    for (const reference of wanted) {
      known.add(reference);
      if (known.size > MOST_PARTS)
        throw new ModelFileError(path, '', `it refers to more than ${MOST_PARTS} files`);
      const target = new URL(reference, url);
      // Beside the file, so that a file cannot make the page ask other servers.
      if (target.origin !== url.origin) continue;
      // What is missing the import will tell: it knows what it cannot do without.
      const bytes = await fetchBytes(target, progress).catch(() => null);
      if (bytes === null) continue;
      const part = { path: pathIn(reference), bytes };
      parts.push(part);
      references.push(...referencesOf(part.path, part.bytes));
    }
  }
  return [main, ...parts];
}

const nameOf = ({ pathname }: URL): string => unescaped(pathname).replace(/^.*\//, '');

/** How files begin whose address does not say what they are, as those of downloads often do not. */
const beginnings: Readonly<Record<string, string>> = {
  glTF: '.glb',
  'PK\u0003\u0004': '.zip',
  '#?': '.hdr',
  'v/1\u0001': '.exr',
  '{': '.json',
  ply: '.ply',
};

function endingOf(bytes: Uint8Array): string {
  const begin = String.fromCharCode(...bytes.subarray(0, 4));
  return Object.entries(beginnings).find(([letters]) => begin.startsWith(letters))?.[1] ?? '';
}

async function fetchBytes(url: URL, progress: Progress): Promise<Uint8Array<ArrayBuffer>> {
  const name = nameOf(url) || url.host;
  const fail = (message: string, cause?: unknown): never => {
    throw new ModelFileError(url.href.slice(0, 300), '', message, { cause });
  };
  progress(`Fetching ${name}`, null);
  const response = await fetch(url, { credentials: 'omit', referrerPolicy: 'no-referrer' }).catch((cause) =>
    fail(
      'it could not be fetched: no connection, or the server does not let other pages have it (CORS)',
      cause,
    ),
  );
  if (!response.ok || response.body === null)
    return fail(`the server answered ${response.status} ${response.statusText}`);
  const size = Number(response.headers.get('content-length')) || 0;
  const parts: Uint8Array[] = [];
  let length = 0;
  const reader = response.body.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    length += part.value.length;
    if (length > MOST_BYTES) {
      await reader.cancel();
      fail(`more than ${MOST_BYTES} bytes`);
    }
    parts.push(part.value);
    progress(`Fetching ${name}`, size >= length ? length / size : null);
  }
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}
