import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { pageAssets } from '../../../src/scene/page-assets.ts';
import { readTexels } from '../../../src/scene/texels.ts';

/** Texels of an image as a page reads them, and a scene with that image packed in the page. */
export default async function packInPage({ png, document }: { png: string; document: object }) {
  const loader = new AssetLoader(pageAssets);
  const image = await loader.image({ name: 'image', mediaType: 'image/png', data: png }, null);
  const { bytes, width, height } = readTexels(image);
  const { words, triangles } = await new ScenePacker(loader).pack(parseDocument(document, 'test'));
  return { texels: [...bytes], width, height, words: [...words], triangles };
}
