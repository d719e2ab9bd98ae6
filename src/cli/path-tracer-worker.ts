/** A worker thread of the path tracer. */
import { parentPort } from 'node:worker_threads';
import type { ToWorker } from '../pathtracer/cpu/protocol.ts';
import { WorkerCore } from '../pathtracer/cpu/worker-core.ts';

const core = new WorkerCore((message, transfer) => parentPort?.postMessage(message, transfer));
parentPort?.on('message', (message: ToWorker) => core.receive(message));
