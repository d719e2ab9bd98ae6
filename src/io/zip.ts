/** The files of a zip archive, within bounds: an archive of a few bytes can claim to hold terabytes. */
import { unzipSync } from 'fflate';
import { ModelFileError } from './meshes/error.ts';

const MOST_FILES = 2000;
const MOST_BYTES = 1024 * 1024 * 1024;

export const isZip = (name: string): boolean => /\.zip$/i.test(name);

/** By path. @throws ModelFileError */
export function readZip(bytes: Uint8Array, file: string): Map<string, Uint8Array> {
  let count = 0;
  let size = 0;
  const files = new Map<string, Uint8Array>();
  const fail = (message: string, cause?: unknown): never => {
    throw new ModelFileError(file, '', message, { cause });
  };
  let entries: Record<string, Uint8Array>;
  try {
    entries = unzipSync(bytes, {
      filter({ name, originalSize }) {
        // What macOS and file managers add.
        if (name.endsWith('/') || /(^|\/)(__MACOSX\/|\._|\.DS_Store$|Thumbs\.db$)/.test(name)) return false;
        count += 1;
        size += originalSize;
        if (count > MOST_FILES) fail(`more than ${MOST_FILES} files`);
        if (size > MOST_BYTES) fail(`its files take more than ${MOST_BYTES} bytes`);
        return true;
      },
    });
  } catch (cause) {
    if (cause instanceof ModelFileError) throw cause;
    return fail(
      `not a zip archive that can be read: ${cause instanceof Error ? cause.message : cause}`,
      cause,
    );
  }
  for (const [path, content] of Object.entries(entries)) files.set(path.replace(/\\/g, '/'), content);
  if (files.size === 0) fail('there are no files in it');
  return files;
}
