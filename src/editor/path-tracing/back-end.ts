/** What traces the paths: the GPU where there is a real one, otherwise every core of the CPU. */
import { CpuPathTracer } from '../../pathtracer/cpu/cpu-path-tracer.ts';
import type { FromWorker, WorkerPort } from '../../pathtracer/cpu/protocol.ts';
import { GpuPathTracer } from '../../pathtracer/gpu/gpu-path-tracer.ts';
import type { Stage } from './director.ts';
import type { Device } from './messages.ts';

export async function openStage(tell: (device: Device) => void): Promise<Stage> {
  const gpu = await findGpu();
  if (typeof gpu !== 'string') {
    tell({ name: gpu.tracer.device, note: '' });
    return { tracer: gpu.tracer, maxBytes: gpu.tracer.maxBytes };
  }
  const tracer = new CpuPathTracer({
    workers: navigator.hardwareConcurrency || 1,
    spawn: spawnThread,
    shared: globalThis.crossOriginIsolated,
  });
  tell({ name: tracer.device, note: gpu });
  return { tracer, maxBytes: undefined };
}

/** @returns why there is none */
async function findGpu(): Promise<{ tracer: GpuPathTracer } | string> {
  if (!navigator.gpu) return 'this browser has no WebGPU';
  try {
    const adapter = await navigator.gpu.requestAdapter({ powerPreference: 'high-performance' });
    if (adapter === null) return 'WebGPU found no GPU';
    const { info, limits } = adapter;
    // Threads of our own are faster than a GPU made of threads.
    if (info.isFallbackAdapter || isSoftware(info)) return 'WebGPU is only emulated here';
    const { maxBufferSize, maxStorageBufferBindingSize } = limits;
    const device = await adapter.requestDevice({
      requiredLimits: { maxBufferSize, maxStorageBufferBindingSize },
    });
    return { tracer: new GpuPathTracer(device, info.description || `${info.vendor} ${info.architecture}`) };
  } catch (error) {
    return `WebGPU did not start: ${error instanceof Error ? error.message : String(error)}`;
  }
}

/** Browsers do not always call software a fallback. */
function isSoftware({ architecture, description }: GPUAdapterInfo): boolean {
  return /swiftshader|llvmpipe|lavapipe|basic render/i.test(`${architecture} ${description}`);
}

function spawnThread(): WorkerPort {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  return {
    post: (message) => worker.postMessage(message),
    onMessage: (listener) =>
      worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => listener(data)),
    onError(listener) {
      worker.addEventListener('error', (event) => listener(event.message || 'it could not be loaded'));
      worker.addEventListener('messageerror', () => listener('a message could not be read'));
    },
    terminate: () => worker.terminate(),
  };
}
