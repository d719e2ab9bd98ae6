/**
 * Which document is open, and how one takes the place of another without anything being lost: the first of
 * a page, those that were kept, files, links, versions.
 */
import type { Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import { language, t } from '../language/language.ts';
import type { EditorStateStore } from '../state.ts';
import { confirm } from '../ui/confirm.ts';
import { messageOf, toast, toastError } from '../ui/toast.ts';
import { trackUnsaved, type Unsaved } from '../unsaved.ts';
import { AS_OPENED, Autosave, type KeepState } from './autosave.ts';
import { explainFailure } from './failure.ts';
import { type KeptDocument, KeptDocuments, type Version } from './kept-documents.ts';
import { hold, readSession, type SessionRecord, whileHeld, writeSession } from './session-record.ts';
import { type TakePicture, Thumbnails } from './thumbnails.ts';

const PURGE_AFTER_MS = 10_000;
/** A database that has not answered by then does not hold up the page, */
const PATIENCE_MS = 4000;
/** counted in such pieces: one that answers while the page itself is busy is not late. */
const PATIENCE_TICK_MS = 250;

export interface WorkspaceOptions {
  readonly store: DocumentStore;
  readonly state: EditorStateStore;
  picture: TakePicture;
}

export class Workspace {
  readonly #store: DocumentStore;
  readonly #state: EditorStateStore;
  readonly #autosave: Autosave;
  readonly #unsaved: Unsaved;
  readonly #thumbnails: Thumbnails;
  readonly #listeners = new Set<(state: KeepState) => void>();
  #storage: KeptDocuments | null = null;
  #release: (() => void) | null = null;
  #warned = false;

  constructor({ store, state, picture }: WorkspaceOptions) {
    this.#store = store;
    this.#state = state;
    this.#thumbnails = new Thumbnails(picture);
    this.#autosave = new Autosave({
      store,
      onState: (keepState) => this.#onState(keepState),
      onFirstKept: (kept) => void this.#hold(kept.id),
      onNoVersion: (error) => toast('error', t('The version was not kept'), explainFailure(error)),
    });
    this.#unsaved = trackUnsaved(store, () => this.#autosave.flushNow());
    window.addEventListener('pagehide', () => this.#remember());
    document.addEventListener('visibilitychange', () => this.#remember());
  }

  /** Null where the browser keeps nothing. */
  get storage(): KeptDocuments | null {
    return this.#storage;
  }

  get kept(): KeptDocument | null {
    return this.#autosave.kept;
  }

  get keepState(): KeepState {
    return this.#autosave.state;
  }

  /** Where Save writes the open document, in browsers that let a page write files. */
  get file(): FileSystemFileHandle | null {
    return this.#autosave.file;
  }

  subscribe(listener: (state: KeepState) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Everything is written; the picture of the document is fresh. */
  async flush(): Promise<void> {
    await this.#autosave.flush();
    await this.#thumbnails.take(this.#storage, this.kept);
  }

  /** The document is in a file of the person's own. */
  async savedTo(file: FileSystemFileHandle | null): Promise<void> {
    this.#unsaved.mark();
    if (file) await this.#autosave.setFile(file);
  }

  /** The document of the page's first frame: the one that this tab had, or the last one, or the address's. */
  async start(addressed: () => Promise<Document>): Promise<void> {
    const address = location.search + location.hash;
    await this.#openStorage();
    const session = readSession();
    const same = session?.address === address ? session : null;
    // After the first frame, in whose way it would be.
    window.setTimeout(() => void this.#storage?.purge().catch(() => {}), PURGE_AFTER_MS);
    if (await this.#recover(address, same, addressed)) return;
    await this.#openAddressed(address, addressed);
    if (!same && address !== '') await this.#offerEarlierWork(address);
  }

  async #openStorage(): Promise<void> {
    const opening = KeptDocuments.open().then((storage) => {
      storage.onCleared = () => this.#autosave.cleared();
      storage.onDamaged = tellDamage;
      this.#storage = storage;
      this.#autosave.use(storage);
    });
    const late = async (): Promise<never> => {
      for (let waited = 0; waited < PATIENCE_MS; waited += PATIENCE_TICK_MS)
        await new Promise((resolve) => setTimeout(resolve, PATIENCE_TICK_MS));
      throw new Error(t('The browser’s database does not answer.'));
    };
    await Promise.race([opening, late()]).catch((error: unknown) => this.#autosave.use(null, error));
  }

  async #openAddressed(address: string, addressed: () => Promise<Document>): Promise<void> {
    try {
      const document = await addressed();
      this.#store.open(document);
      this.#autosave.opened(document, null, address);
    } catch (error) {
      toastError(t('The scene could not be opened'), error);
      this.#autosave.opened(this.#store.document, null, '');
    }
    this.#remember();
  }

  async #recover(
    address: string,
    session: SessionRecord | null,
    addressed: () => Promise<Document>,
  ): Promise<boolean> {
    const storage = this.#storage;
    if (!storage) return false;
    try {
      const id = session ? session.document : address === '' ? (await storage.list())[0]?.id : null;
      const kept = id ? await storage.find(id) : undefined;
      if (!kept || !(await this.#hold(kept.id))) return false;
      this.#openLoaded(await loaded(storage, kept));
      const selection = session?.selection ?? null;
      if (selection && selection.id in this.#store.document[selection.kind]) this.#state.select(selection);
      const discard = async () => {
        await this.delete(kept, () => this.#openAddressed(address, addressed));
      };
      toast(
        'info',
        t('Recovered “{name}”', { name: kept.name }),
        t('As it was {time}.', { time: timeText(kept.modified) }),
        {
          label: t('Discard'),
          run: () => void discard(),
        },
      );
      return true;
    } catch (error) {
      this.#letGo();
      toastError(t('The last document could not be recovered'), error);
      return false;
    }
  }

  async #offerEarlierWork(address: string): Promise<void> {
    const earlier = (await this.#storage?.list().catch(() => []))?.find((kept) => kept.address === address);
    if (!earlier) return;
    toast(
      'info',
      t('You have changed this scene before'),
      `“${earlier.name}”, ${timeText(earlier.modified)}.`,
      {
        label: t('Open that'),
        run: () => void this.openKept(earlier),
      },
    );
  }

  #openLoaded({ document, kept, lastVersion }: Loaded): void {
    this.#state.select(null);
    this.#store.open(document);
    this.#autosave.opened(document, kept, kept.address, lastVersion);
    this.#remember();
  }

  /**
   * Opens a document in place of the present one; false when the person would rather not lose that. The
   * address is what, behind the page's own, opens the same again; null if nothing does. The file is where Save writes it.
   */
  async replace(
    document: Document,
    address: string | null,
    file: FileSystemFileHandle | null = null,
  ): Promise<boolean> {
    const leave = await this.#leave();
    if (!leave) return false;
    this.#state.select(null);
    this.#store.open(document);
    history.replaceState(null, '', `./${address ?? ''}`);
    this.#autosave.opened(document, null, address);
    if (file) await this.#autosave.setFile(file);
    this.#remember();
    leave();
    return true;
  }

  /** Opens a kept document; one that another tab has open is opened as a copy. */
  async openKept(kept: KeptDocument): Promise<boolean> {
    const storage = this.#storage;
    if (!storage || kept.id === this.kept?.id) return false;
    try {
      const release = await hold(kept.id);
      if (!release) {
        const { document } = await storage.load(kept);
        const opened = await this.replace(
          { ...document, name: t('{name} copy', { name: document.name.slice(0, 195) }) },
          null,
        );
        if (opened)
          toast(
            'info',
            t('“{name}” is open in another tab', { name: kept.name }),
            t('This is a copy of it.'),
          );
        return opened;
      }
      // Before the present one is left: it can be worked on until then.
      const next = await loaded(storage, kept).catch((error: unknown) => {
        release();
        throw error;
      });
      const leave = await this.#leave();
      if (!leave) {
        release();
        return false;
      }
      this.#release = release;
      this.#openLoaded(next);
      history.replaceState(null, '', './');
      this.#remember();
      leave();
      return true;
    } catch (error) {
      toastError(t('“{name}” could not be opened', { name: kept.name }), error);
      return false;
    }
  }

  /** Another state of what has just been opened, which nobody has worked on yet: no undo step, and nothing to keep. */
  amend(document: Document): void {
    this.#store.open(document);
    this.#autosave.amended(this.#store.document);
  }

  /** One undo step of the open document. */
  async restore(version: Version): Promise<void> {
    if (!this.#storage) return;
    const document = await this.#storage.loadVersion(version);
    const label =
      version.name === null
        ? t('Restore the version kept {time}', { time: timeText(version.time) })
        : t('Restore {name}', { name: version.name });
    this.#store.edit(label, (draft) => {
      Object.assign(draft, document);
    });
  }

  /** Out of the list, with an offer to undo. What is open makes way for what `next` opens. */
  async delete(kept: KeptDocument, next: () => Promise<unknown>): Promise<void> {
    const storage = this.#storage;
    if (!storage) return;
    const open = kept.id === this.kept?.id;
    if (!open) await whileHeld(kept.id, () => storage.setDeleted(kept, true));
    else {
      await this.#autosave.flush();
      await storage.setDeleted(kept, true);
      this.#letGo();
      this.#autosave.opened(this.#store.document, null, '');
      await next();
    }
    const undo = async () => {
      await storage.setDeleted(kept, false);
      const again = await storage.find(kept.id);
      if (open && again) await this.openKept(again);
      for (const listener of [...this.#listeners]) listener(this.keepState);
    };
    toast('info', t('Deleted “{name}”', { name: kept.name }), undefined, {
      label: t('Undo'),
      run: () => void undo(),
      onGone: () => void storage.purge(kept.id).catch(() => {}),
    });
  }

  /** After a loss that only a new page cures: it opens with the same document. */
  async reload(): Promise<void> {
    await this.#autosave.flush();
    this.#remember();
    location.reload();
  }

  /** Makes sure that nothing is lost with the present document; returns what to do once it has been left. */
  async #leave(): Promise<(() => void) | null> {
    await this.flush();
    const { kept } = this;
    if (this.#autosave.untouched && (await this.#forget(kept))) return () => {};
    if (this.#unsaved.value && this.keepState.kind !== 'kept') {
      const sure = await confirm(
        t('Leave “{name}”?', { name: this.#store.document.name }),
        t('It has changes that are not saved. Save first if you want to keep them.'),
        t('Discard changes'),
      );
      if (!sure) return null;
    }
    this.#letGo();
    if (!kept) return () => {};
    return () =>
      toast('info', t('“{name}” is kept', { name: kept.name }), t('It is under File, Documents.'), {
        label: t('Back to it'),
        run: () => void this.openKept(kept),
      });
  }

  /**
   * Lets a document go that is just as it came from its file, link or menu: there is nothing to keep, nor to ask. False if
   * the person has kept a version of it.
   */
  async #forget(kept: KeptDocument | null): Promise<boolean> {
    const storage = this.#storage;
    if (kept && storage) {
      const versions = await storage.versions(kept.id);
      if (versions.some(({ name }) => name !== AS_OPENED)) return false;
      await storage.setDeleted(kept, true);
      await storage.purge(kept.id);
    }
    this.#letGo();
    return true;
  }

  #letGo(): void {
    this.#release?.();
    this.#release = null;
  }

  async #hold(id: string): Promise<boolean> {
    const release = await hold(id);
    if (release) this.#release = release;
    this.#remember();
    return release !== null;
  }

  #remember(): void {
    writeSession({
      address: location.search + location.hash,
      document: this.kept?.id ?? null,
      selection: this.#state.value.selection,
    });
  }

  #onState(keepState: KeepState): void {
    for (const listener of [...this.#listeners]) listener(keepState);
    if (keepState.kind === 'kept') {
      if (this.#warned) toast('success', t('This document is being kept again'));
      this.#warned = false;
      this.#thumbnails.later(this.#storage, this.kept);
    }
    if (keepState.kind !== 'failed' || this.#warned) return;
    this.#warned = true;
    toast('error', t('This document is not being kept'), explainFailure(keepState.error));
  }
}

interface Loaded {
  readonly document: Document;
  readonly kept: KeptDocument;
  /** When the youngest of its versions was kept. */
  readonly lastVersion: number | undefined;
}

async function loaded(storage: KeptDocuments, wanted: KeptDocument): Promise<Loaded> {
  const { document, kept } = await storage.load(wanted);
  return { document, kept, lastVersion: (await storage.versions(kept.id))[0]?.time };
}

function tellDamage(name: string, fault: unknown): void {
  toast(
    'error',
    t('“{name}” is not as you left it', { name }),
    t('A part of what this browser kept is damaged; this is an earlier state of it. {reason}', {
      reason: messageOf(fault),
    }),
  );
}

/** `at 10:32`, or `on 12 May, 10:32`. */
export function timeText(time: number): string {
  const date = new Date(time);
  const clock = date.toLocaleTimeString(language, { hour: '2-digit', minute: '2-digit' });
  if (date.toDateString() === new Date().toDateString()) return t('at {clock}', { clock });
  return t('on {date}, {clock}', {
    date: date.toLocaleDateString(language, { day: 'numeric', month: 'short' }),
    clock,
  });
}
