/** What renders a packed scene, whatever machine does the work. */
import type { Camera } from '../scene/schema.ts';
import type { Film } from './film.ts';
import type { RenderSettings } from './scene/camera.ts';
import type { PackedScene } from './scene/pack.ts';

export interface PathTracer {
  /** What does the work, for a person to read: '2 CPU threads', a GPU's name. */
  readonly device: string;

  /** Takes a scene. The kernel is compiled anew only if the scene's models are others than before. */
  load(scene: PackedScene): Promise<void>;

  /** Begins a rendering of the loaded scene with an empty film; not while render() is under way. */
  start(camera: Camera, settings: RenderSettings): void;

  /**
   * Adds the samples `first` to `first + count - 1` of every pixel, or of those in some tiles, to the film.
   *
   * @param options.onProgress is called with 0 to 1
   * @throws AbortError by the signal: the film is then as it was before the call
   * @throws Error if the device is lost
   */
  render(first: number, count: number, options?: PassOptions): Promise<void>;

  /** What has been rendered since start(). */
  film(): Promise<Film>;

  dispose(): void;
}

/** 1 for every tile (tiles.ts) that is meant, row by row; otherwise 0. */
export type TileMask = Uint8Array;

export interface PassOptions {
  /** The tiles to take; all of them unless said otherwise. */
  readonly tiles?: TileMask;
  readonly signal?: AbortSignal;
  onProgress?(part: number): void;
}
