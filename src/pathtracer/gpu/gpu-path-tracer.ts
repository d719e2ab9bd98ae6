/** The path tracer on a GPU: one compute shader, dispatched over tiles of the picture. */
import type { Camera } from '../../scene/schema.ts';
import { FILM_FLOATS, FILM_SLOTS, Film } from '../film.ts';
import { pathTracerKernel } from '../kernel.ts';
import type { PassOptions, PathTracer } from '../path-tracer.ts';
import { type RenderSettings, writeCamera, writeSettings } from '../scene/camera.ts';
import { PathTracerError } from '../scene/error.ts';
import { HEADER, HEADER_SLOTS, WORDS_PER_SLOT } from '../scene/layout.ts';
import type { PackedScene } from '../scene/pack.ts';
import { ADD_SHADER, ADD_WORKGROUP, kernelShader, WORKGROUP } from './shader.ts';

/** What a submission should take, in milliseconds: systems reset a GPU that is busy for some seconds. */
const SUBMISSION_TIME = 100;
const FIRST_TILE = 64;
const LARGEST_TILE = 4096;

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
  #tile = FIRST_TILE;

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
    const group = (pipeline: GPUComputePipeline, buffers: readonly GPUBuffer[]) =>
      this.#gpu.createBindGroup({
        layout: pipeline.getBindGroupLayout(0),
        entries: buffers.map((buffer, binding) => ({ binding, resource: { buffer } })),
      });
    this.#started = {
      settings,
      pass,
      total,
      trace: group(this.#pipeline, [this.#loaded.scene, pass, this.#job]),
      add: group(this.#adder, [pass, total]),
      film: new Film(settings.width, settings.height),
      unread: 0,
    };
  }

  async render(first: number, count: number, { signal, onProgress }: PassOptions = {}): Promise<void> {
    const started = this.#started;
    if (started === null) throw new Error('render() before start()');
    const { width, height } = started.settings;
    const all = width * height * count;
    let done = 0;
    const clear = this.#gpu.createCommandEncoder();
    clear.clearBuffer(started.pass);
    this.#gpu.queue.submit([clear.finish()]);
    for (let sample = 0; sample < count; ) {
      // A tile of one sample that is too quick grows; one of the whole picture then takes several samples.
      const whole = this.#tile >= Math.max(width, height);
      const samples = whole ? Math.min(count - sample, this.#samplesPerSubmission) : 1;
      const tile = Math.min(this.#tile, LARGEST_TILE);
      for (let y = 0; y < height; y += tile) {
        for (let x = 0; x < width; x += tile) {
          signal?.throwIfAborted();
          const w = Math.min(tile, width - x);
          const h = Math.min(tile, height - y);
          const began = performance.now();
          this.#dispatch(started, new Uint32Array([x, y, first + sample, samples]), w, h);
          await this.#gpu.queue.onSubmittedWorkDone();
          if (this.#started !== started) throw new DOMException('another rendering began', 'AbortError');
          if (w === tile || whole) this.#adapt(performance.now() - began, whole);
          done += w * h * samples;
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
      else this.#tile = Math.max(WORKGROUP, this.#tile / 2);
    } else if (time < SUBMISSION_TIME / 2) {
      if (whole) this.#samplesPerSubmission = Math.min(64, this.#samplesPerSubmission * 2);
      else this.#tile *= 2;
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
    this.#started = null;
  }
}
