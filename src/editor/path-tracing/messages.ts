/** What the page and the director of the path tracer say to each other. */
import type { RenderRecord } from '../../pathtracer/record.ts';
import type { RenderSettings } from '../../pathtracer/scene/camera.ts';
import type { Camera } from '../../scene/schema.ts';
import type { DocumentChange } from './document-change.ts';

/** When a picture is complete: whichever comes first. */
export interface Goal {
  /** Per pixel. */
  readonly samples: number;
  /** Relative; 0 asks for none. */
  readonly error: number;
}

/** What the page knows of a file's record; the rest is the director's. */
export type Origin = Pick<
  RenderRecord,
  'version' | 'document' | 'name' | 'until' | 'exposure' | 'toneMapping'
>;

export type ToDirector =
  | {
      readonly kind: 'render';
      /** Comes back with all that belongs to this rendering. */
      readonly ticket: number;
      /** Null where the scene is as before. */
      readonly change: DocumentChange | null;
      readonly camera: Camera;
      readonly settings: RenderSettings;
    }
  | { readonly kind: 'goal'; readonly goal: Goal }
  | { readonly kind: 'pause'; readonly paused: boolean }
  /** Whether to denoise what there is, at rest and each time that the samples have doubled. */
  | { readonly kind: 'denoise'; readonly on: boolean }
  /** Asks for the film as an EXR file; denoised as far as it is. */
  | { readonly kind: 'exr'; readonly origin: Origin; readonly denoised: boolean };

export interface Device {
  /** '2 CPU threads', a GPU's name. */
  readonly name: string;
  /** Why it is not a GPU; empty where it is one. */
  readonly note: string;
}

export interface Figures {
  /** Per pixel. */
  readonly samples: number;
  /** Spent on them, without packing and pauses. */
  readonly seconds: number;
  /** Relative; infinite before two samples. */
  readonly error: number;
  /** Camera paths. */
  readonly pathsPerSecond: number;
  /** The goal that was reached. */
  readonly reached: 'samples' | 'error' | null;
}

export interface TracedPicture {
  readonly width: number;
  readonly height: number;
  /** Mean radiance: RGBA half floats, row 0 at the top. */
  readonly pixels: Uint16Array<ArrayBuffer>;
}

/** What is done before the first sample and with it. */
export type Phase = 'packing' | 'compiling' | 'tracing';

export type FromDirector =
  | { readonly kind: 'device'; readonly device: Device }
  | { readonly kind: 'phase'; readonly ticket: number; readonly phase: Phase; readonly part: number }
  | {
      readonly kind: 'picture';
      readonly ticket: number;
      readonly picture: TracedPicture;
      readonly figures: Figures;
      /** Scenes packed so far: a move of the camera packs none. */
      readonly packed: number;
    }
  | { readonly kind: 'denoising'; readonly ticket: number; readonly part: number }
  | {
      readonly kind: 'denoised';
      readonly ticket: number;
      readonly picture: TracedPicture;
      /** Per pixel, of the film that was denoised. */
      readonly samples: number;
    }
  | { readonly kind: 'not-denoised'; readonly ticket: number; readonly message: string }
  | { readonly kind: 'failed'; readonly ticket: number; readonly message: string }
  | { readonly kind: 'exr'; readonly file: Uint8Array<ArrayBuffer> | null };
