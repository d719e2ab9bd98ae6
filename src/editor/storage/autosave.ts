/**
 * Keeps the open document in the browser: a second after an edit, and at once when the page is hidden or
 * left. A document that nobody has changed is not kept, unless it came from a file, which only the person has.
 */
import type { Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import { t } from '../language/language.ts';
import { type KeptDocument, type KeptDocuments, newlyKept } from './kept-documents.ts';
import { hashAssets, isHashed } from './stored-document.ts';

/** Work that a crash may take. Not a pause in the editing: a long drag is kept as it goes. */
const DELAY_MS = 1000;
/** The name of the version that a document begins with. */
export const AS_OPENED = t('As it was opened');
/** Between automatic versions. */
const VERSION_MS = 10 * 60_000;

export type KeepState =
  /** The document is as it was opened. */
  | { readonly kind: 'unchanged' }
  | { readonly kind: 'waiting' }
  | { readonly kind: 'kept'; readonly time: number }
  | { readonly kind: 'failed'; readonly error: unknown };

export interface AutosaveOptions {
  readonly store: DocumentStore;
  onState(state: KeepState): void;
  /** The document has just got its place among the kept ones. */
  onFirstKept(kept: KeptDocument): void;
  /** The document is kept, a version of it is not. */
  onNoVersion(error: unknown): void;
}

export class Autosave {
  readonly #options: AutosaveOptions;
  #storage: KeptDocuments | null = null;
  #unavailable: unknown = null;
  #kept: KeptDocument | null = null;
  #address: string | null = null;
  #file: FileSystemFileHandle | null = null;
  #opened: Document;
  /** It was opened from the kept ones. */
  #wasKept = false;
  /** What the last write that went well, or that is under way, has written. */
  #written: Document | null = null;
  #lastVersion = 0;
  #state: KeepState = { kind: 'unchanged' };
  #timer: number | undefined;
  #writing: Promise<void> = Promise.resolve();
  /** What is being written would be lost with the page: its assets are still being hashed, or asked for. */
  #atRisk = false;

  constructor(options: AutosaveOptions) {
    this.#options = options;
    this.#opened = options.store.document;
    options.store.subscribe(({ document, previous, reason }) => {
      if (reason === 'open') return;
      // Hashing takes longer than leaving the page does, so it does not wait.
      if (document.assets !== previous.assets) void hashAssets(document).catch(() => {});
      if (this.#kept === null && onlyTheCameraDiffers(document, this.#opened)) return;
      this.#schedule();
    });
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') this.flushNow();
    });
    window.addEventListener('pagehide', () => this.flushNow());
  }

  /** Null, and why, where the browser keeps nothing. */
  use(storage: KeptDocuments | null, unavailable: unknown = null): void {
    this.#storage = storage;
    this.#unavailable = unavailable;
    if (storage && this.#state.kind === 'failed') this.#schedule();
  }

  /** What was kept may no longer be there, and can be again. */
  cleared(): void {
    this.#written = null;
    if (this.#kept || this.#state.kind === 'failed') void this.flush(true);
  }

  get kept(): KeptDocument | null {
    return this.#kept;
  }

  get state(): KeepState {
    return this.#state;
  }

  /** The store has another document now. Without an address it can be had only from here, and is kept at once. */
  opened(document: Document, kept: KeptDocument | null, address: string | null, lastVersion = 0): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#atRisk = false;
    this.#kept = kept;
    this.#wasKept = kept !== null;
    this.#address = address;
    this.#file = kept?.file ?? null;
    this.#opened = document;
    this.#written = kept && Number.isFinite(kept.changesSize) ? document : null;
    this.#lastVersion = lastVersion;
    this.#tell(kept ? { kind: 'kept', time: kept.modified } : { kind: 'unchanged' });
    if (!kept && address === null) this.#schedule();
  }

  /** The page itself has changed the document that was opened: that is not work to be kept. */
  amended(document: Document): void {
    this.#opened = document;
  }

  /** The document is as it was opened, or made, and was not one that had been kept before. */
  get untouched(): boolean {
    return !this.#wasKept && onlyTheCameraDiffers(this.#options.store.document, this.#opened);
  }

  /** Where Save writes the open document. */
  get file(): FileSystemFileHandle | null {
    return this.#file;
  }

  async setFile(file: FileSystemFileHandle): Promise<void> {
    this.#file = file;
    if (this.#kept) await this.flush(true);
  }

  /** Resolves when everything is written, or could not be. What has failed is tried again. */
  async flush(force = this.#state.kind === 'failed'): Promise<void> {
    await this.#write(force);
    await this.#writing;
  }

  /** False if what has not been written yet would be lost should the page end now. */
  flushNow(): boolean {
    const { document } = this.#options.store;
    if (this.#timer !== undefined && isHashed(document)) void this.#write();
    return this.#timer === undefined && !this.#atRisk && this.#state.kind !== 'failed';
  }

  #schedule(): void {
    if (this.#timer !== undefined) return;
    if (this.#state.kind !== 'failed') this.#tell({ kind: 'waiting' });
    this.#timer = window.setTimeout(() => void this.#write(), DELAY_MS);
  }

  async #write(force = false): Promise<void> {
    if (this.#timer === undefined && !force) return;
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const { document } = this.#options.store;
    if (document === this.#written && !force) {
      if (this.#kept) this.#tell({ kind: 'kept', time: this.#kept.modified });
      return;
    }
    if (!this.#storage) {
      this.#tell({ kind: 'failed', error: this.#unavailable });
      return;
    }
    // Without this test the write would begin too late for a page that ends.
    if (!isHashed(document)) {
      this.#atRisk = true;
      try {
        await hashAssets(document);
      } catch (error) {
        this.#failed(error, this.#kept);
        return;
      }
      if (this.#options.store.document !== document) {
        this.#schedule();
        return this.#write(force);
      }
    }
    this.#issue(this.#storage, document);
  }

  #issue(storage: KeptDocuments, document: Document): void {
    const before = this.#written;
    const first = this.#kept === null;
    try {
      const { kept, done, atOnce } = storage.write(
        { ...(this.#kept ?? newlyKept(document, this.#address)), ...(this.#file && { file: this.#file }) },
        document,
        before,
      );
      this.#atRisk = !atOnce;
      this.#kept = kept;
      this.#written = document;
      if (first) this.#options.onFirstKept(kept);
      this.#writing = done.then(
        () => {
          if (this.#written === document) this.#atRisk = false;
          return this.#succeeded(storage, kept, first ? this.#opened : before, first);
        },
        (error: unknown) => this.#failed(error, kept),
      );
    } catch (error) {
      this.#failed(error, this.#kept);
    }
  }

  async #succeeded(
    storage: KeptDocuments,
    kept: KeptDocument,
    before: Document | null,
    first: boolean,
  ): Promise<void> {
    // Another document may have been opened meanwhile.
    if (this.#kept?.id !== kept.id) return;
    if (this.#timer === undefined) this.#tell({ kind: 'kept', time: kept.modified });
    if (before === null || Date.now() - this.#lastVersion < VERSION_MS) return;
    this.#lastVersion = Date.now();
    // The document itself is kept: the next one will be tried with the next edit after another ten minutes.
    await storage.addVersion(kept.id, before, first ? AS_OPENED : null).catch(this.#options.onNoVersion);
  }

  #failed(error: unknown, kept: KeptDocument | null): void {
    if (this.#kept?.id !== kept?.id) return;
    // What of it was written is not known, so the next write writes all.
    this.#written = null;
    this.#tell({ kind: 'failed', error });
  }

  #tell(state: KeepState): void {
    this.#state = state;
    this.#options.onState(state);
  }
}

/** Looking around is not work. */
export function onlyTheCameraDiffers(a: Document, b: Document): boolean {
  return (Object.keys(a) as (keyof Document)[]).every((part) => part === 'camera' || a[part] === b[part]);
}
