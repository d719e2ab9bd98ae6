/**
 * A person's own materials, and small pictures of materials that were made before. They have a database of their own:
 * documents do without it, and pictures can be made anew.
 */
import { completed, result } from './database.ts';

export interface OwnEntry {
  readonly id: string;
  readonly title: string;
  /** A material's file, as io/material-file.ts writes it. */
  readonly file: string;
  /** Milliseconds since 1970. */
  readonly added: number;
}

type Picture = Uint8ClampedArray<ArrayBuffer>;

const NAME = 'irradia-materials';
const stores = { entries: 'entries', pictures: 'pictures' } as const;

export class KeptMaterials {
  readonly #database: IDBDatabase;

  private constructor(database: IDBDatabase) {
    this.#database = database;
  }

  /** Rejects where the browser keeps nothing. */
  static async open(): Promise<KeptMaterials> {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore(stores.entries, { keyPath: 'id' });
      request.result.createObjectStore(stores.pictures);
    };
    const database = await result(request);
    database.onversionchange = () => database.close();
    return new KeptMaterials(database);
  }

  /** The newest first. */
  async entries(): Promise<OwnEntry[]> {
    const all = await result<OwnEntry[]>(this.#read(stores.entries).getAll());
    return all.sort((a, b) => b.added - a.added);
  }

  async add(title: string, file: string): Promise<OwnEntry> {
    const entry = { id: crypto.randomUUID(), title, file, added: Date.now() };
    await this.put(entry);
    return entry;
  }

  async put(entry: OwnEntry): Promise<void> {
    await this.#write(stores.entries, (store) => store.put(entry));
  }

  async remove(id: string): Promise<void> {
    await this.#write(stores.entries, (store) => store.delete(id));
  }

  async picture(key: string): Promise<Picture | null> {
    return (await result<Picture | undefined>(this.#read(stores.pictures).get(key))) ?? null;
  }

  async setPicture(key: string, pixels: Picture): Promise<void> {
    await this.#write(stores.pictures, (store) => store.put(pixels, key));
  }

  /** Pictures of materials that are no more, and of an older Irradia. */
  async prunePictures(wanted: ReadonlySet<string>): Promise<void> {
    const keys = await result(this.#read(stores.pictures).getAllKeys());
    const stale = keys.filter((key) => !wanted.has(String(key)));
    if (stale.length === 0) return;
    await this.#write(stores.pictures, (store) => {
      for (const key of stale) store.delete(key);
    });
  }

  #read(name: keyof typeof stores): IDBObjectStore {
    return this.#database.transaction(name).objectStore(name);
  }

  async #write(name: keyof typeof stores, write: (store: IDBObjectStore) => void): Promise<void> {
    const transaction = this.#database.transaction(name, 'readwrite');
    const done = completed(transaction);
    write(transaction.objectStore(name));
    await done;
  }
}
