/** How long frames and pictures wait for what is compiled ahead of them. */
import { BoxGeometry, Mesh, MeshBasicMaterial, Scene, Texture } from 'three/webgpu';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { FRAME_MS, PICTURE_MS, Readiness } from '../../../src/editor/viewport/readiness.ts';

interface Compilation {
  readonly meshes: readonly Mesh[];
  end(): void;
  fail(error: unknown): void;
}

let scene: Scene;
let compilations: Compilation[];
let late: number;
let waits: 'yes' | 'not yet' | 'no';
let readiness: Readiness;
const add = () => {
  const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
  scene.add(mesh);
  readiness.grown();
  return mesh;
};
/** What a wait has come to, without waiting for it. */
const watch = (promise: Promise<unknown>) => {
  const watched = { state: 'waits' };
  promise.then(
    () => {
      watched.state = 'over';
    },
    (error: Error) => {
      watched.state = error.message;
    },
  );
  return watched;
};
const pass = (ms = 0) => vi.advanceTimersByTimeAsync(ms);

beforeEach(() => {
  vi.useFakeTimers();
  scene = new Scene();
  compilations = [];
  late = 0;
  waits = 'yes';
  readiness = new Readiness({
    scene,
    drawn: () => scene.children.filter((child) => child instanceof Mesh),
    compile: (meshes) =>
      new Promise((end, fail) => {
        compilations.push({ meshes, end, fail });
      }),
    waits: () => waits,
    onLate: () => {
      late += 1;
    },
  });
});
afterEach(() => {
  vi.useRealTimers();
});

describe('a frame', () => {
  it('waits for what was never drawn, and for what comes while it waits, of which it asks once', async () => {
    const first = add();
    const frame = watch(readiness.ready());
    await pass();
    const second = add();
    compilations[0]?.end();
    await pass();
    expect([compilations.map(({ meshes }) => meshes), frame.state]).toEqual([[[first], [second]], 'waits']);
    compilations[1]?.end();
    await pass();
    expect([frame.state, readiness.mayBeUnready, late]).toEqual(['over', false, 0]);
  });

  it('is drawn all the same when compiling fails', async () => {
    add();
    const frame = watch(readiness.ready());
    compilations[0]?.fail(new Error('gone'));
    await pass();
    expect([frame.state, late]).toEqual(['over', 0]);
  });

  it('is drawn after a while when compiling does not end, and again when it has', async () => {
    add();
    const frame = watch(readiness.ready());
    await pass(FRAME_MS - 1);
    expect(frame.state).toBe('waits');
    await pass(1);
    expect([frame.state, readiness.mayBeUnready, late]).toEqual(['over', false, 0]);
    compilations[0]?.end();
    await pass();
    expect(late).toBe(1);
  });

  it('is drawn after a while, however often the scene changes meanwhile', async () => {
    add();
    const frame = watch(readiness.ready());
    for (let i = 0; i < 20; i++) {
      await pass(FRAME_MS / 20);
      add();
      compilations.at(-1)?.end();
    }
    await pass();
    expect(frame.state).toBe('over');
  });

  it('waits for nothing at the page’s start, nor where data are shown; then for another environment', async () => {
    waits = 'not yet';
    add();
    await readiness.ready();
    expect([compilations, readiness.mayBeUnready]).toEqual([[], false]);
    waits = 'no';
    const mesh = add();
    await readiness.ready();
    expect(compilations).toEqual([]);
    waits = 'yes';
    const frame = watch(readiness.ready());
    expect(compilations.map(({ meshes }) => meshes)).toEqual([[mesh]]);
    compilations[0]?.end();
    await pass();
    scene.environment = new Texture();
    expect([frame.state, readiness.mayBeUnready]).toEqual(['over', true]);
  });
});

describe('a picture that stays', () => {
  it('waits for what frames no longer wait for', async () => {
    add();
    const frame = watch(readiness.ready());
    await pass(FRAME_MS);
    const picture = watch(readiness.whole());
    await pass(FRAME_MS);
    expect([frame.state, picture.state]).toEqual(['over', 'waits']);
    compilations[0]?.end();
    await pass();
    expect(picture.state).toBe('over');
  });

  it('has what no frame has looked for yet compiled, which the next frame waits for, too', async () => {
    add();
    const picture = watch(readiness.whole());
    await pass();
    expect([compilations.length, readiness.mayBeUnready]).toEqual([1, true]);
    const frame = watch(readiness.ready());
    compilations[0]?.end();
    await pass();
    expect([compilations.length, picture.state, frame.state]).toEqual([1, 'over', 'over']);
  });

  it('does not wait for ever', async () => {
    add();
    const picture = watch(readiness.whole());
    await pass(PICTURE_MS);
    expect(picture.state).toBe('over');
  });

  it('waits for effects that are compiled, which gives up as late', async () => {
    readiness.ready();
    let end = () => {};
    const effects = watch(readiness.follow(new Promise<void>((resolve) => (end = resolve))));
    const picture = watch(readiness.whole());
    await pass(PICTURE_MS - 1);
    expect([effects.state, picture.state]).toEqual(['waits', 'waits']);
    await pass(1);
    expect([effects.state, picture.state, late]).toEqual(['over', 'over', 0]);
    end();
    await pass();
    expect(late).toBe(1);
    await expect(readiness.follow(Promise.reject(new Error('no shader')))).rejects.toThrow('no shader');
  });
});
