import { describe, expect, it } from 'vitest';
import { describeDevice, fractionOf, describe as say } from '../../../src/editor/path-tracing/figures.ts';
import type { Figures } from '../../../src/editor/path-tracing/messages.ts';
import { nextPass } from '../../../src/editor/path-tracing/schedule.ts';

/** The passes of a machine that takes so many seconds for a sample of each pixel. */
function passes(secondsPerSample: number, goal: number): number[] {
  const counts: number[] = [];
  for (let done = 0; done < goal; ) {
    const count = nextPass(done, done * secondsPerSample, goal);
    counts.push(count);
    done += count;
  }
  return counts;
}

describe('the schedule of passes', () => {
  it('doubles what is there, up to the goal and no further', () => {
    expect(passes(1e-6, 100)).toEqual([1, 1, 2, 4, 8, 16, 32, 36]);
    expect(passes(1e-6, 1)).toEqual([1]);
  });

  it('stays with one sample on a slow machine, and with half a second on others', () => {
    expect(passes(3, 4)).toEqual([1, 1, 1, 1]);
    expect(passes(0.1, 16)).toEqual([1, 1, 2, 4, 4, 4]);
  });

  it('takes no more samples at once than float32 sums bear', () => {
    expect(Math.max(...passes(1e-9, 4096))).toBe(256);
  });
});

describe('what is said of the picture', () => {
  const figures: Figures = { samples: 64, seconds: 75.2, error: 0.04, pathsPerSecond: 2.5e6, reached: null };

  it('has samples, time, error and speed; then that it is complete or paused', () => {
    const picture = { kind: 'picture' as const, figures, denoising: null };
    expect(say(picture, false, null)).toBe('64 samples/pixel · 1 min 15 s · error 4.0 %');
    const device = { name: '2 CPU threads', note: 'this browser has no WebGPU' };
    expect(describeDevice(picture, device)).toBe(
      '2.5 Mpaths/s by 2 CPU threads, as this browser has no WebGPU',
    );
    expect(describeDevice({ kind: 'idle' }, { name: 'A GPU', note: '' })).toBe('A GPU');
    expect(say(picture, true, null)).toMatch(/paused$/);
    const complete = { ...picture, figures: { ...figures, reached: 'error' as const } };
    expect(say(complete, true, null)).toMatch(/complete$/);
    expect(say({ kind: 'failed', message: 'the scene takes 5 bytes' }, false, null)).toBe(
      'the scene takes 5 bytes',
    );
  });

  it('says whether the picture is denoised, and of how many samples', () => {
    const picture = { kind: 'picture' as const, figures, denoising: null };
    expect(say({ ...picture, denoising: 0.256 }, true, null)).toMatch(/paused · denoising 26 %$/);
    expect(say({ ...picture, denoising: 0.5 }, false, 32)).toMatch(/4.0 % · denoised at 32$/);
    expect(say(picture, true, 64)).toMatch(/paused · denoised$/);
  });

  it('is as complete as the nearer goal: the error needs four times the samples to halve', () => {
    const picture = { kind: 'picture' as const, figures, denoising: null };
    expect(fractionOf(picture, { samples: 128, error: 0 })).toBe(0.5);
    expect(fractionOf(picture, { samples: 6400, error: 0.02 })).toBe(0.25);
    expect(fractionOf({ kind: 'starting', phase: 'packing', part: 0 }, { samples: 1, error: 0 })).toBeNull();
  });
});
