/**
 * Documents on their way to another thread. A message is copied while the page waits; bytes that the page has as a Blob
 * are not: they stay where they are until they are read.
 */
import { encodeBase64 } from '../../scene/base64.ts';
import type { Asset, Document } from '../../scene/schema.ts';

export type SentAsset = Omit<Asset, 'data'> & { readonly data: string | Blob };

export type SentDocument = Omit<Document, 'assets'> & {
  readonly assets: Readonly<Record<string, SentAsset>>;
};

export async function receivedAsset({ data, ...asset }: SentAsset): Promise<Asset> {
  return {
    ...asset,
    data: typeof data === 'string' ? data : encodeBase64(new Uint8Array(await data.arrayBuffer())),
  };
}

export async function receivedDocument(document: SentDocument): Promise<Document> {
  const assets: Record<string, Asset> = {};
  for (const [id, asset] of Object.entries(document.assets)) assets[id] = await receivedAsset(asset);
  return { ...document, assets };
}
