/** The path tracer on a GPU: one compute shader, dispatched over parts of the picture. */
import type { Camera } from '../../scene/schema.ts';
import { FILM_FLOATS, FILM_SLOTS, Film } from '../film.ts';
import { pathTracerKernel } from '../kernel.ts';
import type { PassOptions, PathTracer, TileMask } from '../path-tracer.ts';
import { type RenderSettings, writeCamera, writeSettings } from '../scene/camera.ts';
import { PathTracerError } from '../scene/error.ts';
import { HEADER, HEADER_SLOTS, WORDS_PER_SLOT } from '../scene/layout.ts';
import type { PackedScene } from '../scene/pack.ts';
import { forEachTile, maskedPixels, TILE, tileGrid } from '../tiles.ts';
import { ADD_SHADER, ADD_WORKGROUP, kernelShader, WORKGROUP } from './shader.ts';

/** What a submission should take, in milliseconds: systems reset a GPU that is busy for some seconds. */
const SUBMISSION_TIME = 100;
/** Pixels along the side of a part; powers of two. */
const FIRST_PART = 64;
const LARGEST_PART = 4096;

/** Float32 sums of more samples than this would lose digits that the picture could show. */
const MOST_UNREAD_SAMPLES = 1024;

const SETTINGS_BYTES = 4 * WORDS_PER_SLOT * HEADER.image;

/** A loaded scene. */
interface Loaded {
  readonly scene: GPUBuffer;
  readonly words: number;
}

/** A rendering's buffers. */
interface Started {
  readonly settings: RenderSettings;
  /** What the pass that is under way has gathered. */
  readonly pass: GPUBuffer;
  /** What complete passes have gathered since the film was read last. */
  readonly total: GPUBuffer;
  /** A word for every tile: which ones the pass takes. */
  readonly tiles: GPUBuffer;
  readonly trace: GPUBindGroup;
  readonly add: GPUBindGroup;
  readonly film: Film;
  unread: number;
}

export class GpuPathTracer implements PathTracer {
  readonly device: string;
  readonly #gpu: GPUDevice;
  readonly #job: GPUBuffer;
  readonly #adder: GPUComputePipeline;
  #pipeline: GPUComputePipeline | null = null;
  #models: PackedScene['models'] = [];
  #loaded: Loaded | null = null;
  #started: Started | null = null;
  #part = FIRST_PART;

  /** @param device's limits bound the scene; it stays its owner's @param description for a person to read */
  constructor(device: GPUDevice, description: string) {
    this.#gpu = device;
    this.device = description;
    this.#job = device.createBuffer({ size: 16, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
    this.#adder = device.createComputePipeline({
      layout: 'auto',
      compute: { module: device.createShaderModule({ code: ADD_SHADER }) },
    });
  }

  /** The most bytes that a scene may have here. */
  get maxBytes(): number {
    const { maxStorageBufferBindingSize, maxBufferSize } = this.#gpu.limits;
    return Math.min(maxStorageBufferBindingSize, maxBufferSize);
  }

  async load(scene: PackedScene): Promise<void> {
    const size = scene.words.byteLength;
    if (size > this.maxBytes)
      throw new PathTracerError(
        `the scene takes ${size} bytes of memory; this GPU's limit is ${this.maxBytes}`,
      );
    const sameModels =
      this.#pipeline !== null &&
      this.#models.length === scene.models.length &&
      this.#models.every((model, i) => model === scene.models[i]);
    if (!sameModels) {
      const code = kernelShader(pathTracerKernel(scene.models));
      const module = this.#gpu.createShaderModule({ code });
      this.#pipeline = await this.#gpu.createComputePipelineAsync({ layout: 'auto', compute: { module } });
      this.#models = scene.models;
    }
    this.#end();
    if (this.#loaded?.words !== scene.words.length) {
      this.#loaded?.scene.destroy();
      const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST;
      this.#loaded = { scene: this.#gpu.createBuffer({ size, usage }), words: scene.words.length };
    }
    this.#gpu.queue.writeBuffer(this.#loaded.scene, 0, scene.words);
  }

  start(camera: Camera, settings: RenderSettings): void {
    if (this.#loaded === null || this.#pipeline === null) throw new Error('start() before load()');
    const header = new Uint32Array(HEADER_SLOTS * WORDS_PER_SLOT);
    writeCamera(header, camera, settings);
    writeSettings(header, settings);
    this.#gpu.queue.writeBuffer(
      this.#loaded.scene,
      SETTINGS_BYTES,
      header.slice(HEADER.image * WORDS_PER_SLOT),
    );
    this.#end();
    const size = settings.width * settings.height * FILM_FLOATS * 4;
    if (size > this.maxBytes)
      throw new PathTracerError(
        `the picture takes ${size} bytes of memory; this GPU's limit is ${this.maxBytes}`,
      );
    const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC | GPUBufferUsage.COPY_DST;
    const [pass, total] = [this.#gpu.createBuffer({ size, usage }), this.#gpu.createBuffer({ size, usage })];
    const { columns, rows } = tileGrid(settings.width, settings.height);
    const tiles = this.#gpu.createBuffer({
      size: 4 * columns * rows,
      usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST,
    });
    const group = (pipeline: GPUComputePipeline, buffers: readonly GPUBuffer[]) =>
      this.#gpu.createBindGroup({
        layout: pipeline.getBindGroupLayout(0),
        entries: buffers.map((buffer, binding) => ({ binding, resource: { buffer } })),
      });
    this.#started = {
      settings,
      pass,
      total,
      tiles,
      trace: group(this.#pipeline, [this.#loaded.scene, pass, this.#job, tiles]),
      add: group(this.#adder, [pass, total]),
      film: new Film(settings.width, settings.height),
      unread: 0,
    };
  }

  async render(first: number, count: number, options: PassOptions = {}): Promise<void> {
    const { signal, onProgress, tiles } = options;
    const started = this.#started;
    if (started === null) throw new Error('render() before start()');
    const { width, height } = started.settings;
    const { columns, rows } = tileGrid(width, height);
    const mask = tiles ?? new Uint8Array(columns * rows).fill(1);
    const all = maskedPixels(width, height, mask) * count;
    let done = 0;
    this.#gpu.queue.writeBuffer(started.tiles, 0, Uint32Array.from(mask));
    const clear = this.#gpu.createCommandEncoder();
    clear.clearBuffer(started.pass);
    this.#gpu.queue.submit([clear.finish()]);
    for (let sample = 0; sample < count; ) {
      // A part of one sample that is too quick grows; one of the whole picture then takes several samples.
      const whole = this.#part >= Math.max(width, height);
      const samples = whole ? Math.min(count - sample, this.#samplesPerSubmission) : 1;
      const side = Math.min(this.#part, LARGEST_PART);
      const taken = partPixels(width, height, side, mask);
      for (let y = 0; y < height; y += side) {
        for (let x = 0; x < width; x += side) {
          signal?.throwIfAborted();
          const w = Math.min(side, width - x);
          const h = Math.min(side, height - y);
          const pixels = taken[(y / side) * Math.ceil(width / side) + x / side]!;
          if (pixels === 0) continue;
          const began = performance.now();
          this.#dispatch(started, new Uint32Array([x, y, first + sample, samples]), w, h);
          await this.#gpu.queue.onSubmittedWorkDone();
          if (this.#started !== started) throw new DOMException('another rendering began', 'AbortError');
          if (pixels === w * h && (w === side || whole)) this.#adapt(performance.now() - began, whole);
          done += pixels * samples;
          onProgress?.(done / all);
        }
      }
      sample += samples;
    }
    signal?.throwIfAborted();
    this.#add(started);
    started.unread += count;
    if (started.unread >= MOST_UNREAD_SAMPLES) await this.#read(started);
  }

  async film(): Promise<Film> {
    if (this.#started === null) throw new Error('film() before start()');
    if (this.#started.unread > 0) await this.#read(this.#started);
    return this.#started.film;
  }

  dispose(): void {
    this.#end();
    this.#loaded?.scene.destroy();
    this.#loaded = null;
    this.#job.destroy();
  }

  #samplesPerSubmission = 1;

  #adapt(time: number, whole: boolean): void {
    if (time > 2 * SUBMISSION_TIME) {
      if (this.#samplesPerSubmission > 1)
        this.#samplesPerSubmission = Math.ceil(this.#samplesPerSubmission / 2);
      else this.#part = Math.max(TILE, this.#part / 2);
    } else if (time < SUBMISSION_TIME / 2) {
      if (whole) this.#samplesPerSubmission = Math.min(64, this.#samplesPerSubmission * 2);
      else this.#part *= 2;
    }
  }

  #dispatch({ trace }: Started, job: Uint32Array<ArrayBuffer>, width: number, height: number): void {
    this.#gpu.queue.writeBuffer(this.#job, 0, job);
    const encoder = this.#gpu.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(this.#pipeline as GPUComputePipeline);
    pass.setBindGroup(0, trace);
    pass.dispatchWorkgroups(Math.ceil(width / WORKGROUP), Math.ceil(height / WORKGROUP));
    pass.end();
    this.#gpu.queue.submit([encoder.finish()]);
  }

  /** Adds the finished pass to the total. */
  #add({ add, settings }: Started): void {
    const groups = Math.ceil((settings.width * settings.height * FILM_SLOTS) / ADD_WORKGROUP);
    const side = Math.ceil(Math.sqrt(groups));
    const encoder = this.#gpu.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(this.#adder);
    pass.setBindGroup(0, add);
    pass.dispatchWorkgroups(side, Math.ceil(groups / side));
    pass.end();
    this.#gpu.queue.submit([encoder.finish()]);
  }

  /** Moves the total into the film, where sums are float64. */
  async #read(started: Started): Promise<void> {
    const { total, film } = started;
    const usage = GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST;
    const copy = this.#gpu.createBuffer({ size: total.size, usage });
    const encoder = this.#gpu.createCommandEncoder();
    encoder.copyBufferToBuffer(total, 0, copy, 0, total.size);
    encoder.clearBuffer(total);
    this.#gpu.queue.submit([encoder.finish()]);
    started.unread = 0;
    await copy.mapAsync(GPUMapMode.READ);
    film.add(new Float32Array(copy.getMappedRange()));
    copy.destroy();
  }

  #end(): void {
    this.#started?.pass.destroy();
    this.#started?.total.destroy();
    this.#started?.tiles.destroy();
    this.#started = null;
  }
}

/** How many pixels of each part of the picture are in a mask's tiles, row by row. @param side of a part, whole tiles */
function partPixels(width: number, height: number, side: number, mask: TileMask): Float64Array {
  const columns = Math.ceil(width / side);
  const pixels = new Float64Array(columns * Math.ceil(height / side));
  forEachTile(width, height, ({ tile, left, top, right, bottom }) => {
    const part = Math.floor(top / side) * columns + Math.floor(left / side);
    if (mask[tile]) pixels[part]! += (right - left) * (bottom - top);
  });
  return pixels;
}
