/**
 * A document as the browser keeps it: assets are named by the SHA-256 of their bytes, which are kept once,
 * whatever number of documents and versions use them.
 */
import { decodeBase64 } from '../../scene/base64.ts';
import { parseDocument } from '../../scene/document.ts';
import type { Asset, Document } from '../../scene/schema.ts';
import { trustAsset } from '../../scene/validate.ts';
import { t } from '../language/language.ts';
import type { SentAsset, SentDocument } from '../threads/sent-assets.ts';
import { sha256Of } from '../threads/sha256.ts';

export interface StoredAsset {
  readonly name: string;
  readonly mediaType: string;
  readonly sha256: string;
}

export type StoredDocument = Omit<Document, 'assets'> & {
  readonly assets: Readonly<Record<string, StoredAsset>>;
};

/** An asset's bytes and what they are called. */
export interface HashedAsset {
  readonly stored: StoredAsset;
  readonly blob: Blob;
}

/** Assets never change; what was once taken apart is remembered for as long as its asset is. */
const hashed = new WeakMap<Asset, HashedAsset>();
const underWay = new WeakMap<Asset, Promise<HashedAsset>>();
const takenApart = new WeakMap<Document['assets'], StoredDocument['assets']>();

/** Whether takeApart() can be called: what an event that ends the page has no time to wait for. */
export function isHashed(document: Document): boolean {
  return Object.values(document.assets).every((asset) => hashed.has(asset));
}

/** What is known of a new asset's bytes already. */
export function rememberBytes(asset: Asset, sha256: string, blob: Blob): void {
  const { name, mediaType } = asset;
  hashed.set(asset, { stored: { name, mediaType, sha256 }, blob });
}

/** For another thread: whatever has been hashed as a Blob, which costs nothing. */
export function toSend(asset: Asset): SentAsset {
  return { ...asset, data: hashed.get(asset)?.blob ?? asset.data };
}

export function documentToSend(document: Document): SentDocument {
  const assets = Object.entries(document.assets).map(([id, asset]) => [id, toSend(asset)] as const);
  return { ...document, assets: Object.fromEntries(assets) };
}

/** Asks the browser, which does both off this thread, for the bytes and the hash of every new asset. */
export async function hashAssets(document: Document): Promise<void> {
  for (const asset of Object.values(document.assets)) {
    if (hashed.has(asset)) continue;
    const started = underWay.get(asset) ?? hashAsset(asset);
    underWay.set(asset, started);
    hashed.set(asset, await started);
  }
}

async function hashAsset({ name, mediaType, data }: Asset): Promise<HashedAsset> {
  const bytes = await bytesOfBase64(data);
  return { stored: { name, mediaType, sha256: await sha256Of(bytes) }, blob: new Blob([bytes]) };
}

/** Of the two ways that do not run through the text character by character, the newer one is ten times as fast. */
async function bytesOfBase64(data: string): Promise<BufferSource & BlobPart> {
  if ('fromBase64' in Uint8Array) return decodeBase64(data);
  return (await fetch(`data:application/octet-stream;base64,${data}`)).arrayBuffer();
}

/** The document with names in place of bytes. All its assets have to be hashed. */
export function takeApart(document: Document): StoredDocument {
  const known = takenApart.get(document.assets);
  if (known) return { ...document, assets: known };
  const assets = Object.fromEntries(
    Object.entries(document.assets).map(([id, asset]) => [id, hashedAsset(asset).stored]),
  );
  takenApart.set(document.assets, assets);
  return { ...document, assets };
}

/** The bytes that a document needs, by hash: many assets may have the same. */
export function bytesOf(document: Document): Map<string, Blob> {
  return new Map(
    Object.values(document.assets).map((asset) => {
      const { stored, blob } = hashedAsset(asset);
      return [stored.sha256, blob];
    }),
  );
}

function hashedAsset(asset: Asset): HashedAsset {
  const found = hashed.get(asset);
  if (!found) throw new Error(`${asset.name} has not been hashed yet.`);
  return found;
}

/** The reverse. Whatever was kept, even by an older version of the page, is validated as a file would be. */
export async function putTogether(
  json: Record<string, unknown>,
  fileName: string,
  bytesFor: (sha256: string) => Promise<Blob | undefined>,
): Promise<Document> {
  const blobs = new Map<string, HashedAsset>();
  const texts: Record<string, Asset> = {};
  for (const [id, stored] of Object.entries((json.assets ?? {}) as StoredDocument['assets'])) {
    const blob = await bytesFor(stored.sha256);
    if (!blob)
      throw new Error(
        t('{fileName}: the bytes of {name} are no longer in this browser.', { fileName, name: stored.name }),
      );
    blobs.set(id, { stored, blob });
    texts[id] = { name: stored.name, mediaType: stored.mediaType, data: await base64Of(blob) };
  }
  const parsed = parseDocument({ ...json, assets: withoutText(texts, json) }, fileName);
  const document = { ...parsed, assets: { ...parsed.assets } };
  for (const [id, asset] of Object.entries(parsed.assets)) {
    const whole = { ...asset, data: texts[id]?.data ?? '' };
    trustAsset(whole);
    document.assets[id] = whole;
    const known = blobs.get(id);
    if (known) hashed.set(whole, known);
  }
  return document;
}

/** Base64 that the browser has just made of bytes is base64: only what a model is read from has to be there. */
function withoutText(
  texts: Readonly<Record<string, Asset>>,
  { models }: Record<string, unknown>,
): Record<string, Asset> {
  const read = new Set(
    Object.values(models ?? {}).map((model: Partial<{ measured: string }> | null) => model?.measured),
  );
  return Object.fromEntries(
    Object.entries(texts).map(([id, asset]) => [id, read.has(id) ? asset : { ...asset, data: '' }]),
  );
}

/** Bytes that become text within a few milliseconds; a multiple of 3, so that only the last part is padded. */
const PART = 3 * 1024 * 1024;

async function base64Of(blob: Blob): Promise<string> {
  const parts: string[] = [];
  for (let at = 0; at < blob.size; at += PART) parts.push(await base64OfPart(blob.slice(at, at + PART)));
  return parts.join('');
}

/** The browser encodes base64 off this thread and fast. */
function base64OfPart(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => {
      const url = String(reader.result);
      resolve(url.slice(url.indexOf(',') + 1));
    };
    reader.onerror = () => reject(reader.error ?? new Error(t('The browser could not read the file.')));
    reader.readAsDataURL(blob);
  });
}
