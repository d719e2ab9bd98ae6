import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { nextTask } from '../../src/editor/next-task.ts';
import { Follower } from '../../src/editor/ui/follower.ts';

beforeEach(() => vi.stubGlobal('window', new EventTarget()));
afterEach(() => vi.unstubAllGlobals());

it('a panel follows at once what is little work, and what is much once, in a task of its own', async () => {
  let [done, isQuick] = [0, true];
  const follower = new Follower(
    () => done++,
    () => isQuick,
  );
  follower.soon();
  follower.soon();
  expect(done).toBe(2);
  isQuick = false;
  follower.soon();
  follower.soon();
  expect(done).toBe(2);
  await nextTask();
  expect(done).toBe(3);
});

it('or before it is used, and then not again', async () => {
  let done = 0;
  const follower = new Follower(
    () => done++,
    () => false,
  );
  follower.now();
  expect(done).toBe(0);
  follower.soon();
  follower.now();
  expect(done).toBe(1);
  await nextTask();
  expect(done).toBe(1);
});

it('or when a key is pressed, and then not again', () => {
  let done = 0;
  const follower = new Follower(
    () => done++,
    () => false,
  );
  const press = () => window.dispatchEvent(new Event('keydown'));
  press();
  expect(done).toBe(0);
  follower.soon();
  press();
  expect(done).toBe(1);
  press();
  expect(done).toBe(1);
});
