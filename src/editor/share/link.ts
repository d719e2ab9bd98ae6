/**
 * A whole document in the fragment of an address, which browsers never send to a server: its JSON without
 * defaults, deflated, as base64url. A link may come from anybody: what it holds is bounded while it is
 * unpacked, and then validated as a file would be.
 */
import { parseDocument } from '../../scene/document.ts';
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import { PREFIX } from './link-text.ts';

/**
 * Characters of an address with its link. The narrowest place on a link's way is the address bar: Chromium's
 * shows and takes 32 KiB (kMaxURLDisplayChars), Firefox's 64 Ki characters; Slack's messages have 40,000.
 */
export const MAX_ADDRESS = 32 * 1024;

/**
 * Characters of the JSON behind a link. Deflate packs a thousandfold at best, so that a hostile link of that
 * length holds 25 MB; documents pack five- to twentyfold.
 */
export const MAX_TEXT = 4 * 1024 * 1024;

/** Bytes that become a megabyte at most. */
const SLICE = 1024;

export function isLink(fragment: string): boolean {
  return fragment.startsWith(PREFIX);
}

/** Throws an Error that says what is wrong with the link. */
export async function documentOfLink(fragment: string): Promise<Document> {
  const text = await inflated(decodeBase64Url(fragment.slice(PREFIX.length)));
  return parseDocument(text, 'link');
}

const damaged = (cause?: unknown) =>
  new Error(t('The link is damaged: a part of it may have been cut off where it was copied.'), { cause });

async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const stream = inSlices(bytes).pipeThrough(new DecompressionStream('deflate-raw'));
  const reader = stream.getReader();
  const decoder = new TextDecoder('utf-8', { fatal: true });
  let text = '';
  try {
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      text += decoder.decode(part.value, { stream: true });
      if (text.length > MAX_TEXT) break;
    }
    if (text.length <= MAX_TEXT) return text + decoder.decode();
  } catch (error) {
    throw damaged(error);
  }
  // Ends the unpacking, however much more there would be.
  await reader.cancel();
  throw new Error(
    t('The link holds more than {value} MB, which no shared scene needs.', { value: MAX_TEXT / 1024 / 1024 }),
  );
}

/** Whatever is put into the browser's unpacking comes out whole, so little at a time is put in. */
function inSlices(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at >= bytes.length) controller.close();
      else controller.enqueue(bytes.subarray(at, at + SLICE));
      at += SLICE;
    },
  });
}

function decodeBase64Url(text: string): Uint8Array<ArrayBuffer> {
  // Some programs percent-encode what they send, some put a line break into what is long.
  const plain = text.replace(/%3D|=|\s|%0A|%20/gi, '');
  if (!/^[A-Za-z0-9_-]*$/.test(plain)) throw damaged();
  try {
    const binary = atob(plain.replace(/-/g, '+').replace(/_/g, '/'));
    return Uint8Array.from(binary, (character) => character.charCodeAt(0));
  } catch (error) {
    throw damaged(error);
  }
}
