import { createRenderer, RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { pageAssets } from '../../../src/scene/page-assets.ts';

export interface ScreenSpaceRequest {
  forceWebGL: boolean;
  /** Drawn one after the other by one renderer. */
  documents: unknown[];
  size: { width: number; height: number };
  frames: number;
}

export interface ScreenSpaceFrames {
  backend: string;
  /** RGBA, rows from the top, of the last frame of each document. */
  pictures: number[][];
}

export default async function screenSpace(request: ScreenSpaceRequest): Promise<ScreenSpaceFrames> {
  const { forceWebGL, size, frames } = request;
  const { three } = await createRenderer({ forceWebGL });
  const renderer = new RealtimeRenderer(three, { samples: 1, precision: 'float' });
  // One for all: what documents have in common is compiled once.
  const mirror = new SceneMirror({
    assets: new AssetLoader(pageAssets),
    onError(message) {
      throw new Error(message);
    },
  });
  const pictures: number[][] = [];
  for (const source of request.documents) {
    const document = parseDocument(source, 'test');
    mirror.apply(document);
    await mirror.settled();
    renderer.cut();
    for (let i = 0; i < frames; i++) renderer.render(mirror, document, size);
    pictures.push([...(await renderer.readRadiance()).pixels]);
  }
  mirror.dispose();
  return { backend: renderer.backend, pictures };
}
