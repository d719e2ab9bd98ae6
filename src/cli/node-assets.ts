import type { AssetPlatform } from '../scene/assets.ts';
import { decodeImage, flipRows } from './node-image.ts';

/** What decoding of a document's assets needs of Node. */
export const nodeAssets: AssetPlatform = {
  async decodeImage(bytes) {
    const { width, height, data } = await decodeImage(bytes);
    return { width, height, data: flipRows(data, width * 4) };
  },
  dracoLoader() {
    throw new Error('Draco compression needs a browser; save the file without it');
  },
};
