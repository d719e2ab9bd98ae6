export { decodeExr } from './exr-decode.ts';
export { encodeExr } from './exr-encode.ts';
export type { ExrChannel, ExrImage, ExrOptions } from './exr-format.ts';
