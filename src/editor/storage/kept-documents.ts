/**
 * The documents that this browser keeps, with their versions. A document is a text and the changes made
 * since: an edit writes what it touched. When the changes have outgrown the text, a new text is written, so
 * that all writing together stays in proportion to the edits.
 */
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import { applyChange, type Change, changeBetween } from './changes.ts';
import { Connection } from './connection.ts';
import { completed, result, type StoreName } from './database.ts';
import { bytesOf, hashAssets, putTogether, takeApart } from './stored-document.ts';

export interface KeptDocument {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970, here and below. */
  readonly created: number;
  readonly modified: number;
  /** Characters of the text, and of the changes since. */
  readonly textSize: number;
  readonly changesSize: number;
  readonly changes: number;
  /** Bytes of its assets, which other documents may share. */
  readonly assetsSize: number;
  /** What followed the page's address when the document was opened: `?scene=thesis`. Null for a file or a new scene. */
  readonly address: string | null;
  /** Where Save writes, in browsers that let a page write files. */
  readonly file?: FileSystemFileHandle;
  /** When it was deleted; what can no longer be undone is purged. */
  readonly deleted?: number;
}

export interface Version {
  readonly id: string;
  readonly document: string;
  /** Null for those that were kept without being asked for. */
  readonly name: string | null;
  readonly time: number;
}

/** Automatic versions of one document that are kept: over three hours of work, ten minutes apart. */
export const MOST_AUTOMATIC_VERSIONS = 20;
/** Below this a new text is not worth writing: loading applies the changes in no time. */
const LEAST_TO_MERGE = 64 * 1024;
/** What was deleted in a page that is gone is purged by another one, after as long as an offer to undo may stay. */
const UNDO_MS = 60 * 60_000;
const LONGEST_ADDRESS = 300;

export class KeptDocuments {
  readonly #connection: Connection;
  /** Told when all that was kept may have been cleared, once there is room for it again. */
  onCleared: () => void = () => {};
  /** Told when a document was loaded that is not as it was kept last, but as it was some time before that. */
  onDamaged: (name: string, fault: unknown) => void = () => {};

  private constructor(connection: Connection) {
    this.#connection = connection;
    connection.onOpenedAgain = () => this.onCleared();
  }

  /** Rejects where the browser keeps nothing: in some private windows, or when storage is forbidden. */
  static async open(): Promise<KeptDocuments> {
    // Hashes are only to be had where the page cannot have been tampered with on its way.
    if (!crypto.subtle) throw new Error(t('The page was not loaded over https.'));
    return new KeptDocuments(await Connection.open());
  }

  /** The last changed first. */
  async list(): Promise<KeptDocument[]> {
    const documents: KeptDocument[] = await this.#all('documents');
    return documents.filter(({ deleted }) => deleted === undefined).sort((a, b) => b.modified - a.modified);
  }

  async find(id: string): Promise<KeptDocument | undefined> {
    const found = await result<KeptDocument | undefined>(this.#read('documents').get(id));
    return found?.deleted === undefined ? found : undefined;
  }

  /** The last named or kept first. */
  async versions(id: string): Promise<Version[]> {
    const versions: Version[] = await result(this.#read('versions').index('document').getAll(id));
    return versions.sort((a, b) => b.time - a.time);
  }

  /** The document, and what it is to be kept as from now on. */
  async load(kept: KeptDocument): Promise<{ document: Document; kept: KeptDocument }> {
    const changes: string[] = await result(this.#read('changes').getAll(rangeOf(kept.id)));
    try {
      return { document: await this.#readText(kept.id, kept.name, changes), kept };
    } catch (fault) {
      const document = await this.#readEarlier(kept, changes.length > 0);
      if (!document) throw fault;
      this.onDamaged(kept.name, fault);
      // The next write makes it whole again: as changes that have outgrown their text.
      return { document, kept: { ...kept, changesSize: Number.POSITIVE_INFINITY } };
    }
  }

  /** The text without its changes, or the youngest version: what a damaged record has left of a document. */
  async #readEarlier(kept: KeptDocument, hasChanges: boolean): Promise<Document | null> {
    const earlier = (await this.versions(kept.id)).map((version) => () => this.loadVersion(version));
    if (hasChanges) earlier.unshift(() => this.#readText(kept.id, kept.name, []));
    for (const read of earlier) {
      const document = await read().catch(() => null);
      if (document) return document;
    }
    return null;
  }

  loadVersion({ id, name }: Version): Promise<Document> {
    return this.#readText(id, name ?? 'version', []);
  }

  async #readText(owner: string, name: string, changes: readonly string[]): Promise<Document> {
    const text: string | undefined = await result(this.#read('texts').get(owner));
    if (text === undefined) throw new Error(t('“{name}” is no longer in this browser.', { name }));
    let json: Record<string, unknown> = JSON.parse(text);
    for (const change of changes) json = applyChange(json, JSON.parse(change) as Change);
    return putTogether(json, name, (sha256) => result(this.#read('assets').get(sha256)));
  }

  /**
   * Writes a document whose assets are hashed already. All of it is asked of the database before this
   * returns, which makes it safe to call while the page is being left. `before` is what was written last;
   * null writes all of it. Not `atOnce`: the page must stay until it is `done`, or the write is taken back.
   */
  write(
    kept: KeptDocument,
    document: Document,
    before: Document | null,
  ): { kept: KeptDocument; done: Promise<void>; atOnce: boolean } {
    const stored = takeApart(document);
    const change = before && changeBetween(takeApart(before), stored);
    const changeText = change ? JSON.stringify(change) : '';
    const merge =
      before === null || kept.changesSize + changeText.length > Math.max(LEAST_TO_MERGE, kept.textSize);
    const sameAssets = before !== null && takeApart(before).assets === stored.assets;
    const bytes = sameAssets ? null : bytesOf(document);
    const names: StoreName[] = ['documents', 'changes'];
    if (merge) names.push('texts');
    if (bytes) names.push('uses', 'assets');
    const transaction = this.#connection.database.transaction(names, 'readwrite');

    let next: KeptDocument = { ...kept, name: document.name, modified: Date.now() };
    if (merge) {
      const text = JSON.stringify(stored);
      transaction.objectStore('texts').put(text, kept.id);
      // Also where none are known of: a write that failed may have left some.
      transaction.objectStore('changes').delete(rangeOf(kept.id));
      next = { ...next, textSize: text.length, changes: 0, changesSize: 0 };
    } else if (change) {
      transaction.objectStore('changes').put(changeText, [kept.id, kept.changes]);
      next = { ...next, changes: kept.changes + 1, changesSize: kept.changesSize + changeText.length };
    }
    if (bytes) {
      next = { ...next, assetsSize: [...bytes.values()].reduce((sum, blob) => sum + blob.size, 0) };
      putAssets(transaction, kept.id, bytes);
    }
    transaction.objectStore('documents').put(next);
    const done = completed(transaction);
    // Otherwise a page that ends now would take the write back. Assets still wait for an answer.
    const atOnce = !bytes?.size;
    if (atOnce) transaction.commit();
    return { kept: next, done, atOnce };
  }

  /** Without a name it is one of the automatic versions, of which the oldest make way. */
  async addVersion(documentId: string, document: Document, name: string | null): Promise<Version> {
    const version: Version = { id: crypto.randomUUID(), document: documentId, name, time: Date.now() };
    await this.putVersion(version, document);
    const automatic = (await this.versions(documentId)).filter((other) => other.name === null);
    for (const old of automatic.slice(MOST_AUTOMATIC_VERSIONS)) await this.deleteVersion(old);
    return version;
  }

  /** A version with its document: a new one, or one that was deleted. */
  async putVersion(version: Version, document: Document): Promise<void> {
    await hashAssets(document);
    const transaction = this.#connection.database.transaction(
      ['versions', 'texts', 'uses', 'assets'],
      'readwrite',
    );
    transaction.objectStore('versions').put(version);
    transaction.objectStore('texts').put(JSON.stringify(takeApart(document)), version.id);
    putAssets(transaction, version.id, bytesOf(document));
    await completed(transaction);
  }

  async deleteVersion({ id }: Version): Promise<void> {
    const transaction = this.#connection.database.transaction(
      ['versions', 'texts', 'uses', 'assets'],
      'readwrite',
    );
    transaction.objectStore('versions').delete(id);
    for (const name of ['texts', 'uses'] as const) transaction.objectStore(name).delete(id);
    dropUnusedAssets(transaction);
    await completed(transaction);
  }

  async duplicate(kept: KeptDocument, name: string): Promise<KeptDocument> {
    const document = { ...(await this.load(kept)).document, name };
    const copy = newlyKept(document, null);
    const { kept: written, done } = this.write(copy, document, null);
    await done;
    const thumbnail = await this.thumbnail(kept.id);
    if (thumbnail) await this.setThumbnail(written.id, thumbnail);
    return written;
  }

  /** Of one that no page has open; the open one is renamed by an edit. */
  async rename({ id }: KeptDocument, name: string): Promise<void> {
    const change: Change = { singles: { name } };
    const text = JSON.stringify(change);
    const transaction = this.#connection.database.transaction(['documents', 'changes'], 'readwrite');
    // As it is now: what the list shows may be older.
    changeRecord(transaction, id, (kept) => {
      transaction.objectStore('changes').put(text, [id, kept.changes]);
      const [changes, changesSize] = [kept.changes + 1, kept.changesSize + text.length];
      return { ...kept, name, modified: Date.now(), changes, changesSize };
    });
    await completed(transaction);
  }

  /** Out of the list; `false` brings it back, until it is purged. */
  async setDeleted({ id }: KeptDocument, deleted: boolean): Promise<void> {
    const transaction = this.#connection.database.transaction('documents', 'readwrite');
    changeRecord(transaction, id, ({ deleted: _, ...kept }) =>
      deleted ? { ...kept, deleted: Date.now() } : kept,
    );
    await completed(transaction);
  }

  /** Gives back the room of what was deleted: of one document at once, of all others when it is too late to undo. */
  async purge(id?: string): Promise<void> {
    const documents: KeptDocument[] = await this.#all('documents');
    const gone = documents.filter(
      (kept) =>
        kept.deleted !== undefined &&
        (kept.id === id || (id === undefined && kept.deleted < Date.now() - UNDO_MS)),
    );
    for (const kept of gone) {
      const versions = await this.versions(kept.id);
      const transaction = this.#connection.database.transaction(
        ['documents', 'versions', 'texts', 'changes', 'uses', 'assets', 'thumbnails'],
        'readwrite',
      );
      for (const owner of [kept.id, ...versions.map((version) => version.id)])
        for (const name of ['documents', 'versions', 'texts', 'uses', 'thumbnails'] as const)
          transaction.objectStore(name).delete(owner);
      transaction.objectStore('changes').delete(rangeOf(kept.id));
      dropUnusedAssets(transaction);
      await completed(transaction);
    }
    // Also what documents have lost by edits: undo may have needed it until now.
    const transaction = this.#connection.database.transaction(['uses', 'assets'], 'readwrite');
    dropUnusedAssets(transaction);
    await completed(transaction);
  }

  thumbnail(id: string): Promise<Blob | undefined> {
    return result(this.#read('thumbnails').get(id));
  }

  async setThumbnail(id: string, picture: Blob): Promise<void> {
    const transaction = this.#connection.database.transaction('thumbnails', 'readwrite');
    transaction.objectStore('thumbnails').put(picture, id);
    await completed(transaction);
  }

  #read(name: StoreName): IDBObjectStore {
    return this.#connection.database.transaction(name).objectStore(name);
  }

  #all<T>(name: StoreName): Promise<T[]> {
    return result(this.#read(name).getAll());
  }
}

export function newlyKept(document: Document, address: string | null): KeptDocument {
  const now = Date.now();
  return {
    id: crypto.randomUUID(),
    name: document.name,
    created: now,
    modified: now,
    textSize: 0,
    changesSize: 0,
    changes: 0,
    assetsSize: 0,
    // A link is as long as its document, and would be written with every change.
    address: address !== null && address.length <= LONGEST_ADDRESS ? address : null,
  };
}

function changeRecord(
  transaction: IDBTransaction,
  id: string,
  change: (kept: KeptDocument) => KeptDocument,
): void {
  const documents = transaction.objectStore('documents');
  const request: IDBRequest<KeptDocument | undefined> = documents.get(id);
  request.onsuccess = () => {
    if (request.result) documents.put(change(request.result));
  };
}

/** The keys [id, 0], [id, 1], ...: an array sorts behind every number. */
function rangeOf(id: string): IDBKeyRange {
  return IDBKeyRange.bound([id], [id, []]);
}

/** Bytes that are there already are not written again. */
function putAssets(transaction: IDBTransaction, owner: string, bytes: ReadonlyMap<string, Blob>): void {
  transaction.objectStore('uses').put([...bytes.keys()], owner);
  const assets = transaction.objectStore('assets');
  for (const [sha256, blob] of bytes) {
    const request = assets.getKey(sha256);
    request.onsuccess = () => {
      if (request.result === undefined) assets.put(blob, sha256);
    };
  }
}

/** One transaction over all uses and assets: no other page can be about to use what goes. */
function dropUnusedAssets(transaction: IDBTransaction): void {
  const uses: IDBRequest<string[][]> = transaction.objectStore('uses').getAll();
  uses.onsuccess = () => {
    const used = new Set(uses.result.flat());
    const assets = transaction.objectStore('assets');
    const keys = assets.getAllKeys();
    keys.onsuccess = () => {
      for (const key of keys.result) if (!used.has(String(key))) assets.delete(key);
    };
  };
}
