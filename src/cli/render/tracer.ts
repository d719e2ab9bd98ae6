/** The machine that a rendering is made by. */

import type { PathTracer } from '../../pathtracer/path-tracer.ts';
import { PathTracerError } from '../../pathtracer/scene/error.ts';
import { ScenePacker } from '../../pathtracer/scene/pack.ts';
import { AssetLoader } from '../../scene/assets.ts';
import type { Document } from '../../scene/schema.ts';
import { CliError } from '../command.ts';
import type { DeviceChoice } from '../gpu.ts';
import { nodeAssets } from '../node-assets.ts';
import { createCpuPathTracer } from '../path-tracer.ts';

export interface Machine {
  readonly tracer: PathTracer;
  /** So many paths take a fraction of a second: work that an interruption throws away at most. */
  readonly pathsPerPass: number;
  /** The most bytes that a scene may take. */
  readonly maxBytes: number | undefined;
}

/** Half a second of two cores. */
const CPU_PATHS_PER_PASS = 2 ** 19;

export async function createMachine(device: DeviceChoice): Promise<Machine> {
  if (device === 'gpu') throw new CliError('--device gpu: the path tracer has no GPU back end yet');
  return { tracer: createCpuPathTracer(), pathsPerPass: CPU_PATHS_PER_PASS, maxBytes: undefined };
}

/** @throws CliError if a part of the document is missing or wrong, or the machine's memory does not hold the scene */
export async function loadScene(
  { tracer, maxBytes }: Machine,
  document: Document,
  signal: AbortSignal,
  onProgress: (part: number) => void,
): Promise<void> {
  const packer = new ScenePacker(new AssetLoader(nodeAssets));
  try {
    const scene = await packer.pack(document, {
      signal,
      onProgress,
      ...(maxBytes !== undefined && { maxBytes }),
    });
    signal.throwIfAborted();
    await tracer.load(scene);
  } catch (error) {
    // Engines report memory that they do not get as a RangeError.
    if (error instanceof RangeError)
      throw new CliError(`the scene does not fit into memory: ${error.message}`, { cause: error });
    // Assets that cannot be decoded are plain errors; any other kind would be a fault of ours.
    if (error instanceof PathTracerError || (error as Error).constructor === Error)
      throw new CliError((error as Error).message, { cause: error });
    throw error;
  } finally {
    packer.dispose();
  }
}
