/** The browser's database, opened once, with promises where its own interface has events. */

const NAME = 'irradia';
const VERSION = 1;

/** What is kept, by store. Owners are documents and versions; both have ids of their own. */
export const stores = {
  /** KeptDocument by id. */
  documents: 'documents',
  /** Version by id. */
  versions: 'versions',
  /** The text of an owner's document, without assets, by the owner's id. */
  texts: 'texts',
  /** What has changed since a document's text was written, by [document, number from 0]. */
  changes: 'changes',
  /** The assets that an owner needs, by the owner's id. */
  uses: 'uses',
  /** The bytes of assets, by their SHA-256. */
  assets: 'assets',
  /** Small pictures, by document. */
  thumbnails: 'thumbnails',
} as const;

export type StoreName = keyof typeof stores;

/** `onLost` is told when the browser has closed it: a person has cleared what pages keep. */
export function openDatabase(onLost: () => void): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, VERSION);
    request.onupgradeneeded = () => {
      const database = request.result;
      database.createObjectStore(stores.documents, { keyPath: 'id' });
      database.createObjectStore(stores.versions, { keyPath: 'id' }).createIndex('document', 'document');
      for (const name of ['texts', 'changes', 'uses', 'assets', 'thumbnails'] as const)
        database.createObjectStore(stores[name]);
    };
    request.onerror = () => reject(ofOpening(request.error));
    request.onsuccess = () => {
      // A newer page in another tab may need to change the stores; this one then has to be reloaded.
      request.result.onversionchange = () => request.result.close();
      request.result.onclose = onLost;
      resolve(request.result);
    };
  });
}

/** Firefox's private windows say that the state is invalid, as a database does that a newer page has closed: this is not that. */
const ofOpening = (error: DOMException | null): DOMException | null =>
  error?.name === 'InvalidStateError' ? new DOMException(error.message, 'NotSupportedError') : error;

export function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/** Resolves once everything that the transaction wrote will be there after a crash of the page. */
export function completed(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    const fail = () => reject(transaction.error ?? new DOMException('The write was ended.', 'AbortError'));
    transaction.onabort = fail;
    transaction.onerror = fail;
  });
}
