import { ByteError } from './bytes.ts';
import { crc32, SIGNATURE } from './png.ts';

export interface PngHeader {
  width: number;
  height: number;
  /** What encodePng() was given to keep. */
  texts: Record<string, string>;
}

/**
 * Reads all but the pixels.
 *
 * @throws ByteError if the file is not a whole PNG: cut off, or a chunk is not what it was when it was written
 */
export function readPngHeader(file: Uint8Array, fileName: string): PngHeader {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (SIGNATURE.some((byte, i) => file[i] !== byte)) throw new ByteError(fileName, 0, 'not a PNG');
  const header: PngHeader = { width: 0, height: 0, texts: {} };
  for (let at = SIGNATURE.length; ; ) {
    if (at + 12 > file.length) throw new ByteError(fileName, at, 'the file ends here; expected a chunk');
    const length = view.getUint32(at);
    const end = at + 8 + length;
    if (end + 4 > file.length) throw new ByteError(fileName, at, 'the file ends within a chunk');
    const type = new TextDecoder().decode(file.subarray(at + 4, at + 8));
    if (crc32(file.subarray(at + 4, end)) !== view.getUint32(end))
      throw new ByteError(fileName, at, `the checksum of chunk ${type} is wrong`);
    if (type === 'IEND') return header;
    if (type === 'IHDR')
      Object.assign(header, { width: view.getUint32(at + 8), height: view.getUint32(at + 12) });
    if (type === 'iTXt') {
      const [keyword = '', ...rest] = new TextDecoder().decode(file.subarray(at + 8, end)).split('\0');
      // Compression's flag and method, the language and the translated keyword are all empty or 0.
      header.texts[keyword] = rest.slice(4).join('\0');
    }
    at = end + 4;
  }
}
