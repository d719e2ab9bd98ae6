import { existsSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir, userInfo } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { brotliDecompressSync } from 'node:zlib';

/**
 * SwiftShader, a Vulkan driver that runs on the CPU, out of the npm package @sparticuz/chromium: the one
 * place where the npm registry has it. The same archive holds the Vulkan loader, which a machine
 * without a GPU often lacks.
 */
export interface SwiftShader {
  /** The Vulkan loader, libvulkan.so.1. */
  loader: string;
  /** The file that tells the loader where the driver is. */
  icd: string;
}

const WANTED = ['libvk_swiftshader.so', 'libvulkan.so.1', 'vk_swiftshader_icd.json'];

/** Folder of the package @sparticuz/chromium; throws when it is not installed. */
export function chromiumPackage(): string {
  let folder = dirname(createRequire(import.meta.url).resolve('@sparticuz/chromium'));
  while (!existsSync(join(folder, 'bin'))) folder = dirname(folder);
  return folder;
}

/** Unpacks SwiftShader, once per version of the package, and says where it is. */
export function unpackSwiftShader(): SwiftShader {
  const source = chromiumPackage();
  const { version } = JSON.parse(readFileSync(join(source, 'package.json'), 'utf8')) as { version: string };
  return unpackOnce(`swiftshader-${version}`, (folder) => {
    const archive = brotliDecompressSync(readFileSync(join(source, 'bin/swiftshader.tar.br')));
    for (const { name, data } of tarFiles(archive)) {
      if (WANTED.includes(basename(name))) writeFileSync(join(folder, basename(name)), data, { mode: 0o755 });
    }
  });
}

function unpackOnce(name: string, unpack: (folder: string) => void): SwiftShader {
  // The user's name keeps one user's process from loading a driver that another user put there.
  const place = join(tmpdir(), `irradia-${userInfo().username}`, name);
  if (!existsSync(place)) {
    mkdirSync(dirname(place), { recursive: true, mode: 0o700 });
    const fresh = mkdtempSync(`${place}-`);
    unpack(fresh);
    try {
      // Renaming a folder is atomic: of several processes that unpack at once, the first one wins.
      renameSync(fresh, place);
    } catch (error) {
      rmSync(fresh, { recursive: true });
      if (!existsSync(place)) throw error;
    }
  }
  return { loader: join(place, 'libvulkan.so.1'), icd: join(place, 'vk_swiftshader_icd.json') };
}

/** Files of a tar archive: 512-byte headers (name at 0, size in octal at 124, type at 156) and padded data. */
function* tarFiles(archive: Buffer): Generator<{ name: string; data: Buffer }> {
  const text = (start: number, end: number) => archive.toString('latin1', start, end).replace(/\0.*$/s, '');
  for (let at = 0; at + 512 <= archive.length && archive[at] !== 0; ) {
    const size = Number.parseInt(text(at + 124, at + 136), 8);
    const type = text(at + 156, at + 157);
    const data = archive.subarray(at + 512, at + 512 + size);
    if (type === '0' || type === '') yield { name: text(at, at + 100), data };
    at += 512 + Math.ceil(size / 512) * 512;
  }
}
