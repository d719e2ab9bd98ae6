/**
 * The viewport: keeps the picture equal to the document. It alone knows the renderer; panels change
 * the document and never ask for a frame.
 */

import type { Companion } from '../../realtime/output-pass.ts';
import type { RealtimeRenderer, Size } from '../../realtime/renderer.ts';
import { uploadAhead } from '../../realtime/upload.ts';
import type { SceneMirror } from '../../scene/mirror.ts';
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import { nextTask } from '../next-task.ts';
import type { FrameTimes } from '../panels/status/frame-times.ts';
import type { RenderFigures } from '../panels/status/status.ts';
import type { ImagePair } from '../path-tracing/difference.ts';
import { PathTracing } from '../path-tracing/path-tracing.ts';
import { createPathTracingView, type PathTracingView } from '../path-tracing/view.ts';
import type { Session } from '../session.ts';
import type { EditorState } from '../state.ts';
import { h } from '../ui/dom.ts';
import { toastError } from '../ui/toast.ts';
import { AwaitedFrames } from './awaited-frames.ts';
import { type CameraControl, createCameraControl } from './camera.ts';
import { installEnvironmentDrag } from './environment-drag.ts';
import { FrameLoop } from './frame-loop.ts';
import { gpuFinished } from './gpu-finish.ts';
import { Hands } from './hands.ts';
import { leastFrameTime } from './measure-frame.ts';
import { MovingResolution } from './moving-resolution.ts';
import { Outlines } from './outlines.ts';
import { middleOf, pngOf, readPair, shownPixels, tracedPng } from './pictures.ts';
import { installPixelReading } from './pixel-reading.ts';
import { Readiness } from './readiness.ts';
import { createShowView, type ShowView } from './show.ts';
import { countScene, type SceneCounts } from './statistics.ts';

export interface ViewportOptions {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly session: Session;
  readonly mirror: SceneMirror;
  readonly renderer: RealtimeRenderer;
  readonly times: FrameTimes;
  onFigures(figures: RenderFigures): void;
}

/** Another picture of what the viewport shows; `divider` is the part of the width that is not its. */
export interface Beside {
  draw(document: Document, size: Size, divider: number): Companion | null;
  /** As it was drawn last. */
  last(divider: number): Companion | null;
}

/** What takes less is not worth a word. */
const BUSY_AFTER_MS = 250;

export class Viewport {
  readonly #options: ViewportOptions;
  readonly #busy = h('div', { class: 'busy', role: 'status', hidden: true }, t('Loading…'));
  readonly #loop: FrameLoop;
  readonly #camera: CameraControl;
  readonly hands: Hands;
  readonly tracing: PathTracing;
  readonly #tracingView: PathTracingView;
  readonly #show: ShowView;
  readonly #outlines: Outlines;
  /** The scene or its place on the screen has changed since it was drawn. */
  #stale = true;
  #counts: SceneCounts = { vertices: 0, triangles: 0 };
  readonly #awaited = new AwaitedFrames();
  readonly #resolution = new MovingResolution(() => this.#redraw(false));
  /** When the GPU had finished the last frame. */
  #finishedAt = 0;
  /** Something is being made ready that a frame would undo. */
  #held = 0;
  /** A frame waits for what it needs. */
  #isWaiting = false;
  readonly #readiness: Readiness;
  #beside: Beside | null = null;

  constructor(options: ViewportOptions) {
    const { element, canvas, session, mirror, times } = options;
    this.#options = options;
    element.append(this.#busy);
    this.#loop = new FrameLoop({
      render: () => this.#render(),
      onFrame: (at, ms) => times.add(at, ms),
      onError: (error) => {
        this.#loop.stop();
        this.#awaited.fail(error);
        toastError(t('The picture could not be drawn'), error);
      },
    });
    this.#readiness = new Readiness({
      scene: mirror.scene,
      drawn: () => options.renderer.drawn(mirror.scene),
      compile: async (meshes) => {
        await uploadAhead(options.renderer.three, meshes, nextTask);
        await options.renderer.compile(mirror, session.store.document, this.#sizes().size, meshes);
      },
      waits: () => {
        if (session.store.document.view.show !== 'picture') return 'no';
        // At the page's start pieces take longer.
        return this.#finishedAt > 0 ? 'yes' : 'not yet';
      },
      onLate: () => this.#redraw(false),
    });
    this.tracing = new PathTracing({
      session,
      onPicture: () => this.#loop.request(),
      exposure: () => options.renderer.exposure(session.store.document.view),
    });
    this.#camera = createCameraControl(mirror.camera, canvas, session.store, () => this.#redraw());
    this.#camera.follow(session.store.document);
    this.#showAlpha(session.store.document);
    this.#outlines = new Outlines(options);
    this.hands = new Hands({ element, canvas, session, mirror, camera: this.#camera });
    installEnvironmentDrag({
      ...{ element, canvas, session },
      isTaken: (event) => this.hands.isOnHandle(event),
      holdCamera: (held) => this.#camera.hold(held),
    });
    this.#tracingView = createPathTracingView(
      session,
      this.tracing,
      () => this.#readPair(),
      () => this.#loop.request(),
    );
    this.#show = createShowView(session);
    canvas.after(this.#tracingView.element, this.#show.element);

    session.store.subscribe(({ document, previous, reason }) => {
      if (reason === 'open') {
        options.renderer.cut();
        mirror.open(document);
      } else mirror.apply(document);
      this.#follow(document, previous);
    });
    session.state.subscribe((now, before) => {
      if (now.continuous !== before.continuous) this.#loop.continuous = now.continuous;
      if (now.gpuTimes !== before.gpuTimes) {
        options.renderer.times.on = now.gpuTimes;
        if (!now.gpuTimes) session.gpuTimes.clear();
        this.#redraw(false);
      }
      const uncovered = isCovered(before) && !isCovered(now);
      const isOther = now.rendering !== before.rendering || now.divider !== before.divider;
      if (uncovered || isOther || now.selected !== before.selected) this.#loop.request();
    });
    session.gpuTimes.available = options.renderer.times.available;
    this.#followSize(element);
    document.addEventListener('visibilitychange', () => this.#loop.interrupt());
    installPixelReading(this.#options, this.#show);
    this.refresh();
  }

  /** After something came that is not in the document, such as a decoded image. */
  refresh(): void {
    this.#counts = countScene(this.#options.mirror.scene);
    this.#readiness.grown();
    this.#options.renderer.changed();
    this.#redraw();
  }

  /** Draws another picture at the right of the divider, and again when it has changed; null ends that. */
  drawBeside(beside: Beside | null): void {
    this.#beside = beside;
    this.#redraw(false);
  }

  #redraw(moved = true): void {
    if (moved) this.#resolution.moved();
    this.#stale = true;
    this.#loop.request();
  }

  /** Resolves once a frame that shows the present document is finished; rejects if nothing can be drawn any more. */
  nextFrame(): Promise<void> {
    this.#loop.request();
    return this.#awaited.next();
  }

  /** Compiles what a document with other effects needs, while the page stays alive and the picture as it is. */
  async prepare(document: Document): Promise<void> {
    const { mirror, renderer } = this.#options;
    this.#held += 1;
    try {
      await this.#readiness.follow(renderer.compile(mirror, document, this.#sizes().size));
    } finally {
      this.#held -= 1;
      this.#redraw();
    }
  }

  /** Resolves when a picture of the present document would have everything in it. */
  whole(): Promise<void> {
    return this.#readiness.whole();
  }

  /** What a frame of the present document takes the GPU, in ms: the least of a few. */
  async measureFrame(): Promise<number> {
    const time = await leastFrameTime(this.#options, this.#sizes().size);
    this.#loop.request();
    return time;
  }

  /** The picture as it is shown, without what is drawn over it. */
  async screenshot(): Promise<Blob> {
    await this.whole();
    const map = this.#tracingView.difference.canvas;
    if (map !== null) return pngOf(map);
    // A canvas of the GPU may be read only in the task that drew it, and the screen shows what that leaves there.
    this.#submit(true);
    const png = pngOf(this.#options.canvas);
    this.#outlines.draw();
    return png;
  }

  /** Its middle, in another size, without waiting for the GPU: canvases are read at once. */
  async smallPicture(width: number, height: number): Promise<ImageBitmap> {
    await this.whole();
    const map = this.#tracingView.difference.canvas;
    if (map !== null) return middleOf(map, width, height);
    this.#submit(true);
    this.#outlines.draw();
    return middleOf(await shownPixels(this.#options), width, height);
  }

  /** The path traced picture, whatever part of it is shown. */
  tracedScreenshot(): Promise<Blob> {
    return tracedPng(this.#options, this.tracing);
  }

  #follow(document: Document, previous: Document): void {
    const { mirror } = this.#options;
    this.#showAlpha(document);
    if (document.camera !== previous.camera) this.#camera.follow(document);
    this.#readiness.grown();
    if (document.objects !== previous.objects || document.assets !== previous.assets) this.refresh();
    else this.#redraw();
    const notLong = window.setTimeout(() => {
      this.#busy.hidden = false;
    }, BUSY_AFTER_MS);
    void mirror.settled().then(() => {
      clearTimeout(notLong);
      this.#busy.hidden = true;
      // A geometry or an image may have come only now.
      if (this.#options.session.store.document === document) this.refresh();
    });
  }

  /** What is seen through a transparent background is the page's, and says that it is. */
  #showAlpha({ background }: Document): void {
    this.#options.canvas.classList.toggle('transparent', background.type === 'transparent');
  }

  /** An observer reports once at its start, when there is nothing new. */
  #followSize(element: HTMLElement): void {
    let size = `${element.clientWidth} ${element.clientHeight}`;
    new ResizeObserver(() => {
      const now = `${element.clientWidth} ${element.clientHeight}`;
      if (now !== size) this.#redraw();
      size = now;
    }).observe(element);
  }

  /** The frame's size in pixels of the canvas, and of the radiance behind it. */
  #sizes() {
    const { element, session } = this.#options;
    const { resolutionScale } = session.store.document.view;
    const size = {
      width: Math.max(1, Math.round(element.clientWidth * devicePixelRatio)),
      height: Math.max(1, Math.round(element.clientHeight * devicePixelRatio)),
    };
    const scaled = (length: number) => Math.max(1, Math.round(length * resolutionScale));
    return { size, radiance: { width: scaled(size.width), height: scaled(size.height) } };
  }

  /** @param whole with all its pixels, whatever moves @returns whether the scene was drawn, and not its last picture again */
  #submit(whole = false): boolean {
    const { mirror, renderer, session, onFigures } = this.#options;
    const { document } = session.store;
    const { camera } = document;
    const { rendering, divider, continuous } = session.state.value;
    const { size, radiance } = this.#sizes();
    this.tracing.look({ camera: { ...camera, ...this.#camera.pose() }, ...radiance });
    const { texture } = this.tracing;
    const shown = texture !== null && (rendering === 'traced' || rendering === 'split');
    renderer.companion = shown ? { radiance: texture, from: rendering === 'split' ? divider : 0 } : null;
    // What is not seen need not be drawn: the machine is the path tracer's.
    const hidden = shown && rendering === 'traced' && !continuous;
    const isSplit = rendering !== 'interactive' || this.#beside !== null;
    const asBefore = (isSplit || !whole) && !this.#stale && !continuous && !renderer.unsettled;
    if (this.#beside && rendering === 'interactive') renderer.companion = this.#beside.last(divider);
    if (hidden || asBefore) {
      renderer.renderAgain({ ...document, camera: { ...camera, ...this.#camera.pose() } });
      return false;
    }
    const settings = this.#resolution.next(document, whole);
    if (this.#beside && rendering === 'interactive')
      renderer.companion = this.#beside.draw(settings, size, divider);
    renderer.render(mirror, settings, size);
    this.#stale = false;
    const { factor } = this.#resolution;
    onFigures({
      width: Math.round(radiance.width * factor),
      height: Math.round(radiance.height * factor),
      factor,
      drawCalls: renderer.three.info.render.drawCalls,
      backend: renderer.backend === 'webgpu' ? 'WebGPU' : 'WebGL 2',
      ...this.#counts,
    });
    return true;
  }

  /** Both renderings as the screen would show them; null while there is no path traced one. */
  async #readPair(): Promise<ImagePair | null> {
    await this.whole();
    const { renderer, session, mirror } = this.#options;
    if (this.#stale || this.#resolution.factor < 1) {
      renderer.render(mirror, this.#resolution.next(session.store.document, true), this.#sizes().size);
      this.#stale = false;
    }
    return readPair(this.#options, this.tracing);
  }

  async #render(): Promise<void> {
    // What is held back asks again, and a frame that waits shows what has changed meanwhile.
    if (this.#held > 0 || this.#isWaiting) return;
    if (this.#readiness.mayBeUnready) {
      this.#isWaiting = true;
      await this.#readiness.ready();
      this.#isWaiting = false;
    }
    if (this.#held > 0) return;
    const isAwaited = this.#awaited.areAwaited;
    // Nobody sees it: the machine is the plots', unless somebody asked for this very frame.
    if (isCovered(this.#options.session.state.value) && !isAwaited) return;
    const finished = this.#awaited.begin();
    const start = performance.now();
    const { document } = this.#options.session.store;
    const isDrawn = this.#submit(isAwaited);
    const { difference } = this.#tracingView;
    if (difference.canvas) this.#outlines.drawOn(difference.lines);
    else this.#outlines.draw();
    this.hands.draw();
    this.#show.update(this.#options.renderer.exposure(this.#options.session.store.document.view));
    if (this.#wantsMore()) this.#loop.request();
    await gpuFinished(this.#options.renderer);
    const now = performance.now();
    // A frame waits for the one before it.
    if (isDrawn) this.#resolution.add(now - Math.max(start, this.#finishedAt), document);
    this.#finishedAt = now;
    await this.#readTimes();
    finished();
  }

  async #readTimes(): Promise<void> {
    const { renderer, session } = this.#options;
    const times = await renderer.times.read();
    if (times && session.state.value.gpuTimes) session.gpuTimes.add(times);
  }

  /** Whether the next frame would be a better one, though nothing changes. */
  #wantsMore(): boolean {
    const { renderer, session } = this.#options;
    // What is not seen is not drawn, and so it does not become better.
    const isSeen = renderer.companion === null || session.state.value.rendering !== 'traced';
    return renderer.adapting || (isSeen && renderer.unsettled);
  }
}

/** Whether the bench fills the page. */
function isCovered({ benchOpen, benchPage, continuous }: EditorState): boolean {
  return benchOpen && benchPage && !continuous;
}
