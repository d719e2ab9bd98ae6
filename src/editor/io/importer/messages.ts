/** What the page and the thread that reads its files say to each other. */
import type { ImportedModel } from '../../../io/gltf.ts';
import type { MaterialFile } from '../../../io/material-file.ts';
import type { Document } from '../../../scene/schema.ts';
import type { SentAsset, SentDocument } from '../../threads/sent-assets.ts';

/** A file and where it lay in the folder, archive or address that it came from. */
export interface PlacedFile {
  readonly path: string;
  readonly file: Blob;
}

export type ToImporter =
  /** Reads one file; the others came with it. */
  | { readonly kind: 'import'; readonly main: PlacedFile; readonly others: readonly PlacedFile[] }
  | { readonly kind: 'unzip'; readonly archive: PlacedFile }
  | { readonly kind: 'fetch'; readonly url: string }
  | { readonly kind: 'environment'; readonly asset: SentAsset }
  /** Makes a GLB of a document. */
  | { readonly kind: 'export'; readonly document: SentDocument }
  /** Opens a glTF asset of a document, for what follows. */
  | { readonly kind: 'open'; readonly asset: SentAsset };

/** Of the model that was read or opened last. */
export type ModelQuestion =
  | { readonly kind: 'geometry'; readonly node: number; readonly primitive: number }
  | { readonly kind: 'image'; readonly texture: number };

export type ModelAnswer =
  /** `data` is null where it has been sent before under the same key. */
  | { readonly kind: 'geometry'; readonly key: string; readonly data: GeometryData | null }
  | { readonly kind: 'image'; readonly image: ImageBitmap | ImageData8 };

export type ImportResult =
  | {
      readonly kind: 'model';
      /** Its asset has the text that came before, in parts. */
      readonly imported: ImportedModel;
      /** Of the asset; null where there is none, or the page may not hash. */
      readonly bytes: { readonly sha256: string; readonly blob: Blob } | null;
    }
  | { readonly kind: 'document'; readonly document: Document }
  | { readonly kind: 'material'; readonly material: MaterialFile }
  | { readonly kind: 'environment'; readonly environment: EnvironmentData }
  | {
      readonly kind: 'files';
      readonly files: readonly { path: string; bytes: Uint8Array<ArrayBuffer> }[];
      /** What could not be kept. */
      readonly notes: readonly string[];
    };

/** What a data texture is made of; the numbers of type, format and filters are three.js's. */
export interface EnvironmentData {
  readonly data: Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
  readonly format: number;
  readonly type: number;
  readonly colorSpace: string;
  readonly flipY: boolean;
}

/** Attributes of a geometry, each with how many values a vertex has. */
export interface GeometryData {
  readonly attributes: Readonly<Record<string, { array: Float32Array<ArrayBuffer>; itemSize: number }>>;
  readonly index: Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer> | null;
  readonly box: readonly number[];
  /** Centre and radius. */
  readonly sphere: readonly number[];
}

export type FromImporter =
  | { readonly kind: 'progress'; readonly text: string; readonly fraction: number | null }
  /** A part of the asset's text: to copy all of it at once would take too long. */
  | { readonly kind: 'text'; readonly part: string }
  | { readonly kind: 'done'; readonly result: ImportResult }
  | { readonly kind: 'failed'; readonly message: string };

export interface ImageData8 {
  readonly data: Uint8Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
}
