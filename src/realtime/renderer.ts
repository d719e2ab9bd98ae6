/**
 * The interactive renderer: one frame of a scene to a canvas, in the page and in Node alike. A frame is
 * drawn in steps: the surfaces (depth, normals, motion) if an effect reads them; the scene as linear radiance, at the
 * view's resolution scale, into a buffer of floats; the effects on it; then that buffer, exposed and tone mapped, to
 * the canvas. The buffer can be read back. Each effect is a file in effects/.
 */
import {
  FloatType,
  HalfFloatType,
  LinearSRGBColorSpace,
  type Mesh,
  NoToneMapping,
  type PerspectiveCamera,
  RenderTarget,
  type Scene,
  type Texture,
  UnsignedByteType,
  WebGPURenderer,
} from 'three/webgpu';
import { exposureFor } from '../color/exposure.ts';
import { LampLighting } from '../lights/many-lamps.ts';
import { focusDistance } from '../scene/lens.ts';
import type { Camera } from '../scene/schema.ts';
import { CompileQueue, withOnly } from './compile-queue.ts';
import { DataViews } from './data-views.ts';
import { showsLight } from './display.ts';
import { ExposureMeter } from './exposure-meter.ts';
import type { FrameSettings, ViewSettings } from './frame/effect.ts';
import { EffectChain } from './frame/effect-chain.ts';
import { GpuTimes } from './frame/gpu-times.ts';
import { FrameInputs } from './frame/inputs.ts';
import { CopyPass } from './frame/pass.ts';
import { RepeatedMeshes } from './frame/repeated-meshes.ts';
import { GroundCatcher } from './ground/ground-catcher.ts';
import { type Companion, type Display, OutputPass } from './output-pass.ts';
import { divideByAlpha, isWebGPU, numbersOf, readTarget, readTexel } from './read-back.ts';

export interface RendererOptions {
  /** Where frames appear; three.js makes one when it is left out: `renderer.canvas`. */
  canvas?: HTMLCanvasElement;
  device?: GPUDevice;
  /** Use the WebGL 2 back end even where there is WebGPU. */
  forceWebGL?: boolean;
  /** Samples per pixel against jagged edges: 1 or 4. */
  samples?: 1 | 4;
  /** Numbers of the radiance buffer. WebGPU takes several samples of half ones only. */
  precision?: 'half' | 'float';
  /** The GPU reported an error or is gone. Nothing can be drawn any more after a loss. */
  onError?: (message: string) => void;
}

/** What SceneMirror offers; any other pair serves as well. */
export interface Renderable {
  scene: Scene;
  camera: PerspectiveCamera;
}

/** In pixels of the canvas, not in CSS pixels. */
export interface Size {
  width: number;
  height: number;
}

export interface Radiance extends Size {
  /** RGBA, rows from the top, linear Rec. 709, before exposure. */
  pixels: Float32Array;
}

export type { FrameSettings, ViewSettings } from './frame/effect.ts';

export async function createRenderer(options: RendererOptions = {}): Promise<RealtimeRenderer> {
  const { canvas, device, forceWebGL = false, onError } = options;
  const three = new WebGPURenderer({ forceWebGL, ...(canvas && { canvas }), ...(device && { device }) });
  if (onError) {
    // Typed as text in three's declarations; it is an object with a message.
    three.onError = (info: unknown) => onError(`GPU error: ${(info as { message: string }).message}`);
    three.onDeviceLost = ({ message }) => onError(`the GPU was lost: ${message}`);
  }
  await three.init();
  return new RealtimeRenderer(three, options);
}

/** A frame that takes longer than this was waited for; one that takes less is not seen. */
const FRAME_SECONDS = [1 / 1000, 0.1] as const;

export class RealtimeRenderer {
  #radiance: RenderTarget;
  readonly #options: Required<Pick<RendererOptions, 'samples' | 'precision'>>;
  readonly #output: OutputPass;
  readonly #inputs = new FrameInputs();
  /** What the GPU spends on the parts of a frame; off at first. */
  readonly times: GpuTimes;
  readonly #effects = new EffectChain(this.#inputs, (name) => this.times.mark(name));
  /** The radiance of the last frame, effects and all. */
  #result: RenderTarget;
  /** What the output pass shows, for effects that work on that. */
  readonly #picture = new RenderTarget(1, 1, { type: UnsignedByteType, depthBuffer: false });
  readonly #copy = new CopyPass();
  readonly #lighting = new LampLighting();
  readonly #meter = new ExposureMeter();
  readonly #dataViews = new DataViews(this.#inputs);
  readonly #repeated = new RepeatedMeshes();
  /** While the frame has one. */
  #ground: GroundCatcher | null = null;
  /** Of the last frame. */
  #camera: Camera | undefined;
  #drawnAt = 0;
  readonly #compiling = new CompileQueue();
  #metered = false;
  #transparent = false;
  /** Shown instead of a part of the frame; readRadiance() does not see it. */
  companion: Companion | null = null;

  /** For a renderer of three.js that is initialised already; createRenderer() makes one. */
  constructor(
    readonly three: WebGPURenderer,
    { samples = 4, precision = 'half' }: Pick<RendererOptions, 'samples' | 'precision'> = {},
  ) {
    if (precision === 'float' && samples > 1) throw new RangeError('several samples need half precision');
    // The output pass does both, so that three.js needs no third buffer for them.
    three.toneMapping = NoToneMapping;
    three.outputColorSpace = LinearSRGBColorSpace;
    three.lighting = this.#lighting;
    // So that the figures are those of both halves of a frame.
    three.info.autoReset = false;
    this.#options = { samples, precision };
    this.times = new GpuTimes(three);
    this.#radiance = this.#target(samples);
    this.#result = this.#radiance;
    this.#output = new OutputPass(this.#radiance.texture);
  }

  get canvas(): HTMLCanvasElement {
    return this.three.domElement as HTMLCanvasElement;
  }

  get backend(): 'webgpu' | 'webgl' {
    return isWebGPU(this.three) ? 'webgpu' : 'webgl';
  }

  /** Further frames of a scene that stands still would be better ones. */
  get unsettled(): boolean {
    return this.#effects.unsettled || this.#ground?.unsettled === true;
  }

  /** The exposure is on its way to what the meter says: to show the last frame again is enough. */
  get adapting(): boolean {
    return this.#metered && this.#meter.unsettled;
  }

  /** What is shown next is another scene: nothing of the last frames is of use. */
  cut(): void {
    this.#inputs.cut();
    this.#meter.cut();
  }

  /** Something is not as it was, though the settings are the same, such as an image that has come. */
  changed(): void {
    this.#inputs.changed();
  }

  /**
   * Compiles what the scene needs without drawing it, so that the page stays alive meanwhile.
   *
   * @param only those of drawn() that need it, where the others are known to have been drawn
   */
  async compile(
    renderable: Renderable,
    settings: FrameSettings,
    size: Size,
    only?: readonly Mesh[],
  ): Promise<void> {
    await this.#compiling.add(() => this.#compile(renderable, settings, size, only));
  }

  async #compile(
    { scene, camera }: Renderable,
    settings: FrameSettings,
    size: Size,
    only?: readonly Mesh[],
  ): Promise<void> {
    this.#fit(camera, settings, size);
    this.#follow(settings);
    const { three } = this;
    // Within one call three.js takes lights and environment to be those it found first, and counts only what it draws as calls.
    (three.info as { calls: number }).calls += 1;
    const compile = () => three.compileAsync(scene, camera);
    three.setRenderTarget(this.#radiance);
    let compiled: Promise<void>;
    try {
      compiled = this.#within(scene, camera, only ? () => withOnly(scene, only, compile) : compile);
    } finally {
      three.setRenderTarget(null);
    }
    await compiled;
  }

  /** What draws a scene: its meshes, and such as stand for many of them. */
  drawn(scene: Scene): readonly Mesh[] {
    return this.#repeated.drawn(scene);
  }

  /** @param seconds since the last frame; left out, those that have passed */
  render(renderable: Renderable, settings: FrameSettings, size: Size, seconds = this.#elapsed()): void {
    this.draw(renderable, settings, size, seconds);
    this.#again(settings, seconds);
  }

  /** The radiance of a frame, which is not shown: `texture` has it. */
  draw({ scene, camera }: Renderable, settings: FrameSettings, size: Size, seconds = this.#elapsed()): void {
    const { three } = this;
    const show = settings.view.show ?? 'picture';
    const { width, height } = this.#fit(camera, settings, size);
    three.info.reset();
    this.times.begin();
    camera.updateMatrixWorld();
    this.#inputs.begin(camera, width, height, settings, seconds);
    this.#follow(settings);
    if (this.#effects.needsSurfaces || this.#dataViews.needsSurfaces(show))
      this.#inputs.surfaces.render(three, scene, camera, width, height, this.#inputs.surfacesFrame);
    this.times.mark('surfaces');
    const [x, y] = showsLight(show) ? this.#effects.jitter() : [0, 0];
    this.#inputs.jitter.value.set(x / width, y / height);
    this.#effects.beforeScene(three, scene, camera);
    if (showsLight(show)) {
      this.#ground?.prepare(three, scene, camera, settings);
      this.#drawScene(scene, camera, (-2 * x) / width, (2 * y) / height);
      this.times.mark('scene');
      this.#result = this.#effects.afterScene(three, this.#radiance);
    } else this.#result = this.#dataViews.draw(three, show, scene, camera, this.#radiance);
    this.times.mark('scene');
  }

  /** Linear radiance of the last frame, effects and all. */
  get texture(): Texture {
    return this.#result.texture;
  }

  /** Another renderer on the same GPU, with frames of its own, which can be this one's companion; release() ends it. */
  beside(): RealtimeRenderer {
    return new RealtimeRenderer(this.three, this.#options);
  }

  /** The last frame again, with another exposure, tone mapping or companion. */
  renderAgain(settings: FrameSettings): void {
    this.#again(settings, this.#elapsed());
  }

  /** Exposes at once for the last frame, or for a companion alone, where a meter does. */
  async settleExposure({ exposureMode }: ViewSettings, companion: Companion | null = null): Promise<void> {
    if (exposureMode === 'auto') await this.#meter.settle(this.three, this.#meteredTexture(companion));
  }

  /** What radiance is multiplied by on its way to the screen, in EV. */
  exposure(view: ViewSettings): number {
    return exposureFor(view, this.#camera, this.#meter.exposure);
  }

  /** The last frame as linear radiance, as large as it was rendered: the size times the resolution scale. */
  async readRadiance(): Promise<Radiance> {
    const { width, height } = this.#result;
    const pixels = numbersOf(await readTarget(this.three, this.#result)) as Float32Array;
    return { width, height, pixels };
  }

  /** One pixel of it. @param x @param y its place, from 0 at the left and the top to 1 */
  readPixel(x: number, y: number): Promise<[number, number, number, number]> {
    return readTexel(this.three, this.#result, x, y);
  }

  /**
   * The last frame as the screen shows it, or beside another companion: 8-bit sRGB with alpha, which is not multiplied in, rows
   * from the top.
   */
  async readImage(view: ViewSettings, companion = this.companion): Promise<Uint8Array> {
    const { width, height } = this.three.domElement;
    const target = new RenderTarget(width, height, { type: UnsignedByteType, depthBuffer: false });
    this.#show(view, companion, target);
    const pixels = (await readTarget(this.three, target)) as Uint8Array;
    target.dispose();
    if (this.#transparent) divideByAlpha(pixels);
    return pixels;
  }

  dispose(): void {
    this.release();
    this.three.dispose();
  }

  /** All but the renderer of three.js, which others may use. */
  release(): void {
    this.#effects.dispose();
    this.#inputs.dispose();
    this.#output.dispose();
    this.#picture.dispose();
    this.#copy.dispose();
    this.#meter.dispose();
    this.#dataViews.dispose();
    this.#ground?.dispose();
    this.#repeated.dispose();
    this.#radiance.dispose();
  }

  /** With what is in the scene only while the picture is drawn. */
  #within<T>(scene: Scene, camera: PerspectiveCamera, draw: () => T): T {
    const all = () => this.#repeated.within(scene, camera, draw);
    return this.#ground === null ? all() : this.#ground.within(scene, all);
  }

  #follow(settings: FrameSettings): void {
    if (settings.ground?.shadowCatcher) this.#ground ??= new GroundCatcher();
    else {
      this.#ground?.dispose();
      this.#ground = null;
    }
    this.#effects.follow(this.three, settings, this.#dataViews.context(settings.view.show ?? 'picture'));
    this.#lighting.drawsShadows = this.#effects.drawsShadows;
    // Another renderer beside this one may have drawn since.
    this.three.lighting = this.#lighting;
  }

  /** @param x @param y by how much the picture is moved, in normalised device coordinates */
  #drawScene(scene: Scene, camera: PerspectiveCamera, x: number, y: number): void {
    const { three } = this;
    const { projectionMatrix, projectionMatrixInverse } = camera;
    const [before, inverseBefore] = [projectionMatrix.clone(), projectionMatrixInverse.clone()];
    // Of what is in front of the camera, w is -z.
    projectionMatrix.elements[8]! -= x;
    projectionMatrix.elements[9]! -= y;
    projectionMatrixInverse.copy(projectionMatrix).invert();
    three.setRenderTarget(this.#radiance);
    this.#within(scene, camera, () => three.render(scene, camera));
    this.#repeated.tidy();
    three.setRenderTarget(null);
    projectionMatrix.copy(before);
    projectionMatrixInverse.copy(inverseBefore);
  }

  #again(settings: FrameSettings, seconds: number): void {
    this.#camera = settings.camera;
    this.#metered = settings.view.exposureMode === 'auto';
    this.#transparent = settings.background?.type === 'transparent';
    if (this.#metered) this.#meter.follow(this.three, this.#meteredTexture(this.companion), seconds);
    this.#show(settings.view, this.companion, null);
  }

  /** What is seen most of. */
  #meteredTexture(companion: Companion | null): Texture {
    return companion !== null && companion.from < 0.5 ? companion.radiance : this.#result.texture;
  }

  #elapsed(): number {
    const now = performance.now();
    const seconds = (now - this.#drawnAt) / 1000;
    this.#drawnAt = now;
    return Math.min(FRAME_SECONDS[1], Math.max(FRAME_SECONDS[0], seconds));
  }

  #target(samples: number): RenderTarget {
    const type = this.#options.precision === 'float' ? FloatType : HalfFloatType;
    return new RenderTarget(1, 1, { type, samples: samples === 1 ? 0 : samples });
  }

  /** Several samples a pixel are one way against jagged edges; data have no means of them. */
  #samples({ view, effects }: FrameSettings): number {
    const { method } = effects?.antialiasing ?? { method: 'msaa' };
    return method === 'msaa' && showsLight(view.show ?? 'picture') ? this.#options.samples : 1;
  }

  /** From the last frame's radiance to what a screen shows, in a target or, for null, on the canvas. */
  #show(view: ViewSettings, companion: Companion | null, target: RenderTarget | null): void {
    const { three } = this;
    const { width, height } = three.domElement;
    const display: Display = {
      ...view,
      exposure: this.exposure(view),
      transparent: this.#transparent,
      ...(this.#camera && { distance: focusDistance(this.#camera) }),
    };
    const draw = (into: RenderTarget | null) => {
      three.setRenderTarget(into);
      this.#output.render(three, this.#result.texture, display, companion);
      three.setRenderTarget(null);
      this.times.mark('output');
    };
    if (!this.#effects.worksOnOutput || (view.show ?? 'picture') !== 'picture') {
      draw(target);
      return;
    }
    this.#picture.setSize(width, height);
    draw(this.#picture);
    this.#copy.render(three, this.#effects.afterOutput(three, this.#picture), target);
    this.times.mark('output');
  }

  /** @returns the size of the radiance buffer */
  #fit(camera: PerspectiveCamera, settings: FrameSettings, { width, height }: Size): Size {
    const { domElement } = this.three;
    const { resolutionScale } = settings.view;
    const samples = this.#samples(settings);
    if (Math.max(1, this.#radiance.samples) !== samples) {
      const before = this.#radiance;
      this.#radiance = this.#target(samples);
      if (this.#result === before) this.#result = this.#radiance;
      before.dispose();
    }
    if (domElement.width !== width || domElement.height !== height) this.three.setSize(width, height, false);
    const scaled = (length: number) => Math.max(1, Math.round(length * resolutionScale));
    const radiance = { width: scaled(width), height: scaled(height) };
    this.#radiance.setSize(radiance.width, radiance.height);
    const { coordinateSystem } = this.three;
    if (camera.aspect !== width / height || camera.coordinateSystem !== coordinateSystem) {
      camera.aspect = width / height;
      // three.js would find out only when it draws: depth is 0..1 on WebGPU and -1..1 on WebGL.
      camera.coordinateSystem = coordinateSystem;
      camera.updateProjectionMatrix();
    }
    return radiance;
  }
}
