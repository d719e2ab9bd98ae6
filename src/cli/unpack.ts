import { existsSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir, userInfo } from 'node:os';
import { dirname, join } from 'node:path';
import { brotliDecompressSync } from 'node:zlib';

/** The npm package @sparticuz/chromium: its folder with archives, and its version. */
export function chromiumPackage(): { archives: string; version: string } {
  let folder = dirname(createRequire(import.meta.url).resolve('@sparticuz/chromium'));
  while (!existsSync(join(folder, 'bin'))) folder = dirname(folder);
  const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as { version: string };
  return { archives: join(folder, 'bin'), version };
}

/** A folder under the system's temporary one, filled by the first process that asks for that name. */
export function unpackOnce(name: string, fill: (folder: string) => void): string {
  // The user's name keeps one user's process from loading a program that another user put there.
  const place = join(tmpdir(), `irradia-${userInfo().username}`, name);
  if (existsSync(place)) return place;
  mkdirSync(dirname(place), { recursive: true, mode: 0o700 });
  const fresh = mkdtempSync(`${place}-`);
  try {
    fill(fresh);
    // Renaming a folder is atomic: of several processes that unpack at once, the first one wins.
    renameSync(fresh, place);
  } catch (error) {
    rmSync(fresh, { recursive: true, force: true });
    if (!existsSync(place)) throw error;
  }
  return place;
}

export function readBrotli(file: string): Buffer {
  return brotliDecompressSync(readFileSync(file));
}

/** Writes an archive's files: 512-byte headers (name at 0, size in octal at 124, type at 156), padded data. */
export function unpackTar(
  archive: Buffer,
  folder: string,
  wanted: (name: string) => boolean = () => true,
): void {
  const text = (start: number, end: number) => archive.toString('latin1', start, end).replace(/\0.*$/s, '');
  for (let at = 0; at + 512 <= archive.length && archive[at] !== 0; ) {
    const name = text(at, at + 100);
    const size = Number.parseInt(text(at + 124, at + 136), 8);
    const isFile = text(at + 156, at + 157) === '0';
    if (isFile && wanted(name)) {
      const path = join(folder, name);
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, archive.subarray(at + 512, at + 512 + size), { mode: 0o755 });
    }
    at += 512 + Math.ceil(size / 512) * 512;
  }
}
