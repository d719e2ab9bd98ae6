/** Threads that answer questions, and documents on their way to them. */
import { afterEach, expect, it, vi } from 'vitest';
import { receivedDocument, type SentDocument } from '../../src/editor/threads/sent-assets.ts';
import { Thread, ThreadEnded, type ToThread } from '../../src/editor/threads/thread.ts';
import { createDocument } from '../../src/scene/document.ts';

class FakeWorker extends EventTarget {
  readonly asked: ToThread<string>[] = [];
  readonly terminate = vi.fn();
  postMessage(message: ToThread<string>): void {
    this.asked.push(message);
  }
  say(data: object): void {
    this.dispatchEvent(new MessageEvent('message', { data }));
  }
}

function threadWithWorkers() {
  const workers: FakeWorker[] = [];
  const thread = new Thread<string, number>(() => {
    workers.push(new FakeWorker());
    return workers.at(-1) as FakeWorker;
  });
  return { thread, workers };
}

afterEach(() => vi.useRealTimers());

it('gives every question its answer, in whatever order they come', async () => {
  const { thread, workers } = threadWithWorkers();
  expect(workers).toHaveLength(0);
  const [a, b, c] = ['a', 'b', 'c'].map((question) => thread.ask(question));
  const [one, two, three] = workers[0]!.asked;
  workers[0]!.say({ ticket: three!.ticket, answer: 3 });
  workers[0]!.say({ ticket: one!.ticket, answer: 1 });
  workers[0]!.say({ ticket: two!.ticket, refusal: 'no b' });
  expect(await a).toBe(1);
  await expect(b).rejects.toThrow('no b');
  expect(await c).toBe(3);
  expect(workers).toHaveLength(1);
});

it('ends when nobody has asked for a while, not while somebody waits, and starts again', async () => {
  vi.useFakeTimers();
  const { thread, workers } = threadWithWorkers();
  const slow = thread.ask('slow');
  vi.advanceTimersByTime(3_600_000);
  workers[0]!.say({ ticket: workers[0]!.asked[0]!.ticket, answer: 7 });
  expect(await slow).toBe(7);
  expect(workers[0]!.terminate).not.toHaveBeenCalled();
  const { life } = thread;
  vi.advanceTimersByTime(60_000);
  expect(workers[0]!.terminate).toHaveBeenCalledOnce();
  expect(thread.life).not.toBe(life);
  void thread.ask('again');
  expect(workers).toHaveLength(2);
});

it('a thread that breaks down fails what was asked of it, and is replaced', async () => {
  const { thread, workers } = threadWithWorkers();
  const lost = thread.ask('lost');
  workers[0]!.dispatchEvent(Object.assign(new Event('error'), { message: 'out of memory' }));
  await expect(lost).rejects.toThrow('out of memory');
  const given = thread.ask('given up');
  expect(workers).toHaveLength(2);
  // A late word of the first one ends nothing.
  workers[0]!.dispatchEvent(new Event('error'));
  thread.end();
  await expect(given).rejects.toThrow(ThreadEnded);
});

it('a document whose assets were sent as bytes arrives as it was', async () => {
  const data = Buffer.from([1, 2, 3, 255]).toString('base64');
  const asset = { name: 'a.bin', mediaType: 'application/octet-stream', data };
  const document = { ...createDocument('Sent'), assets: { a: asset, b: asset } };
  const sent: SentDocument = {
    ...document,
    assets: { a: { ...asset, data: new Blob([Buffer.from(data, 'base64')]) }, b: asset },
  };
  expect(await receivedDocument(sent)).toEqual(document);
});

it('takes over a worker that is at work already, which ends like any other, and says what failed', async () => {
  vi.useFakeTimers();
  const running = new FakeWorker();
  const spawn = vi.fn(() => new FakeWorker());
  const options = { name: 'large.glb', running };
  const idle = new Thread<string, number>(spawn, options);
  vi.advanceTimersByTime(60_000);
  expect(running.terminate).toHaveBeenCalledOnce();
  const thread = new Thread<string, number>(spawn, options);
  const answer = thread.ask('a');
  running.dispatchEvent(Object.assign(new Event('error'), { message: 'out of memory' }));
  await expect(answer).rejects.toThrow('large.glb: out of memory');
  expect(spawn).not.toHaveBeenCalled();
  void thread.ask('b');
  void idle.ask('c');
  expect(spawn).toHaveBeenCalledTimes(2);
});
