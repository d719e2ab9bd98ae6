/**
 * What a frame needs, compiled before it. A frame waits for that for a while and is then drawn as it is: on WebGPU three.js leaves
 * out what has no shader yet. Pictures that are to be kept wait longer. Nothing waits for ever: a compilation may never end.
 */
import type { Mesh, Scene } from 'three/webgpu';
import { settledWithin } from '../../realtime/patience.ts';
import { UnreadyMeshes } from './unready.ts';

export interface ReadinessOptions {
  readonly scene: Scene;
  /** What the scene is drawn with. */
  drawn(): readonly Mesh[];
  /** For the picture as it is by now. */
  compile(meshes: readonly Mesh[]): Promise<void>;
  /** Whether frames wait at present: data are drawn with other materials, and at the page's start nothing has to be kept alive. */
  waits(): 'yes' | 'not yet' | 'no';
  /** What was no longer waited for has come: the picture lacks it. */
  onLate(): void;
}

/** A hand that goes on editing still sees the picture follow. */
export const FRAME_MS = 2000;
/** Some drivers take seconds for one large shader. */
export const PICTURE_MS = 10_000;

export class Readiness {
  readonly #options: ReadinessOptions;
  readonly #unready = new UnreadyMeshes();
  /** The scene may have meshes that were never drawn. */
  #grown = true;
  /** What is being compiled, waited for or not. */
  readonly #compiling = new Set<Promise<void>>();
  #making: Promise<void> | null = null;

  constructor(options: ReadinessOptions) {
    this.#options = options;
  }

  /** The scene has changed. */
  grown(): void {
    this.#grown = true;
  }

  /** A frame has to wait for ready(), if only for what is looked for there. */
  get mayBeUnready(): boolean {
    return this.#making !== null || this.#isUnknown;
  }

  /** Resolves when the scene can be drawn whole, or when a frame has waited long enough. */
  ready(): Promise<void> {
    this.#making ??= this.#make().finally(() => {
      this.#making = null;
    });
    return this.#making;
  }

  /** For a picture that stays: resolves when nothing is being compiled any more, or when that has taken too long. */
  async whole(): Promise<void> {
    const end = performance.now() + PICTURE_MS;
    while (performance.now() < end) {
      if (this.mayBeUnready) await this.ready();
      if (this.#compiling.size === 0) return;
      await settledWithin(end - performance.now(), Promise.all(this.#compiling));
    }
  }

  /** Waits for what is compiled, which rejects if that does; not longer than a picture does. */
  async follow(compiling: Promise<void>): Promise<void> {
    if (await this.#within(PICTURE_MS, compiling)) await compiling;
  }

  get #isUnknown(): boolean {
    return this.#grown || this.#unready.hasOtherEnvironment(this.#options.scene);
  }

  async #make(): Promise<void> {
    const { scene, drawn, compile, waits } = this.#options;
    const end = performance.now() + FRAME_MS;
    while (this.#isUnknown && waits() !== 'no' && performance.now() < end) {
      this.#grown = false;
      const meshes = this.#unready.take(scene, drawn());
      // What has gone meanwhile can fail, and is not in the frame, which says itself what cannot be drawn.
      if (meshes.length > 0 && waits() === 'yes')
        await this.#within(end - performance.now(), compile(meshes));
    }
  }

  async #within(ms: number, compiling: Promise<void>): Promise<boolean> {
    const settled = compiling
      .catch(() => {})
      .then(() => {
        this.#compiling.delete(settled);
      });
    this.#compiling.add(settled);
    const isInTime = await settledWithin(ms, settled);
    if (!isInTime) void settled.then(this.#options.onLate);
    return isInTime;
  }
}
