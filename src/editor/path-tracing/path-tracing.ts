/**
 * The path traced picture of what the viewport shows. It is asked for when the camera and the document have been at
 * rest for a moment, and is gone as soon as either moves; between, it grows.
 */
import { DataTexture, HalfFloatType, LinearFilter, RGBAFormat } from 'three/webgpu';
import type { Camera, Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { toastError } from '../ui/toast.ts';
import { changeOf, sameScene } from './document-change.ts';
import type { Device, Figures, FromDirector, Phase, ToDirector, TracedPicture } from './messages.ts';
import { originOf } from './origin.ts';

/** So long nothing may have moved. */
const REST_MS = 150;

/** What is looked at, in pixels of the radiance. */
export interface Look {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

export type TracingState =
  /** Nobody wants the picture, or something moves. */
  | { readonly kind: 'idle' }
  | { readonly kind: 'starting'; readonly phase: Phase; readonly part: number }
  | {
      readonly kind: 'picture';
      readonly figures: Figures;
      /** How much of the denoising is done; null while none goes on. */
      readonly denoising: number | null;
    }
  | { readonly kind: 'failed'; readonly message: string };

/** What distinguishes one picture from another. */
interface Wish {
  /** Camera, size and settings. */
  readonly key: string;
  readonly document: Document;
}

const sameWish = (a: Wish | null, b: Wish): boolean =>
  a !== null && a.key === b.key && sameScene(a.document, b.document);

export interface PathTracingOptions {
  readonly session: Session;
  /** The picture is new, or gone. */
  onPicture(): void;
  /** What pictures are shown with, in EV. */
  exposure(): number;
}

export class PathTracing {
  readonly #options: PathTracingOptions;
  readonly #listeners = new Set<() => void>();
  #director: Worker | null = null;
  #look: Look | null = null;
  #restTimer = 0;
  #ticket = 0;
  /** What is asked for when the time of rest is over. */
  #waiting: Wish | null = null;
  /** What the director was asked for last, if it is still looked at. */
  #asked: Wish | null = null;
  #sentDocument: Document | null = null;
  #state: TracingState = { kind: 'idle' };
  #device: Device | null = null;
  #texture: DataTexture | null = null;
  #noisy: TracedPicture | null = null;
  #denoised: { readonly picture: TracedPicture; readonly samples: number } | null = null;
  #packed = 0;
  #waitingForExr: ((file: Uint8Array<ArrayBuffer> | null) => void)[] = [];

  constructor(options: PathTracingOptions) {
    this.#options = options;
    const { store, state } = options.session;
    store.subscribe(({ document, previous }) => {
      if (document.pathTracing !== previous.pathTracing && this.#director !== null) this.#sendGoal();
      this.#follow();
    });
    state.subscribe((now, before) => {
      const denoise = now.denoise !== before.denoise;
      if (now.rendering === before.rendering && now.tracingPaused === before.tracingPaused && !denoise)
        return;
      this.#sendPause();
      if (denoise && this.#state.kind === 'picture') this.#showPicture(this.#state.figures, null);
      this.#follow();
      this.#changed();
    });
  }

  get state(): TracingState {
    return this.#state;
  }

  get device(): Device | null {
    return this.#device;
  }

  /** The mean radiance so far of what is looked at, denoised if that is shown; null while there is none. */
  get texture(): DataTexture | null {
    return this.#state.kind === 'picture' ? this.#texture : null;
  }

  /** Samples of a pixel that the denoised picture was made of; null while that is not what is shown. */
  get denoised(): number | null {
    const isShown = this.#options.session.state.value.denoise && this.#state.kind === 'picture';
    return isShown ? (this.#denoised?.samples ?? null) : null;
  }

  /** Renderings begun, and scenes packed for them. */
  get counts(): { renderings: number; packed: number } {
    return { renderings: this.#ticket, packed: this.#packed };
  }

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Tells what is looked at; may be told as often as one likes. */
  look(look: Look): void {
    this.#look = look;
    this.#follow();
  }

  /** The film as an EXR file; with the denoised picture if that is shown. */
  async exr(): Promise<Uint8Array<ArrayBuffer>> {
    const { document } = this.#options.session.store;
    const ticket = this.#ticket;
    const origin = await originOf(document, this.#options.exposure());
    const file =
      ticket === this.#ticket &&
      this.#state.kind === 'picture' &&
      (await new Promise<Uint8Array<ArrayBuffer> | null>((resolve) => {
        this.#waitingForExr.push(resolve);
        this.#send({ kind: 'exr', origin, denoised: this.denoised !== null });
      }));
    if (!file) throw new Error(t('There is no path traced picture yet.'));
    return file;
  }

  get #wanted(): boolean {
    return this.#options.session.state.value.rendering !== 'interactive';
  }

  /** Ends a picture that is no longer of what is looked at, and asks for the next one at rest. */
  #follow(): void {
    if (this.#look === null) return;
    const { document } = this.#options.session.store;
    const wish = { key: keyOf(this.#look, document), document };
    if (sameWish(this.#asked, wish)) return;
    if (this.#asked !== null) {
      this.#asked = null;
      this.#setState({ kind: 'idle' });
      this.#sendPause();
    }
    if (this.#wanted && sameWish(this.#waiting, wish)) return;
    clearTimeout(this.#restTimer);
    this.#waiting = this.#wanted ? wish : null;
    if (this.#wanted) this.#restTimer = window.setTimeout(() => this.#ask(), REST_MS);
  }

  #ask(): void {
    if (this.#look === null) return;
    const { document } = this.#options.session.store;
    const { camera, width, height } = this.#look;
    const { maxDepth, seed, clamp } = document.pathTracing;
    this.#asked = this.#waiting;
    this.#waiting = null;
    this.#denoised = null;
    this.#ticket += 1;
    const scene = this.#sentDocument === null || !sameScene(this.#sentDocument, document);
    this.#sendGoal();
    this.#send({
      kind: 'render',
      ticket: this.#ticket,
      change: scene ? changeOf(this.#sentDocument, document) : null,
      camera,
      settings: { width, height, maxDepth, seed, clamp, strategy: 'mis' },
    });
    if (scene) this.#sentDocument = document;
    this.#setState({ kind: 'starting', phase: scene ? 'packing' : 'tracing', part: 0 });
    this.#sendPause();
  }

  #sendGoal(): void {
    const { samples, error } = this.#options.session.store.document.pathTracing;
    this.#send({ kind: 'goal', goal: { samples, error } });
  }

  /** While something moves, the machine is the interactive view's alone. */
  #sendPause(): void {
    if (this.#director === null) return;
    const { tracingPaused, denoise } = this.#options.session.state.value;
    const rests = this.#asked === null || !this.#wanted;
    this.#send({ kind: 'denoise', on: denoise && !rests });
    this.#send({ kind: 'pause', paused: rests || tracingPaused });
  }

  #send(message: ToDirector): void {
    this.#director ??= this.#spawn();
    this.#director.postMessage(message);
  }

  #spawn(): Worker {
    const worker = new Worker(new URL('./director-worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<FromDirector>) => this.#receive(data));
    worker.addEventListener('error', (event) => {
      worker.terminate();
      this.#director = null;
      this.#sentDocument = null;
      const why = event.message || 'its worker could not be loaded';
      this.#setState({ kind: 'failed', message: `The path tracer stopped: ${why}` });
    });
    return worker;
  }

  #receive(message: FromDirector): void {
    if (message.kind === 'device') {
      this.#device = message.device;
      this.#changed();
    } else if (message.kind === 'exr') this.#waitingForExr.shift()?.(message.file);
    else if (this.#asked === null || message.ticket !== this.#ticket) return;
    else if (message.kind === 'phase') {
      const { phase, part } = message;
      if (this.#state.kind !== 'picture') this.#setState({ kind: 'starting', phase, part });
    } else if (message.kind === 'failed') this.#setState({ kind: 'failed', message: message.message });
    else if (message.kind === 'not-denoised') {
      toastError(t('The picture could not be denoised'), new Error(message.message));
      if (this.#state.kind === 'picture') this.#setState({ ...this.#state, denoising: null });
    } else if (message.kind === 'denoising') {
      if (this.#state.kind === 'picture') this.#setState({ ...this.#state, denoising: message.part });
    } else if (message.kind === 'denoised') {
      const { picture, samples } = message;
      this.#denoised = { picture, samples };
      if (this.#state.kind === 'picture') this.#showPicture(this.#state.figures, null);
    } else {
      this.#packed = message.packed;
      this.#noisy = message.picture;
      this.#showPicture(message.figures, this.#state.kind === 'picture' ? this.#state.denoising : null);
    }
  }

  #showPicture(figures: Figures, denoising: number | null): void {
    const denoised = this.#options.session.state.value.denoise ? this.#denoised : null;
    const shown = denoised?.picture ?? this.#noisy;
    if (shown !== null && this.#texture?.image.data !== shown.pixels) this.#upload(shown);
    this.#setState({ kind: 'picture', figures, denoising });
  }

  #upload({ width, height, pixels }: TracedPicture): void {
    const old = this.#texture?.image;
    if (old?.width !== width || old.height !== height) {
      this.#texture?.dispose();
      this.#texture = new DataTexture(pixels, width, height, RGBAFormat, HalfFloatType);
      this.#texture.minFilter = LinearFilter;
      this.#texture.magFilter = LinearFilter;
    } else old.data = pixels;
    (this.#texture as DataTexture).needsUpdate = true;
  }

  #setState(state: TracingState): void {
    const before = this.#state.kind;
    if (before === 'idle' && state.kind === 'idle') return;
    this.#state = state;
    if (before === 'picture' || state.kind === 'picture') this.#options.onPicture();
    this.#changed();
  }

  #changed(): void {
    for (const listener of this.#listeners) listener();
  }
}

function keyOf({ camera, width, height }: Look, { pathTracing }: Document): string {
  // Neither clipping nor exposure is seen in the radiance.
  const { near, far, shutter, iso, ...seen } = camera;
  const { samples, error, ...settings } = pathTracing;
  return JSON.stringify([seen, width, height, settings]);
}
