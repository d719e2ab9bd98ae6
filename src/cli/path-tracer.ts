/** The path tracer in Node: worker threads that share the scene's memory. */
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { CpuPathTracer } from '../pathtracer/cpu/cpu-path-tracer.ts';
import type { FromWorker, WorkerPort } from '../pathtracer/cpu/protocol.ts';
import { packageRoot } from './package-root.ts';

/** Built beside the command line: Node does not load TypeScript. */
const WORKER = join(packageRoot, 'dist/cli/path-tracer-worker.js');

/** Its threads keep the process alive until dispose(). @param workers one per core unless said otherwise */
export function createCpuPathTracer(workers = availableParallelism()): CpuPathTracer {
  return new CpuPathTracer({ workers, spawn, shared: true });
}

function spawn(): WorkerPort {
  const worker = new Worker(WORKER);
  return {
    post: (message) => worker.postMessage(message),
    onMessage: (listener) => worker.on('message', (message: FromWorker) => listener(message)),
    onError: (listener) => {
      worker.on('error', (error) => listener(error.message));
      worker.on('messageerror', (error) => listener(error.message));
      // Without an error: something ended the thread. After terminate() nobody listens any more.
      worker.on('exit', (code) => listener(`it ended with code ${code}`));
    },
    terminate: () => void worker.terminate(),
  };
}
