/**
 * Directs the path tracer, in a thread of its own: packs scenes, renders pass after pass, and tells the page. A new
 * wish ends what is under way: one for another camera only the pass, one for another scene the packing, too.
 */
import type { PathTracer } from '../../pathtracer/path-tracer.ts';
import { toAttributes } from '../../pathtracer/record.ts';
import type { PackedScene, PackOptions } from '../../pathtracer/scene/pack.ts';
import type { Document } from '../../scene/schema.ts';
import type { Denoise } from './denoiser.ts';
import { Denoising } from './denoising.ts';
import { applyChange } from './document-change.ts';
import type { Figures, FromDirector, Goal, ToDirector } from './messages.ts';
import { exrOf, halfFloats, tracedPicture } from './picture.ts';
import { nextPass } from './schedule.ts';

/** Between two pictures that the page is sent. */
const PICTURE_MS = 250;

/** An estimate of the error from fewer samples is not to be trusted: what is rare has not been met yet. */
const LEAST_SAMPLES_FOR_ERROR = 16;

export interface Stage {
  readonly tracer: PathTracer;
  /** The most bytes that a scene may have. */
  readonly maxBytes: number | undefined;
}

export interface DirectorOptions {
  pack(document: Document, options: PackOptions): Promise<PackedScene>;
  /** Called once, for the first rendering. */
  open(): Promise<Stage>;
  readonly denoise: Denoise;
  post(message: FromDirector, transfer?: Transferable[]): void;
}

type Wish = Extract<ToDirector, { kind: 'render' }>;
type ExrRequest = Extract<ToDirector, { kind: 'exr' }>;

/** A rendering that goes on. */
interface Rendering {
  readonly wish: Wish;
  samples: number;
  seconds: number;
  error: number;
  shownAt: number;
  shown: boolean;
}

export class Director {
  readonly #options: DirectorOptions;
  #stage: Promise<Stage> | null = null;
  #document: Document | null = null;
  /** Whether the tracer's scene is an older one. */
  #stale = true;
  #packed = 0;
  #wish: Wish | null = null;
  #rendering: Rendering | null = null;
  #goal: Goal = { samples: 1, error: 0 };
  #paused = false;
  #denoises = false;
  readonly #denoising: Denoising;
  #working = false;
  #packing = new AbortController();
  #pass = new AbortController();

  constructor(options: DirectorOptions) {
    this.#options = options;
    this.#denoising = new Denoising({
      denoise: options.denoise,
      onProgress: (part) => this.#tellDenoising(part),
      onEnd: (error) => this.#endDenoising(error),
    });
  }

  receive(message: ToDirector): void {
    if (message.kind === 'render') {
      if (message.change !== null) {
        this.#document = applyChange(this.#document, message.change);
        this.#stale = true;
        this.#packing.abort();
      }
      this.#wish = message;
      this.#pass.abort();
      this.#denoising.forget();
    } else if (message.kind === 'goal') this.#goal = message.goal;
    else if (message.kind === 'pause') {
      this.#paused = message.paused;
      if (message.paused) this.#pass.abort();
    } else if (message.kind === 'denoise') {
      this.#denoises = message.on;
      if (!message.on) this.#denoising.stop();
    } else void this.#saveExr(message);
    if (!this.#working) void this.#work();
  }

  async #work(): Promise<void> {
    this.#working = true;
    do {
      try {
        if (this.#wish !== null) await this.#begin(this.#wish);
        else if (this.#goesOn()) await this.#render(this.#rendering as Rendering);
        await this.#denoiseWhenDue();
      } catch (error) {
        if (!(error instanceof DOMException && error.name === 'AbortError')) this.#fail(error);
      }
    } while (this.#wish !== null || this.#goesOn());
    this.#working = false;
  }

  #goesOn(): boolean {
    return this.#rendering !== null && !this.#paused && this.#reached(this.#rendering) === null;
  }

  #reached({ samples, error }: Rendering): Figures['reached'] {
    if (samples >= this.#goal.samples) return 'samples';
    return samples >= LEAST_SAMPLES_FOR_ERROR && error <= this.#goal.error ? 'error' : null;
  }

  async #begin(wish: Wish): Promise<void> {
    const { ticket } = wish;
    this.#rendering = null;
    this.#stage ??= this.#options.open();
    const { tracer, maxBytes } = await this.#stage;
    if (this.#stale) {
      this.#packing = new AbortController();
      this.#options.post({ kind: 'phase', ticket, phase: 'packing', part: 0 });
      const scene = await this.#options.pack(this.#document as Document, {
        signal: this.#packing.signal,
        onProgress: (part) => this.#options.post({ kind: 'phase', ticket, phase: 'packing', part }),
        ...(maxBytes !== undefined && { maxBytes }),
      });
      this.#packing.signal.throwIfAborted();
      this.#packed += 1;
      this.#options.post({ kind: 'phase', ticket, phase: 'compiling', part: 0 });
      await tracer.load(scene);
      // A change that came meanwhile has begun nothing yet: the next turn packs it.
      this.#stale = this.#packing.signal.aborted;
    }
    if (this.#wish !== wish) return;
    this.#wish = null;
    tracer.start(wish.camera, wish.settings);
    this.#rendering = {
      wish,
      samples: 0,
      seconds: 0,
      error: Number.POSITIVE_INFINITY,
      shownAt: Number.NEGATIVE_INFINITY,
      shown: true,
    };
  }

  async #render(rendering: Rendering): Promise<void> {
    const { ticket } = rendering.wish;
    const { tracer } = await (this.#stage as Promise<Stage>);
    const count = nextPass(rendering.samples, rendering.seconds, this.#goal.samples);
    this.#pass = new AbortController();
    const { signal } = this.#pass;
    const began = performance.now();
    let told = began;
    try {
      await tracer.render(rendering.samples, count, {
        signal,
        onProgress: (part) => {
          // Later passes are short; the first one is what is waited for.
          if (rendering.samples > 0 || performance.now() < told + PICTURE_MS) return;
          told = performance.now();
          this.#options.post({ kind: 'phase', ticket, phase: 'tracing', part });
        },
      });
      rendering.samples += count;
      rendering.seconds += (performance.now() - began) / 1000;
      rendering.shown = false;
    } finally {
      if (this.#wish === null) await this.#show(tracer, rendering);
    }
  }

  async #show(tracer: PathTracer, rendering: Rendering): Promise<void> {
    const soon = performance.now() < rendering.shownAt + PICTURE_MS;
    if (rendering.shown || (soon && this.#goesOn())) return;
    const film = await tracer.film();
    const { samples, seconds, wish } = rendering;
    rendering.error = film.relativeError();
    const picture = tracedPicture(film);
    rendering.shown = true;
    rendering.shownAt = performance.now();
    const figures: Figures = {
      samples,
      seconds,
      error: rendering.error,
      pathsPerSecond: (samples * film.width * film.height) / seconds,
      reached: this.#reached(rendering),
    };
    this.#options.post({ kind: 'picture', ticket: wish.ticket, picture, figures, packed: this.#packed }, [
      picture.pixels.buffer,
    ]);
  }

  /** Between two passes, or at rest: the film does not change here. */
  async #denoiseWhenDue(): Promise<void> {
    const rendering = this.#rendering;
    if (!this.#denoises || rendering === null || this.#wish !== null) return;
    if (!this.#denoising.isDue(rendering.samples, !this.#goesOn())) return;
    const { tracer } = await (this.#stage as Promise<Stage>);
    const film = await tracer.film();
    if (this.#wish === null && this.#denoises) void this.#denoising.begin(film, rendering.samples);
  }

  #tellDenoising(part: number): void {
    if (this.#rendering === null) return;
    this.#options.post({ kind: 'denoising', ticket: this.#rendering.wish.ticket, part });
  }

  #endDenoising(error: unknown): void {
    const { result } = this.#denoising;
    if (this.#rendering === null) return;
    const { ticket, settings } = this.#rendering.wish;
    if (error !== null) {
      const message = error instanceof Error ? error.message : String(error);
      this.#options.post({ kind: 'not-denoised', ticket, message });
    } else if (result !== null) {
      const { width, height } = settings;
      const picture = { width, height, pixels: halfFloats(result.radiance, result.alpha) };
      this.#options.post({ kind: 'denoised', ticket, picture, samples: result.samples }, [
        picture.pixels.buffer,
      ]);
    }
    // More samples may have come meanwhile.
    if (!this.#working) void this.#work();
  }

  /** The next wish may do better; a tracer that lost its device is opened anew for it. */
  #fail(error: unknown): void {
    const ticket = this.#wish?.ticket ?? this.#rendering?.wish.ticket ?? 0;
    this.#denoising.forget();
    this.#wish = null;
    this.#rendering = null;
    this.#stale = true;
    void this.#stage?.then(
      ({ tracer }) => tracer.dispose(),
      () => {},
    );
    this.#stage = null;
    const message = error instanceof Error ? error.message : String(error);
    this.#options.post({ kind: 'failed', ticket, message });
  }

  async #saveExr({ origin, denoised: asDenoised }: ExrRequest): Promise<void> {
    const rendering = this.#rendering;
    if (rendering === null || this.#stage === null || rendering.samples === 0) {
      this.#options.post({ kind: 'exr', file: null });
      return;
    }
    const { tracer } = await this.#stage;
    const denoised = asDenoised ? this.#denoising.result : null;
    const samples = denoised?.samples ?? rendering.samples;
    const film = await tracer.film();
    const radiance = denoised?.noisy ?? film.mean();
    const isTransparent = this.#document?.background.type === 'transparent';
    const { camera, settings } = rendering.wish;
    const { seed, maxDepth, clamp, strategy } = settings;
    const attributes = toAttributes({
      ...origin,
      renderer: 'pathtracer',
      camera: JSON.stringify(camera),
      seed,
      maxDepth,
      clamp,
      strategy,
      // Every pixel has the same number: a pass counts only when it is whole.
      samples: [{ from: 0, to: samples }],
      device: tracer.device,
      denoised: denoised !== null,
    });
    const file = new Uint8Array(
      exrOf(
        film,
        radiance,
        denoised,
        attributes,
        isTransparent ? (denoised?.noisyAlpha ?? film.meanAlpha()) : null,
      ),
    );
    this.#options.post({ kind: 'exr', file }, [file.buffer]);
  }
}
