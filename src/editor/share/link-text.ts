/** A document as the text of a link: its JSON without defaults, deflated, as base64url. */
import { encodeBase64 } from '../../scene/base64.ts';
import { compactDocument } from '../../scene/compact.ts';
import type { Document } from '../../scene/schema.ts';

export const PREFIX = '#document=';

/** What follows the page's address, for a document of any size. */
export async function linkFor(document: Document): Promise<string> {
  const text = JSON.stringify(compactDocument(document));
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return `${PREFIX}${encodeBase64(bytes).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '')}`;
}
