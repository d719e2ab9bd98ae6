import { describe, expect, it } from 'vitest';
import { FrameTimes, percentile } from '../../src/editor/panels/status/frame-times.ts';

function times(...ms: number[]): FrameTimes {
  const result = new FrameTimes();
  let at = 0;
  for (const time of ms) {
    at += time;
    result.add(at, time);
  }
  return result;
}

describe('frame times', () => {
  it('mark the jump from 16 to 30 ms that a person sees', () => {
    const { samples } = times(16, 16, 17, 16, 16, 30, 16);
    expect(samples.map((sample) => sample.spike)).toEqual([false, false, false, false, false, true, false]);
  });

  it('do not call noise of fast frames a spike', () => {
    expect(times(1, 1, 1, 1, 2.5, 1).samples.some((sample) => sample.spike)).toBe(false);
  });

  it('take a lasting slowdown for the usual after a while', () => {
    const slow = times(...Array<number>(60).fill(16), ...Array<number>(60).fill(40));
    expect(slow.samples[60]?.spike).toBe(true);
    expect(slow.samples.at(-1)?.spike).toBe(false);
  });

  it('give percentiles by nearest rank, and frames of the last second', () => {
    const hundred = Array.from({ length: 100 }, (_, i) => i + 1);
    expect(percentile(hundred, 0.5)).toBe(50);
    expect(percentile(hundred, 0.95)).toBe(95);
    expect(percentile(hundred, 0.99)).toBe(99);
    expect(percentile([], 0.5)).toBeNaN();
    expect(times(500, 400, 300, 200).statistics(1600)).toMatchObject({
      count: 4,
      p50: 300,
      p99: 500,
      fps: 3,
    });
  });
});
