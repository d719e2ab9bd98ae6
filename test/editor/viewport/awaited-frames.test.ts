import { expect, it } from 'vitest';
import { AwaitedFrames } from '../../../src/editor/viewport/awaited-frames.ts';

const outcomes = async (waits: Promise<void>[]) => {
  const pending = Symbol();
  return Promise.all(
    waits.map((wait) =>
      Promise.race([wait.then(() => 'drawn'), Promise.resolve(pending).then(() => pending)]).then(
        (outcome) => (outcome === pending ? 'waits' : outcome),
        ({ message }: Error) => message,
      ),
    ),
  );
};

it('a wait ends with a frame that began after it', async () => {
  const frames = new AwaitedFrames();
  const first = frames.next();
  expect(frames.areAwaited).toBe(true);
  const finished = frames.begin();
  const second = frames.next();
  finished();
  expect(await outcomes([first, second])).toEqual(['drawn', 'waits']);
  frames.begin()();
  expect(await outcomes([second])).toEqual(['drawn']);
  expect(frames.areAwaited).toBe(false);
});

it('no wait outlasts an error that ends the drawing: not those of a frame under way, nor any after it', async () => {
  const frames = new AwaitedFrames();
  const begun = frames.next();
  frames.begin();
  const waiting = frames.next();
  frames.fail(new Error('no GPU'));
  expect(await outcomes([begun, waiting, frames.next()])).toEqual(['no GPU', 'no GPU', 'no GPU']);
});
