import { afterAll } from 'vitest';
import { type NodeGpu, requestGpu } from '../../src/cli/gpu.ts';
import { createNodeRenderer, type NodeRenderer } from '../../src/cli/node-renderer.ts';

/**
 * A GPU for the tests of one file (x.gpu.test.ts): a real one if IRRADIA_TEST_DEVICE=gpu, else the
 * software one, which gives the same bits on every machine. It is given back after the file's last test.
 */
const device = process.env.IRRADIA_TEST_DEVICE === 'gpu' ? 'gpu' : 'software';

/** A GPU error that no test awaited fails the run: Vitest counts it as an unhandled error. */
const onFatal = (message: string): void => {
  queueMicrotask(() => {
    throw new Error(message);
  });
};

export async function testGpu(): Promise<NodeGpu> {
  const gpu = await requestGpu({ device, onFatal });
  afterAll(() => gpu.device.destroy());
  return gpu;
}

/** Call it in a beforeAll or at the top of the file. */
export async function testRenderer(width: number, height: number, antialias = false): Promise<NodeRenderer> {
  const renderer = await createNodeRenderer({ width, height, antialias, device, onFatal });
  afterAll(() => renderer.dispose());
  return renderer;
}
