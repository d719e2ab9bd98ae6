/** What the path tracer and its workers say to each other. */

/** A scene and the kernel for its models. */
export interface LoadMessage {
  readonly kind: 'load';
  readonly module: WebAssembly.Module;
  /** The scene's memory: its own copy, or null where `memory` is shared and has it. */
  readonly words: Uint32Array<ArrayBuffer> | null;
  readonly memory: WebAssembly.Memory | null;
  /** Where this worker's part of a shared memory is, in bytes. */
  readonly places: WorkerPlaces | null;
}

export interface WorkerPlaces {
  readonly scene: number;
  readonly film: number;
  readonly stack: number;
}

/** The header's slots that a rendering sets: camera and settings. */
export interface SetMessage {
  readonly kind: 'set';
  readonly settings: Uint32Array;
}

/** Samples `first` to `first + count - 1` of the pixels `from` to `to - 1`. */
export interface JobMessage {
  readonly kind: 'job';
  readonly number: number;
  readonly from: number;
  readonly to: number;
  readonly first: number;
  readonly count: number;
}

export type ToWorker = LoadMessage | SetMessage | JobMessage;

export type FromWorker =
  | { readonly kind: 'done'; readonly number: number; readonly from: number; readonly film: Float32Array }
  | { readonly kind: 'failed'; readonly message: string };

/** A worker, as a page and Node have it in their own ways. */
export interface WorkerPort {
  post(message: ToWorker): void;
  onMessage(listener: (message: FromWorker) => void): void;
  /** The worker died: it could not be loaded, or ran out of memory. */
  onError(listener: (message: string) => void): void;
  terminate(): void;
}
