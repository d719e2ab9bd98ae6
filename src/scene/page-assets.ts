/** What decoding of assets needs of a browser. */
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import type { AssetPlatform } from './assets.ts';

export const pageAssets: AssetPlatform = {
  decodeImage: (bytes, mediaType) =>
    createImageBitmap(new Blob([bytes], { type: mediaType }), {
      imageOrientation: 'flipY',
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    }),
  dracoLoader: () => new DRACOLoader(),
};
