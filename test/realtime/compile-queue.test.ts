import { Mesh, Scene } from 'three/webgpu';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { CompileQueue, withOnly } from '../../src/realtime/compile-queue.ts';

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

it('compiles one after the other, failed or not, and leaves no timer behind', async () => {
  const queue = new CompileQueue();
  const begun: string[] = [];
  let fail = (_: Error) => {};
  const first = queue.add(() => {
    begun.push('first');
    return new Promise<void>((_, reject) => {
      fail = reject;
    });
  });
  const second = queue.add(async () => {
    begun.push('second');
  });
  await vi.advanceTimersByTimeAsync(0);
  expect(begun).toEqual(['first']);
  fail(new Error('no shader'));
  await expect(first).rejects.toThrow('no shader');
  await second;
  expect(begun).toEqual(['first', 'second']);
  await vi.advanceTimersByTimeAsync(0);
  expect(vi.getTimerCount()).toBe(0);
});

it('one that never ends does not keep the others for ever', async () => {
  const queue = new CompileQueue();
  void queue.add(() => new Promise(() => {}));
  let isCompiled = false;
  void queue
    .add(async () => {})
    .then(() => {
      isCompiled = true;
    });
  await vi.advanceTimersByTimeAsync(9_999);
  expect(isCompiled).toBe(false);
  await vi.advanceTimersByTimeAsync(1);
  expect(isCompiled).toBe(true);
});

it('three.js sees only the meshes that are asked for, and afterwards all', () => {
  const scene = new Scene();
  const [wanted, other, hidden] = [new Mesh(), new Mesh(), new Mesh()];
  hidden.visible = false;
  scene.add(wanted, other, hidden);
  const masks = () => [wanted, other, hidden].map(({ layers }) => layers.mask);
  expect(withOnly(scene, [wanted], masks)).toEqual([1, 0, 1]);
  expect(masks()).toEqual([1, 1, 1]);
  expect(() =>
    withOnly(scene, [], () => {
      throw new Error('no');
    }),
  ).toThrow('no');
  expect(masks()).toEqual([1, 1, 1]);
});
