/** Base64 for assets: whole files, so without a call per byte and without a big argument list. */

/** What newer engines have (ECMAScript 2026), some ten times as fast. */
interface NativeBase64 {
  fromBase64?(text: string): Uint8Array<ArrayBuffer>;
}
const native = Uint8Array as unknown as NativeBase64;
const toBase64 = (Uint8Array.prototype as { toBase64?(): string }).toBase64;

const chunkSize = 0x8000;

export function encodeBase64(bytes: Uint8Array): string {
  if (toBase64) return toBase64.call(bytes);
  const chunks: string[] = [];
  // A multiple of three bytes per chunk, so that only the last one is padded.
  const step = chunkSize - (chunkSize % 3);
  for (let at = 0; at < bytes.length; at += step)
    chunks.push(btoa(String.fromCharCode(...bytes.subarray(at, at + step))));
  return chunks.join('');
}

export function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  if (native.fromBase64) return native.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i += 1) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** The bytes of a `data:` URL, or null if it is none that can be read. */
export function decodeDataUrl(url: string): { mediaType: string; bytes: Uint8Array<ArrayBuffer> } | null {
  const comma = url.indexOf(',');
  if (!url.startsWith('data:') || comma < 0) return null;
  const [mediaType = '', ...options] = url.slice('data:'.length, comma).split(';');
  const body = url.slice(comma + 1);
  try {
    const bytes = options.includes('base64')
      ? decodeBase64(body)
      : new TextEncoder().encode(decodeURIComponent(body));
    return { mediaType, bytes };
  } catch {
    return null;
  }
}
