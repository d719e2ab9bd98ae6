import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { fromAttributes } from '../../../src/cli/render/record.ts';
import type { Denoise } from '../../../src/editor/path-tracing/denoiser.ts';
import { Director } from '../../../src/editor/path-tracing/director.ts';
import { changeOf } from '../../../src/editor/path-tracing/document-change.ts';
import type { FromDirector, Origin, ToDirector } from '../../../src/editor/path-tracing/messages.ts';
import { decodeExr } from '../../../src/io/exr.ts';
import { fromHalf } from '../../../src/io/half.ts';
import { FILM_FLOATS, Film } from '../../../src/pathtracer/film.ts';
import type { PassOptions, PathTracer } from '../../../src/pathtracer/path-tracer.ts';
import type { RenderSettings } from '../../../src/pathtracer/scene/camera.ts';
import type { PackedScene, PackOptions } from '../../../src/pathtracer/scene/pack.ts';
import { createDocument } from '../../../src/scene/document.ts';
import type { Camera } from '../../../src/scene/schema.ts';

const origin: Origin = {
  version: '1.2.3',
  document: 'a hash',
  name: 'A',
  until: 'samples 0:4',
  exposure: 0.5,
  toneMapping: 'neutral',
};
const settings: RenderSettings = { width: 2, height: 1, maxDepth: 4, seed: 0, strategy: 'mis', clamp: 0 };
const document = createDocument();
const scene = { words: new Uint32Array(), models: [], triangles: 0, lights: 0, stack: 0 } as PackedScene;

/** Every sample hits something of radiance 1, 2, 3. The test lets passes end by hand, or they end at once. */
class FakeTracer implements PathTracer {
  readonly device = 'a fake';
  readonly log: string[] = [];
  #film = new Film(0, 0);
  /** Passes that wait for the test. */
  held: (() => void)[] | null = null;
  failure: Error | null = null;

  async load(): Promise<void> {
    this.log.push('load');
  }

  start(camera: Camera, { width, height }: RenderSettings): void {
    this.log.push(`start ${camera.fov}`);
    this.#film = new Film(width, height);
  }

  async render(first: number, count: number, { signal }: PassOptions = {}): Promise<void> {
    this.log.push(`render ${first}+${count}`);
    if (this.failure) throw this.failure;
    if (this.held) {
      await new Promise<void>((resolve) => {
        this.held?.push(resolve);
        signal?.addEventListener('abort', () => resolve());
      });
    }
    signal?.throwIfAborted();
    const values = new Float32Array(FILM_FLOATS * 2);
    for (let pixel = 0; pixel < 2; pixel++) {
      values.set([count, 2 * count, 3 * count, count, count, 4 * count, 9 * count], FILM_FLOATS * pixel);
      values[FILM_FLOATS * pixel + 17] = count;
    }
    this.#film.add(values);
  }

  async film(): Promise<Film> {
    return this.#film;
  }

  dispose(): void {
    this.log.push('dispose');
  }
}

function setup(
  pack: (options: PackOptions) => Promise<PackedScene> = async () => scene,
  denoise: Denoise = async (film) => ({ radiance: film.mean().map((x) => 10 * x), alpha: null }),
) {
  const tracer = new FakeTracer();
  const messages: FromDirector[] = [];
  const director = new Director({
    pack: (_, options) => {
      tracer.log.push('pack');
      return pack(options);
    },
    open: async () => ({ tracer, maxBytes: undefined }),
    denoise,
    post: (message) => messages.push(message),
  });
  let ticket = 0;
  return {
    tracer,
    messages,
    send: (message: ToDirector) => director.receive(message),
    goal: (samples: number) => director.receive({ kind: 'goal', goal: { samples, error: 0 } }),
    render(fov: number, withScene = false) {
      ticket += 1;
      const change = withScene ? changeOf(null, document) : null;
      director.receive({ kind: 'render', ticket, change, camera: { ...document.camera, fov }, settings });
    },
    pictures: () => messages.filter((message) => message.kind === 'picture'),
  };
}

/** Every promise that can go on has gone on: none waits for more than others. */
const quiet = () => new Promise((resolve) => setTimeout(resolve));

// A busy machine would take the time that makes passes shorter.
beforeEach(() => void vi.spyOn(performance, 'now').mockReturnValue(0));
afterEach(() => void vi.restoreAllMocks());

describe('the director', () => {
  it('packs, renders 1, 1, 2, 4 samples up to the goal, and shows the mean', async () => {
    const { tracer, goal, render, pictures } = setup();
    goal(8);
    render(50, true);
    await quiet();
    expect(tracer.log).toEqual([
      'pack',
      'load',
      'start 50',
      'render 0+1',
      'render 1+1',
      'render 2+2',
      'render 4+4',
    ]);
    const { picture, figures, packed } = pictures().at(-1)!;
    expect(figures).toMatchObject({ samples: 8, reached: 'samples', error: 0 });
    expect(packed).toBe(1);
    expect([...picture.pixels].map(fromHalf)).toEqual([1, 2, 3, 1, 1, 2, 3, 1]);
  });

  it('begins anew for another camera without packing, and goes on when the goal is raised', async () => {
    const { tracer, goal, render } = setup();
    goal(1);
    render(50, true);
    await quiet();
    tracer.log.length = 0;
    render(60);
    await quiet();
    expect(tracer.log).toEqual(['start 60', 'render 0+1']);
    goal(2);
    await quiet();
    expect(tracer.log.at(-1)).toBe('render 1+1');
  });

  it('gives up the pass that is under way, and what it was for', async () => {
    const { tracer, goal, render, pictures } = setup();
    tracer.held = [];
    goal(1);
    render(50, true);
    await quiet();
    render(60);
    await quiet();
    expect(tracer.log.slice(-2)).toEqual(['start 60', 'render 0+1']);
    tracer.held.at(-1)?.();
    await quiet();
    expect(pictures().map(({ ticket }) => ticket)).toEqual([2]);
  });

  it('does not pack again for a camera that moves while a scene is packed, but does for another scene', async () => {
    const packing: { options: PackOptions; done(scene: PackedScene): void }[] = [];
    const { tracer, goal, render } = setup(
      (options) =>
        new Promise((resolve, reject) => {
          packing.push({ options, done: resolve });
          options.signal?.addEventListener('abort', () => reject(options.signal?.reason));
        }),
    );
    goal(1);
    render(50, true);
    await quiet();
    render(60);
    await quiet();
    expect(packing).toHaveLength(1);
    render(60, true);
    await quiet();
    expect(packing).toHaveLength(2);
    packing[1]?.done(scene);
    await quiet();
    expect(tracer.log).toEqual(['pack', 'pack', 'load', 'start 60', 'render 0+1']);
  });

  it('pauses in the middle and goes on with what it has', async () => {
    const { tracer, goal, render, send, pictures } = setup();
    goal(1);
    render(50, true);
    await quiet();
    tracer.held = [];
    goal(2);
    await quiet();
    send({ kind: 'pause', paused: true });
    await quiet();
    expect(pictures().at(-1)?.figures.samples).toBe(1);
    tracer.held = null;
    send({ kind: 'pause', paused: false });
    await quiet();
    expect(tracer.log.slice(-2)).toEqual(['render 1+1', 'render 1+1']);
    expect(pictures().at(-1)?.figures.samples).toBe(2);
  });

  it('says what failed, and opens and packs anew for the next wish', async () => {
    const { tracer, goal, render, messages, pictures } = setup();
    goal(1);
    tracer.failure = new Error('the device is lost');
    render(50, true);
    await quiet();
    expect(messages.at(-1)).toEqual({ kind: 'failed', ticket: 1, message: 'the device is lost' });
    expect(tracer.log.at(-1)).toBe('dispose');
    tracer.failure = null;
    render(60);
    await quiet();
    expect(tracer.log.slice(-4)).toEqual(['pack', 'load', 'start 60', 'render 0+1']);
    expect(pictures()).toHaveLength(1);
  });

  it('writes the film as an EXR that says how many samples it has', async () => {
    const { goal, render, send, messages } = setup();
    send({ kind: 'exr', origin, denoised: false });
    await quiet();
    expect(messages.at(-1)).toEqual({ kind: 'exr', file: null });
    goal(4);
    render(50, true);
    await quiet();
    send({ kind: 'exr', origin, denoised: false });
    await quiet();
    const message = messages.at(-1);
    const file = message?.kind === 'exr' ? message.file : null;
    const { channels, attributes } = decodeExr(file as Uint8Array, 'a.exr');
    expect(fromAttributes(attributes ?? {}, 'a.exr')).toEqual({
      ...origin,
      renderer: 'pathtracer',
      camera: JSON.stringify({ ...document.camera, fov: 50 }),
      seed: 0,
      maxDepth: 4,
      clamp: 0,
      strategy: 'mis',
      samples: [{ from: 0, to: 4 }],
      device: 'a fake',
      denoised: false,
    });
    expect(channels.map(({ name, pixels }) => [name, ...pixels])).toEqual([
      ['B', 3, 3],
      ['G', 2, 2],
      ['R', 1, 1],
    ]);
  });

  it('denoises each time that the samples have doubled and at the end, and writes both layers', async () => {
    const { goal, render, send, messages } = setup();
    send({ kind: 'denoise', on: true });
    goal(20);
    render(50, true);
    await quiet();
    const denoised = messages.filter((message) => message.kind === 'denoised');
    expect(denoised.map(({ samples }) => samples)).toEqual([4, 8, 16, 20]);
    expect([...denoised.at(-1)!.picture.pixels].map(fromHalf)).toEqual([10, 20, 30, 1, 10, 20, 30, 1]);
    send({ kind: 'exr', origin, denoised: true });
    await quiet();
    const message = messages.at(-1);
    const file = message?.kind === 'exr' ? message.file : null;
    const { channels, attributes } = decodeExr(file as Uint8Array, 'a.exr');
    expect(attributes).toMatchObject({ 'irradia:samples': '0:20', 'irradia:denoised': 'yes' });
    expect(channels.map(({ name, pixels }) => [name, pixels[0]])).toEqual([
      ['B', 30],
      ['G', 20],
      ['R', 10],
      ['noisy.B', 3],
      ['noisy.G', 2],
      ['noisy.R', 1],
    ]);
  });

  it('ends the denoising for another picture, and denoises what rests when that is asked for', async () => {
    const jobs: AbortSignal[] = [];
    const { goal, render, send, messages } = setup(undefined, (_, { signal }) => {
      jobs.push(signal as AbortSignal);
      return new Promise((_resolve, reject) => {
        signal?.addEventListener('abort', () => reject(signal.reason));
      });
    });
    goal(1);
    render(50, true);
    await quiet();
    send({ kind: 'denoise', on: true });
    await quiet();
    render(60);
    await quiet();
    expect(jobs.map(({ aborted }) => aborted)).toEqual([true, false]);
    send({ kind: 'denoise', on: false });
    await quiet();
    expect(jobs[1]?.aborted).toBe(true);
    expect(messages.some(({ kind }) => kind === 'denoised' || kind === 'not-denoised')).toBe(false);
  });
});
