/** When the GPU has finished what was submitted so far: what a frame took, not what its submission took. */
import type { RealtimeRenderer } from '../../realtime/renderer.ts';

const POLL_MS = 2;
/** A fence that a lost context never signals must not hold the loop for ever. */
const GIVE_UP_MS = 10_000;

export function gpuFinished(renderer: RealtimeRenderer): Promise<void> {
  const backend = renderer.three.backend as { device?: GPUDevice; gl?: WebGL2RenderingContext };
  if (backend.device) return backend.device.queue.onSubmittedWorkDone();
  const { gl } = backend;
  const fence = gl?.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!gl || !fence) return Promise.resolve();
  gl.flush();
  const start = performance.now();
  return new Promise((resolve) => {
    const poll = () => {
      const pending = gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.UNSIGNALED;
      if (pending && performance.now() - start < GIVE_UP_MS && !gl.isContextLost()) {
        window.setTimeout(poll, POLL_MS);
        return;
      }
      gl.deleteSync(fence);
      resolve();
    };
    poll();
  });
}
