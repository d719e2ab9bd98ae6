/** KTX 2.0 images in a page, by three.js's loader, whose transcoder is served with the page. */
import transcoderUrl from 'three/addons/libs/basis/basis_transcoder.js?url';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import { type CompressedTexture, LoadingManager } from 'three/webgpu';
import { checkKtx2, cropAndFlip, withoutGeneratedCode } from '../io/ktx2.ts';
import type { TextureImage } from './assets.ts';

let loading: Promise<KTX2Loader> | null = null;

/** RGBA on every machine: the path tracer reads texels, which no GPU's own format would give it. */
function transcoder(): Promise<KTX2Loader> {
  loading ??= (async () => {
    const text = await (await fetch(transcoderUrl)).text();
    const address = URL.createObjectURL(new Blob([withoutGeneratedCode(text)]));
    const manager = new LoadingManager();
    manager.setURLModifier((url) => (/basis_transcoder[^/]*\.js$/.test(url) ? address : url));
    const loader = new KTX2Loader(manager);
    // What detectSupport() would set, for a GPU that takes no compressed texture.
    (loader as unknown as { workerConfig: object }).workerConfig = {};
    return loader.setWorkerLimit(2);
  })();
  return loading;
}

export async function decodeKtx2(bytes: Uint8Array<ArrayBuffer>): Promise<TextureImage> {
  const size = checkKtx2(bytes, 'KTX2');
  const loader = await transcoder();
  const texture = await new Promise<CompressedTexture>((resolve, reject) => {
    // The buffer is handed over to the transcoder's thread.
    loader.parse(bytes.slice().buffer, resolve as never, (error) =>
      reject(error instanceof Error ? error : new Error(String(error))),
    );
  });
  const [level] = texture.mipmaps ?? [];
  if (!level || level.data.length < 4 * size.width * size.height) throw new Error('no texels came of it');
  return cropAndFlip(level.data as Uint8Array, size);
}
