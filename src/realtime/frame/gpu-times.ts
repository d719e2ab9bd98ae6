/** What the GPU spends on the parts of a frame, by its own clock: each effect's passes, the scene, the output. */
import type { WebGPURenderer } from 'three/webgpu';

export interface GpuTime {
  /** An effect, or 'surfaces', 'scene' or 'output'. */
  readonly name: string;
  readonly milliseconds: number;
}

/** What three.js keeps of the queries: a name with the number of the pass in its frame, and of the frame. */
interface Queries {
  readonly timestamps: ReadonlyMap<string, number>;
}
interface Backend {
  trackTimestamp: boolean;
  readonly hasTimestamp: boolean;
  readonly timestampQueryPool: { readonly render: Queries | null };
}

/**
 * Passes are told apart by their numbers in the frame, which three.info counts from its reset() on. Switched off, nothing
 * is asked of the GPU. What an effect adds to the shading of the scene, such as looking up shadows, is in the scene's time.
 */
export class GpuTimes {
  readonly #three: WebGPURenderer;
  /** Of the frame under way and of those not read yet, by pass: the part it belongs to. */
  #parts = new Map<string, string>();
  #last = 0;

  constructor(three: WebGPURenderer) {
    this.#three = three;
  }

  /** Whether browser and GPU have such a clock. */
  get available(): boolean {
    return this.#backend.hasTimestamp;
  }

  get on(): boolean {
    return this.#backend.trackTimestamp;
  }

  set on(value: boolean) {
    this.#backend.trackTimestamp = value && this.available;
    this.#parts.clear();
  }

  /** A frame begins. */
  begin(): void {
    this.#last = 0;
  }

  /** The passes that were drawn since the last call are of this part. */
  mark(name: string): void {
    const { render } = this.#three.info;
    if (this.on) {
      for (let pass = this.#last + 1; pass <= render.frameCalls; pass++)
        this.#parts.set(this.#key(pass, this.#three.info.frame), name);
    }
    this.#last = render.frameCalls;
  }

  /** Of the last frame that the GPU has finished, in the order of drawing; null if there is none. */
  async read(): Promise<readonly GpuTime[] | null> {
    if (!this.on) return null;
    const parts = this.#parts;
    this.#parts = new Map();
    await this.#three.resolveTimestampsAsync('render');
    const queries = [...(this.#backend.timestampQueryPool.render?.timestamps ?? [])].map(([id, ms]) => {
      // r:PASS:CONTEXT:fFRAME
      const [, pass, , frame = ''] = id.split(':');
      return { pass: Number(pass), frame: Number(frame.slice(1)), ms };
    });
    const newest = Math.max(...queries.map(({ frame }) => frame));
    const times = new Map<string, number>();
    for (const { pass, frame, ms } of queries) {
      const name = parts.get(this.#key(pass, frame));
      if (frame === newest && name !== undefined) times.set(name, (times.get(name) ?? 0) + ms);
    }
    return times.size === 0 ? null : [...times].map(([name, milliseconds]) => ({ name, milliseconds }));
  }

  #key(pass: number, frame: number): string {
    return `${pass} ${frame}`;
  }

  get #backend(): Backend {
    return this.#three.backend as unknown as Backend;
  }
}
