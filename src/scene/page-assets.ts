/** What decoding of assets needs of a browser. */
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import type { AssetPlatform } from './assets.ts';

export const pageAssets: AssetPlatform = {
  async decodeImage(bytes, mediaType) {
    if (mediaType === 'image/ktx2') return (await import('./page-ktx2.ts')).decodeKtx2(bytes);
    return createImageBitmap(new Blob([bytes], { type: mediaType }), {
      imageOrientation: 'flipY',
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    });
  },
  dracoLoader: () => new DRACOLoader(),
};
