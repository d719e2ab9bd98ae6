/** When the open document is written, and what a page that ends would lose. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Autosave, type KeepState } from '../../../src/editor/storage/autosave.ts';
import type { KeptDocument, KeptDocuments } from '../../../src/editor/storage/kept-documents.ts';
import { setField } from '../../../src/scene/commands.ts';
import { createDocument } from '../../../src/scene/document.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

interface Write {
  readonly before: Document | null;
  readonly document: Document;
  succeed(): void;
  fail(error: unknown): void;
}

/** What a test has of the database: writes wait until it says how they end. */
class FakeStorage {
  readonly writes: Write[] = [];
  readonly versions: { document: Document; name: string | null }[] = [];
  atOnce = true;
  versionFault: Error | null = null;

  write(kept: KeptDocument, document: Document, before: Document | null) {
    const done = new Promise<void>((succeed, fail) => {
      this.writes.push({ before, document, succeed, fail });
    });
    return { kept: { ...kept, modified: this.writes.length }, done, atOnce: this.atOnce };
  }

  async addVersion(_: string, document: Document, name: string | null) {
    if (this.versionFault) throw this.versionFault;
    this.versions.push({ document, name });
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('window', Object.assign(new EventTarget(), { setTimeout }));
  vi.stubGlobal('document', Object.assign(new EventTarget(), { visibilityState: 'visible' }));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function opened(address: string | null = '') {
  const store = new DocumentStore(createDocument());
  const storage = new FakeStorage();
  const states: KeepState['kind'][] = [];
  const onNoVersion = vi.fn();
  const autosave = new Autosave({
    store,
    onState: ({ kind }) => states.push(kind),
    onFirstKept: () => {},
    onNoVersion,
  });
  autosave.use(storage as unknown as KeptDocuments);
  autosave.opened(store.document, null, address);
  let exposure = 0;
  const edit = () => setField(store, ['view', 'exposure'], ++exposure);
  return { store, storage, states, autosave, edit, onNoVersion };
}

const last = <T>(list: readonly T[]): T => list.at(-1) as T;
const settle = () => vi.advanceTimersByTimeAsync(0);

it('writes once a second after an edit, what has changed since the last write that went well', async () => {
  const { storage, store, states, edit } = opened();
  const before = store.document;
  setField(store, ['camera', 'position'], [1, 2, 3]);
  await vi.advanceTimersByTimeAsync(5000);
  expect(storage.writes).toHaveLength(0);
  edit();
  edit();
  await vi.advanceTimersByTimeAsync(999);
  expect(storage.writes).toHaveLength(0);
  await vi.advanceTimersByTimeAsync(1);
  expect(storage.writes).toHaveLength(1);
  expect(storage.writes[0]).toMatchObject({ before: null, document: store.document });
  expect(last(states)).toBe('waiting');
  storage.writes[0]!.succeed();
  await settle();
  expect(last(states)).toBe('kept');
  expect(storage.versions).toEqual([{ document: before, name: 'As it was opened' }]);

  const first = store.document;
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  expect(storage.writes[1]!.before).toBe(first);
  storage.writes[1]!.succeed();
  await settle();
  expect(storage.versions).toHaveLength(1);

  await vi.advanceTimersByTimeAsync(10 * 60_000);
  const second = store.document;
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  storage.writes[2]!.succeed();
  await settle();
  expect(storage.versions[1]).toEqual({ document: second, name: null });
});

it('keeps at once what came from a file, and what is left', () => {
  const { storage, autosave, edit } = opened(null);
  expect(autosave.flushNow()).toBe(true);
  expect(storage.writes).toHaveLength(1);
  edit();
  window.dispatchEvent(new Event('pagehide'));
  expect(storage.writes).toHaveLength(2);
  edit();
  Object.assign(document, { visibilityState: 'hidden' }).dispatchEvent(new Event('visibilitychange'));
  expect(storage.writes).toHaveLength(3);
});

it('a page that ends loses new bytes until they are written, and only those', async () => {
  const { storage, autosave, store, edit } = opened();
  storage.atOnce = false;
  store.edit('Add', (draft) => {
    draft.assets.a = { name: 'a', mediaType: 'image/png', data: 'AAAA' };
  });
  // Not hashed yet, being hashed, being written.
  expect(autosave.flushNow()).toBe(false);
  vi.advanceTimersByTime(1000);
  expect(autosave.flushNow()).toBe(false);
  await vi.waitFor(() => expect(storage.writes).toHaveLength(1), { timeout: 60_000 });
  expect(autosave.flushNow()).toBe(false);
  storage.writes[0]!.succeed();
  await settle();
  expect(autosave.state.kind).toBe('kept');
  expect(autosave.flushNow()).toBe(true);
  storage.atOnce = true;
  edit();
  expect(autosave.flushNow()).toBe(true);
  expect(storage.writes).toHaveLength(2);
});

it('what has failed is written whole the next time, also when that is only asked for', async () => {
  const { storage, autosave, states, edit } = opened();
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  storage.writes[0]!.succeed();
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  expect(storage.writes[1]!.before).not.toBeNull();
  storage.writes[1]!.fail(new DOMException('full', 'QuotaExceededError'));
  await settle();
  expect(last(states)).toBe('failed');
  expect(autosave.flushNow()).toBe(false);
  const flushed = autosave.flush();
  expect(storage.writes[2]!.before).toBeNull();
  storage.writes[2]!.succeed();
  await flushed;
  expect(last(states)).toBe('kept');
  expect(autosave.flushNow()).toBe(true);
});

it('what was cleared is written whole; a database that comes late takes what waits for it', async () => {
  const { storage, autosave, states, edit } = opened();
  autosave.use(null, new Error('late'));
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  expect(last(states)).toBe('failed');
  autosave.use(storage as unknown as KeptDocuments);
  await vi.advanceTimersByTimeAsync(1000);
  expect(storage.writes).toHaveLength(1);
  storage.writes[0]!.succeed();
  await settle();
  expect(last(states)).toBe('kept');
  autosave.cleared();
  expect(storage.writes[1]!.before).toBeNull();
});

it('what could not be written at all is written when the database is there again', async () => {
  const { storage, autosave, states, edit } = opened();
  const write = vi.spyOn(storage, 'write').mockImplementation(() => {
    throw new Error('closed');
  });
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  expect(last(states)).toBe('failed');
  write.mockRestore();
  autosave.cleared();
  storage.writes[0]!.succeed();
  await settle();
  expect(last(states)).toBe('kept');
});

it('a document is kept although a version of it is not', async () => {
  const { storage, states, edit, onNoVersion } = opened();
  storage.versionFault = new Error('full');
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  storage.writes[0]!.succeed();
  await settle();
  expect(last(states)).toBe('kept');
  expect(onNoVersion).toHaveBeenCalledWith(storage.versionFault);
});

it('what was done to another document meanwhile is not said of this one', async () => {
  const { storage, autosave, store, states, edit } = opened();
  edit();
  await vi.advanceTimersByTimeAsync(1000);
  store.open(createDocument('Other'));
  autosave.opened(store.document, null, '');
  storage.writes[0]!.fail(new Error('gone'));
  await settle();
  expect(last(states)).toBe('unchanged');
  expect(autosave.untouched).toBe(true);
  await vi.advanceTimersByTimeAsync(5000);
  expect(storage.writes).toHaveLength(1);
});
