import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { compileFunction } from 'node:vm';
import { checkKtx2, cropAndFlip, withoutGeneratedCode } from '../io/ktx2.ts';
import type { TextureImage } from '../scene/assets.ts';

/** Basis Universal's transcoder as far as it is used. */
interface Basis {
  initializeBasis(): void;
  KTX2File: new (bytes: Uint8Array) => Ktx2File;
}
interface Ktx2File {
  isValid(): boolean;
  startTranscoding(): boolean;
  getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number;
  transcodeImage(
    to: Uint8Array,
    level: number,
    layer: number,
    face: number,
    format: number,
    unused: number,
    channel0: number,
    channel1: number,
  ): boolean;
  close(): void;
  delete(): void;
}

/** The transcoder's number for 8-bit RGBA. */
const RGBA32 = 13;

let loading: Promise<Basis> | null = null;

/** Loaded as Draco's decoder is, and for the same reasons: see node-draco.ts. */
function loadBasis(): Promise<Basis> {
  loading ??= (async () => {
    const { resolve } = createRequire(import.meta.url);
    const read = (name: string) => readFileSync(resolve(`three/addons/libs/basis/${name}`));
    const module: { exports: unknown } = { exports: {} };
    compileFunction(withoutGeneratedCode(read('basis_transcoder.js').toString()), [
      'module',
      'exports',
      'process',
    ])(module, module.exports, undefined);
    const start = module.exports as (options: { wasmBinary: Uint8Array }) => Promise<Basis>;
    const basis = await start({ wasmBinary: read('basis_transcoder.wasm') });
    basis.initializeBasis();
    return basis;
  })();
  return loading;
}

export async function decodeKtx2(bytes: Uint8Array): Promise<TextureImage> {
  const size = checkKtx2(bytes, 'KTX2');
  const basis = await loadBasis();
  const file = new basis.KTX2File(bytes);
  try {
    if (!file.isValid() || !file.startTranscoding()) throw new Error('its texels are not Basis Universal');
    const texels = new Uint8Array(file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32));
    if (!file.transcodeImage(texels, 0, 0, 0, RGBA32, 0, -1, -1)) throw new Error('it cannot be transcoded');
    return cropAndFlip(texels, size);
  } finally {
    file.close();
    file.delete();
  }
}
