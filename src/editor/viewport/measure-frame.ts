/** What a frame takes this device. */
import type { RealtimeRenderer, Size } from '../../realtime/renderer.ts';
import type { SceneMirror } from '../../scene/mirror.ts';
import type { Session } from '../session.ts';
import { gpuFinished } from './gpu-finish.ts';

/** The first frames after another warm up what is needed. */
const MEASURED_FRAMES = 8;
/** A slow device is known after less. */
const MEASURING_MS = 100;

interface Measured {
  readonly mirror: SceneMirror;
  readonly renderer: RealtimeRenderer;
  readonly session: Session;
}

/** What a frame of the present document takes the GPU, in ms: the least of a few. */
export async function leastFrameTime({ mirror, renderer, session }: Measured, size: Size): Promise<number> {
  const timed = session.state.value.gpuTimes;
  renderer.times.on = true;
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < MEASURED_FRAMES && i * least < MEASURING_MS; i++) {
    const start = performance.now();
    renderer.render(mirror, session.store.document, size);
    await gpuFinished(renderer);
    const passed = performance.now() - start;
    const times = await renderer.times.read();
    least = Math.min(least, times?.reduce((sum, { milliseconds }) => sum + milliseconds, 0) ?? passed);
  }
  renderer.times.on = timed;
  return least;
}
