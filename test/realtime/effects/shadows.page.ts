import { createRenderer, RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { pageAssets } from '../../../src/scene/page-assets.ts';

export interface ShadowRequest {
  forceWebGL: boolean;
  document: unknown;
  size: { width: number; height: number };
}

export interface ShadowFrame {
  backend: string;
  /** RGBA, rows from the top, of the second frame. */
  pixels: number[];
}

export default async function shadows({ forceWebGL, document, size }: ShadowRequest): Promise<ShadowFrame> {
  const { three } = await createRenderer({ forceWebGL });
  const renderer = new RealtimeRenderer(three, { samples: 1, precision: 'float' });
  const content = parseDocument(document, 'page');
  const mirror = new SceneMirror({
    assets: new AssetLoader(pageAssets),
    onError(message) {
      throw new Error(message);
    },
  });
  mirror.apply(content);
  await mirror.settled();
  await renderer.compile(mirror, content, size);
  renderer.render(mirror, content, size);
  renderer.render(mirror, content, size);
  const { pixels } = await renderer.readRadiance();
  return { backend: renderer.backend, pixels: [...pixels] };
}
