/** What is made of a whole document or picture to be kept or sent, in a thread of its own. */
import type { Document } from '../../scene/schema.ts';
import type { SentDocument } from '../threads/sent-assets.ts';
import { Thread } from '../threads/thread.ts';
import { documentToSend } from './stored-document.ts';

export type DocumentQuestion =
  | { readonly kind: 'file' | 'link'; readonly document: SentDocument }
  | { readonly kind: 'thumbnail'; readonly image: ImageBitmap };

/** A file, or the text of a link. */
export type DocumentAnswer = Blob | string;

const thread = new Thread<DocumentQuestion, DocumentAnswer>(
  () => new Worker(new URL('./document-worker.ts', import.meta.url), { type: 'module' }),
);

/** The document as a file. */
export async function fileOf(document: Document): Promise<Blob> {
  return thread.ask({ kind: 'file', document: documentToSend(document) }) as Promise<Blob>;
}

/** What follows the page's address, for a document of any size. */
export async function linkOf(document: Document): Promise<string> {
  return thread.ask({ kind: 'link', document: documentToSend(document) }) as Promise<string>;
}

/** A small picture as a file. The picture is gone afterwards. */
export async function thumbnailFile(image: ImageBitmap): Promise<Blob> {
  return thread.ask({ kind: 'thumbnail', image }, [image]) as Promise<Blob>;
}
