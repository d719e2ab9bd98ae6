/** What the page and the thread that puts a picture together say to each other. */
import type { Display } from '../../../color/tone-mapping.ts';
import type { Tile } from './tiles.ts';

export const formats = ['png', 'jpg', 'exr'] as const;
export type PictureFormat = (typeof formats)[number];

export type ToPicture =
  | {
      readonly kind: 'begin';
      readonly width: number;
      readonly height: number;
      readonly format: PictureFormat;
      /** Whether what nothing covers is to be seen through, in formats that can say so. */
      readonly transparent: boolean;
    }
  /** RGBA: bytes as a screen shows them, or linear radiance for an EXR. */
  | { readonly kind: 'tile'; readonly tile: Tile; readonly pixels: Uint8Array | Float32Array }
  /** All of it as linear half floats, RGBA; how a screen shows them, where the format is one of screens. */
  | { readonly kind: 'radiance'; readonly pixels: Uint16Array; readonly display: Display }
  | { readonly kind: 'finish' };

export type FromPicture =
  | { readonly kind: 'file'; readonly file: Blob }
  | { readonly kind: 'failed'; readonly message: string };
