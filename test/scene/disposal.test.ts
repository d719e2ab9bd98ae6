import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Disposal } from '../../src/scene/mirror/disposal.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('what is no longer shown goes one thing in a task, and what is left at the end at once', () => {
  const disposal = new Disposal();
  const dispose = vi.fn();
  for (let i = 0; i < 5; i++) disposal.later({ dispose });
  expect(dispose).not.toHaveBeenCalled();
  for (const gone of [1, 2, 3]) {
    vi.runOnlyPendingTimers();
    expect(dispose).toHaveBeenCalledTimes(gone);
  }
  disposal.dispose();
  expect(dispose).toHaveBeenCalledTimes(5);
  vi.runAllTimers();
  expect(dispose).toHaveBeenCalledTimes(5);
});
