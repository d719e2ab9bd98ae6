import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { FrameLoop } from '../../src/editor/viewport/frame-loop.ts';

/** Animation frames and GPU that the test drives by hand. */
let pending: ((now: number) => void)[] = [];
let now = 0;

beforeEach(() => {
  pending = [];
  now = 0;
  vi.stubGlobal('requestAnimationFrame', (callback: (now: number) => void) => pending.push(callback));
  vi.spyOn(performance, 'now').mockImplementation(() => now);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

async function tick(ms: number): Promise<void> {
  now += ms;
  const callbacks = pending;
  pending = [];
  for (const callback of callbacks) callback(now);
  await new Promise((resolve) => setTimeout(resolve));
}

function setup(render: () => Promise<void> = async () => {}) {
  const frames: number[] = [];
  const errors: unknown[] = [];
  let count = 0;
  const loop = new FrameLoop({
    render: () => {
      count += 1;
      return render();
    },
    onFrame: (_, ms) => frames.push(ms),
    onError: (error) => errors.push(error),
  });
  return { loop, frames, errors, rendered: () => count };
}

describe('the frame loop', () => {
  it('renders once for many requests, then rests', async () => {
    const { loop, rendered } = setup();
    loop.request();
    loop.request();
    await tick(16);
    await tick(16);
    expect(rendered()).toBe(1);
    expect(pending).toHaveLength(0);
    await tick(16);
    expect(rendered()).toBe(1);
  });

  it('times a frame that comes alone until the GPU has finished it', async () => {
    const { loop, frames } = setup(async () => {
      now += 7;
    });
    loop.request();
    await tick(16);
    expect(frames).toEqual([7]);
  });

  it('times frames that follow one another by what lies between them', async () => {
    const { loop, frames } = setup();
    loop.continuous = true;
    for (const ms of [16, 16, 30, 16]) await tick(ms);
    expect(frames).toEqual([0, 16, 30, 16]);
  });

  it('does not count the rest between two changes as a frame', async () => {
    const { loop, frames } = setup();
    loop.request();
    await tick(16);
    await tick(16);
    now += 5000;
    loop.request();
    await tick(16);
    expect(frames).toEqual([0, 0]);
  });

  it('waits for the GPU when it is two frames behind', async () => {
    const finish: (() => void)[] = [];
    const { loop, rendered } = setup(() => new Promise((resolve) => finish.push(resolve)));
    loop.continuous = true;
    for (let i = 0; i < 5; i++) await tick(16);
    expect(rendered()).toBe(2);
    finish[0]?.();
    await tick(16);
    await tick(16);
    expect(rendered()).toBe(3);
  });

  it('reports an error and can be stopped', async () => {
    const { loop, errors, rendered } = setup(async () => {
      throw new Error('lost');
    });
    loop.request();
    await tick(16);
    expect(errors).toHaveLength(1);
    loop.stop();
    loop.request();
    await tick(16);
    expect(rendered()).toBe(1);
  });
});
