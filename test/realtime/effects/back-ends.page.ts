import { createRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { pageAssets } from '../../../src/scene/page-assets.ts';

export interface EffectsRequest {
  forceWebGL: boolean;
  /** Documents, each drawn twice: from a little to the left, and then as it is. */
  documents: Record<string, unknown>[];
  size: { width: number; height: number };
}

export interface EffectsFrames {
  backend: string;
  /** Of each document: its radiance and its picture, RGBA with rows from the top. */
  frames: { radiance: number[]; image: number[]; exposure: number }[];
}

export default async function draw({ forceWebGL, documents, size }: EffectsRequest): Promise<EffectsFrames> {
  const renderer = await createRenderer({ forceWebGL });
  // One for all: what documents have in common is compiled once.
  const mirror = new SceneMirror({
    assets: new AssetLoader(pageAssets),
    onError(message) {
      throw new Error(message);
    },
  });
  const frames: EffectsFrames['frames'] = [];
  for (const json of documents) {
    const document = parseDocument(json, 'page');
    mirror.apply(document);
    await mirror.settled();
    renderer.cut();
    mirror.camera.position.x -= 0.1;
    renderer.render(mirror, document, size, 1 / 60);
    mirror.camera.position.x += 0.1;
    renderer.render(mirror, document, size, 1 / 60);
    await renderer.settleExposure(document.view);
    const { pixels } = await renderer.readRadiance();
    const image = await renderer.readImage(document.view);
    frames.push({ radiance: [...pixels], image: [...image], exposure: renderer.exposure(document.view) });
  }
  mirror.dispose();
  return { backend: renderer.backend, frames };
}
