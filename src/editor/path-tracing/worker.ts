/** One of the path tracer's CPU threads. */
import type { ToWorker } from '../../pathtracer/cpu/protocol.ts';
import { WorkerCore } from '../../pathtracer/cpu/worker-core.ts';

const core = new WorkerCore((message, transfer) => self.postMessage(message, { transfer }));
self.addEventListener('message', ({ data }: MessageEvent<ToWorker>) => core.receive(data));
