/** Frames of documents, with effects, for tests: call inside a x.gpu.test.ts. */
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { testRenderer } from '../../support/gpu.ts';

export interface FrameOptions {
  width: number;
  height: number;
  /** How many frames are drawn before the last one is read. */
  frames?: number;
}

export interface Picture {
  width: number;
  height: number;
  /** RGBA, rows from the top, linear radiance with the effects on it. */
  pixels: Float32Array;
}

/** A frame's: a clock would make what moves depend on how busy the machine is. */
const SECONDS = 1 / 60;

/** Draws documents with one renderer: float radiance, one sample a pixel. */
export async function frameMaker({ width, height, frames = 1 }: FrameOptions) {
  const { renderer: three } = await testRenderer(width, height);
  const renderer = new RealtimeRenderer(three, { samples: 1, precision: 'float' });
  return {
    renderer,
    async mirror(document: Document): Promise<SceneMirror> {
      const mirror = new SceneMirror({
        assets: new AssetLoader(nodeAssets),
        onError(message) {
          throw new Error(message);
        },
      });
      mirror.apply(document);
      await mirror.settled();
      return mirror;
    },
    /** The last of some frames, before which there was nothing: a mirror that shows what was before keeps its order. */
    async draw(document: Document, count = frames): Promise<Picture> {
      const mirror = await this.mirror(document);
      renderer.cut();
      for (let i = 0; i < count; i++) renderer.render(mirror, document, { width, height }, SECONDS);
      const picture = await renderer.readRadiance();
      mirror.dispose();
      return picture;
    },
  };
}

/** The mean of a picture's colour channels. */
export function meanRadiance({ pixels }: Picture): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < pixels.length; i += 4) {
    for (const c of [0, 1, 2] as const) sum[c] += pixels[i + c]! / (pixels.length / 4);
  }
  return sum;
}

/** The share of colour values that differ by more than a tolerance. */
export function shareThatDiffers(a: Picture, b: Picture, tolerance = 1e-3): number {
  let count = 0;
  for (let i = 0; i < a.pixels.length; i++) {
    if (i % 4 < 3 && Math.abs(a.pixels[i]! - b.pixels[i]!) > tolerance) count++;
  }
  return count / ((a.pixels.length / 4) * 3);
}
