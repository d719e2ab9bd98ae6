import { expect, it } from 'vitest';
import { nextTask } from '../../src/editor/next-task.ts';
import { Follower } from '../../src/editor/ui/follower.ts';

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
