import type { AssetPlatform } from '../scene/assets.ts';
import { NodeDracoLoader } from './node-draco.ts';
import { decodeImage, flipRows } from './node-image.ts';

/** What decoding of a document's assets needs of Node. */
export const nodeAssets: AssetPlatform = {
  async decodeImage(bytes, mediaType) {
    if (mediaType === 'image/ktx2') return (await import('./node-ktx2.ts')).decodeKtx2(bytes);
    const { width, height, data } = await decodeImage(bytes);
    return { width, height, data: flipRows(data, width * 4) };
  },
  dracoLoader: () => new NodeDracoLoader(),
};
