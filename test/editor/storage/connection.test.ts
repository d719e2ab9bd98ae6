/** A database that the browser closes while it is in use. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Connection, DatabaseLost } from '../../../src/editor/storage/connection.ts';

interface FakeDatabase {
  onclose?(): void;
}

let opened: FakeDatabase[];
let isOpenable: boolean;
let tries: number;

beforeEach(() => {
  vi.useFakeTimers();
  [opened, isOpenable, tries] = [[], true, 0];
  vi.stubGlobal('indexedDB', {
    open() {
      tries += 1;
      const request: { result?: FakeDatabase; error?: Error; onsuccess?(): void; onerror?(): void } = {};
      queueMicrotask(() => {
        if (isOpenable) {
          request.result = {};
          opened.push(request.result);
          request.onsuccess?.();
        } else {
          request.error = new Error('not now');
          request.onerror?.();
        }
      });
      return request;
    },
  });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

it('is opened again at once, which is told; what is wanted of it meanwhile is refused', async () => {
  const connection = await Connection.open();
  const onOpenedAgain = vi.fn();
  connection.onOpenedAgain = onOpenedAgain;
  expect(connection.database).toBe(opened[0]);
  opened[0]?.onclose?.();
  expect(() => connection.database).toThrow(DatabaseLost);
  await vi.advanceTimersByTimeAsync(60_000);
  expect(connection.database).toBe(opened[1]);
  expect([opened.length, onOpenedAgain.mock.calls.length]).toEqual([2, 1]);
});

it('is tried for a while, and after that whenever it is needed, for ever', async () => {
  const connection = await Connection.open();
  const onOpenedAgain = vi.fn();
  connection.onOpenedAgain = onOpenedAgain;
  isOpenable = false;
  opened[0]?.onclose?.();
  await vi.advanceTimersByTimeAsync(60_000);
  const before = tries;
  await vi.advanceTimersByTimeAsync(60_000);
  expect(tries).toBe(before);
  expect(() => connection.database).toThrow(DatabaseLost);
  expect(() => connection.database).toThrow(DatabaseLost);
  isOpenable = true;
  await vi.advanceTimersByTimeAsync(60_000);
  expect(connection.database).toBe(opened[1]);
  expect([tries, onOpenedAgain.mock.calls.length]).toEqual([before + 1, 1]);
  opened[1]?.onclose?.();
  await vi.advanceTimersByTimeAsync(60_000);
  expect(connection.database).toBe(opened[2]);
});
