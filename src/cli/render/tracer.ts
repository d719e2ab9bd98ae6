/** The machine that a rendering is made by. */

import { GpuPathTracer } from '../../pathtracer/gpu/gpu-path-tracer.ts';
import type { PathTracer } from '../../pathtracer/path-tracer.ts';
import { PathTracerError } from '../../pathtracer/scene/error.ts';
import { ScenePacker } from '../../pathtracer/scene/pack.ts';
import { AssetLoader } from '../../scene/assets.ts';
import type { Document } from '../../scene/schema.ts';
import { CliError } from '../command.ts';
import { type DeviceChoice, GpuUnavailableError, requestGpu } from '../gpu.ts';
import { nodeAssets } from '../node-assets.ts';
import { createCpuPathTracer } from '../path-tracer.ts';

export interface Machine {
  readonly tracer: PathTracer;
  /** So many paths take a fraction of a second: work that an interruption throws away at most. */
  readonly pathsPerPass: number;
  /** The most bytes that a scene may take; undefined leaves it to the path tracer. */
  readonly maxBytes: number | undefined;
  /** Rejects when the machine is lost. */
  readonly lost: Promise<never>;
  dispose(): void;
}

/** Half a second of two cores, a tenth of a GPU. */
const PATHS_PER_PASS = { cpu: 2 ** 19, gpu: 2 ** 24 } as const;

/** @param device auto is a GPU if there is one, else the CPU, which is what software means here */
export async function createMachine(device: DeviceChoice): Promise<Machine> {
  if (device === 'software') return cpuMachine();
  try {
    return await gpuMachine();
  } catch (error) {
    if (device === 'gpu' || !(error instanceof GpuUnavailableError)) throw error;
    return cpuMachine();
  }
}

function cpuMachine(): Machine {
  const tracer = createCpuPathTracer();
  return {
    tracer,
    pathsPerPass: PATHS_PER_PASS.cpu,
    maxBytes: undefined,
    // A worker that dies makes render() reject.
    lost: new Promise(() => {}),
    dispose: () => tracer.dispose(),
  };
}

async function gpuMachine(): Promise<Machine> {
  let reject: (error: Error) => void = () => {};
  const lost = new Promise<never>((_, rejectLost) => {
    reject = rejectLost;
  });
  // Whoever waits for it hears of it; that nobody may wait is no error.
  lost.catch(() => {});
  const onFatal = (message: string) => reject(new Error(message));
  const found = await requestGpu({ device: 'gpu', onFatal });
  const tracer = new GpuPathTracer(found.device, found.adapter.info.description);
  return {
    tracer,
    pathsPerPass: PATHS_PER_PASS.gpu,
    maxBytes: tracer.maxBytes,
    lost,
    dispose() {
      tracer.dispose();
      // Dawn's instance must outlive its devices: `found` keeps it from the garbage collector.
      found.device.destroy();
    },
  };
}

/** @throws CliError if a part of the document is missing or wrong, or the machine's memory does not hold the scene */
export async function loadScene(
  { tracer, maxBytes, lost }: Machine,
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
    await Promise.race([tracer.load(scene), lost]);
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
