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
  NoToneMapping,
  type PerspectiveCamera,
  RenderTarget,
  type Scene,
  UnsignedByteType,
  WebGPURenderer,
} from 'three/webgpu';
import { fromHalf } from '../io/half.ts';
import type { FrameSettings, ViewSettings } from './frame/effect.ts';
import { EffectChain } from './frame/effect-chain.ts';
import { FrameInputs } from './frame/inputs.ts';
import { CopyPass } from './frame/pass.ts';
import { type Companion, OutputPass } from './output-pass.ts';

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

export class RealtimeRenderer {
  readonly #radiance: RenderTarget;
  readonly #output: OutputPass;
  readonly #inputs = new FrameInputs();
  readonly #effects = new EffectChain(this.#inputs);
  /** The radiance of the last frame, effects and all. */
  #result: RenderTarget;
  /** What the output pass shows, for effects that work on that. */
  readonly #picture = new RenderTarget(1, 1, { type: UnsignedByteType, depthBuffer: false });
  readonly #copy = new CopyPass();
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
    // So that the figures are those of both halves of a frame.
    three.info.autoReset = false;
    const type = precision === 'float' ? FloatType : HalfFloatType;
    this.#radiance = new RenderTarget(1, 1, { type, samples: samples === 1 ? 0 : samples });
    this.#result = this.#radiance;
    this.#output = new OutputPass(this.#radiance.texture);
  }

  get canvas(): HTMLCanvasElement {
    return this.three.domElement as HTMLCanvasElement;
  }

  get backend(): 'webgpu' | 'webgl' {
    return 'isWebGPUBackend' in this.three.backend ? 'webgpu' : 'webgl';
  }

  /** Further frames of a scene that stands still would be better ones. */
  get unsettled(): boolean {
    return this.#effects.unsettled;
  }

  /** Compiles what the scene needs without drawing it, so that the page stays alive meanwhile. */
  async compile({ scene, camera }: Renderable, settings: FrameSettings, size: Size): Promise<void> {
    this.#fit(camera, settings.view, size);
    this.#effects.follow(this.three, settings);
    this.three.setRenderTarget(this.#radiance);
    const compiled = this.three.compileAsync(scene, camera);
    this.three.setRenderTarget(null);
    await compiled;
  }

  render({ scene, camera }: Renderable, settings: FrameSettings, size: Size): void {
    const { three } = this;
    const { width, height } = this.#fit(camera, settings.view, size);
    three.info.reset();
    camera.updateMatrixWorld();
    this.#inputs.begin(camera, width, height);
    this.#effects.follow(three, settings);
    if (this.#effects.needsSurfaces) this.#inputs.surfaces.render(three, scene, camera, width, height);
    this.#effects.beforeScene(three);
    three.setRenderTarget(this.#radiance);
    three.render(scene, camera);
    three.setRenderTarget(null);
    this.#result = this.#effects.afterScene(three, this.#radiance);
    this.renderAgain(settings.view);
  }

  /** The last frame again, with another exposure, tone mapping or companion. */
  renderAgain(view: ViewSettings): void {
    this.#show(view, this.companion, null);
  }

  /** The last frame as linear radiance, as large as it was rendered: the size times the resolution scale. */
  async readRadiance(): Promise<Radiance> {
    const { width, height } = this.#result;
    const data = await this.#read(this.#result);
    const pixels = data instanceof Uint16Array ? Float32Array.from(data, fromHalf) : (data as Float32Array);
    return { width, height, pixels };
  }

  /** The last frame as the screen shows it, or beside another companion: 8-bit sRGB with alpha, rows from the top. */
  async readImage(view: ViewSettings, companion = this.companion): Promise<Uint8Array> {
    const { width, height } = this.three.domElement;
    const target = new RenderTarget(width, height, { type: UnsignedByteType, depthBuffer: false });
    this.#show(view, companion, target);
    const pixels = (await this.#read(target)) as Uint8Array;
    target.dispose();
    return pixels;
  }

  dispose(): void {
    this.#effects.dispose();
    this.#inputs.dispose();
    this.#output.dispose();
    this.#picture.dispose();
    this.#copy.dispose();
    this.#radiance.dispose();
    this.three.dispose();
  }

  /** From the last frame's radiance to what a screen shows, in a target or, for null, on the canvas. */
  #show(view: ViewSettings, companion: Companion | null, target: RenderTarget | null): void {
    const { three } = this;
    const { width, height } = three.domElement;
    const draw = (into: RenderTarget | null) => {
      three.setRenderTarget(into);
      this.#output.render(three, this.#result.texture, view, companion);
      three.setRenderTarget(null);
    };
    if (!this.#effects.worksOnOutput) {
      draw(target);
      return;
    }
    this.#picture.setSize(width, height);
    draw(this.#picture);
    this.#copy.render(three, this.#effects.afterOutput(three, this.#picture), target);
  }

  /** @returns the size of the radiance buffer */
  #fit(camera: PerspectiveCamera, { resolutionScale }: ViewSettings, { width, height }: Size): Size {
    const { domElement } = this.three;
    if (domElement.width !== width || domElement.height !== height) this.three.setSize(width, height, false);
    const scaled = (length: number) => Math.max(1, Math.round(length * resolutionScale));
    const radiance = { width: scaled(width), height: scaled(height) };
    this.#radiance.setSize(radiance.width, radiance.height);
    if (camera.aspect !== width / height) {
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
    }
    return radiance;
  }

  /** Rows from the top on both back ends: WebGL's start at the bottom. */
  async #read(target: RenderTarget): Promise<Pixels> {
    const { width, height } = target;
    const pixels = (await this.three.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as Pixels;
    if (this.backend === 'webgl') reverseRows(pixels, width * 4);
    return pixels;
  }
}

type Pixels = Float32Array | Uint16Array | Uint8Array;

function reverseRows(pixels: Pixels, length: number): void {
  for (let top = 0, bottom = pixels.length - length; top < bottom; top += length, bottom -= length) {
    const row = pixels.slice(top, top + length);
    pixels.copyWithin(top, bottom, bottom + length);
    pixels.set(row, bottom);
  }
}
