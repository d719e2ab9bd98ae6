/** What a rendering was made of, as files keep it: the attributes of an EXR, the texts of a PNG. */
import { serializeDocument } from '../scene/document.ts';
import type { Document, View } from '../scene/schema.ts';
import { formatRanges, type Range } from './ranges.ts';
import type { RenderSettings } from './scene/camera.ts';

/** What must be the same for two renderings to be parts of one. */
export interface RenderIdentity {
  readonly renderer: 'pathtracer' | 'realtime';
  /** Irradia's. */
  readonly version: string;
  /** SHA-256 of the document, serialized; empty where it is not known, which no file then says. */
  readonly document: string;
  /** As JSON: an animation turns the document's. */
  readonly camera: string;
  readonly seed: number;
  readonly maxDepth: number;
  readonly clamp: number;
  readonly strategy: RenderSettings['strategy'];
}

export interface RenderRecord extends RenderIdentity {
  /** The document's, for a person to read. */
  readonly name: string;
  /** Numbers of the samples that the pixels have: all of them, unless the picture has a channel of their counts. */
  readonly samples: readonly Range[];
  /** When it was to end: 'spp 64'. */
  readonly until: string;
  readonly device: string;
  readonly exposure: number;
  readonly toneMapping: View['toneMapping'];
  /** Whether R, G and B are what the denoiser made of it. */
  readonly denoised: boolean;
}

/** SHA-256, in hexadecimal digits, of what a file of the document holds. Needs a secure page, or Node. */
export async function documentHash(document: Document): Promise<string> {
  const text = new TextEncoder().encode(serializeDocument(document));
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', text));
  return [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** Of the names of the attributes. */
export const PREFIX = 'irradia:';

export function toAttributes({
  samples,
  denoised,
  document,
  ...record
}: RenderRecord): Record<string, string | number> {
  const own = {
    ...record,
    ...(document !== '' && { document }),
    samples: formatRanges(samples),
    ...(denoised && { denoised: 'yes' }),
  };
  const entries = Object.entries(own).map(([name, value]) => [
    PREFIX + name,
    // A whole number of an EXR's header has 32 bits, one of them its sign.
    typeof value === 'number' && (value | 0) !== value ? String(value) : value,
  ]);
  return { software: `Irradia ${record.version}`, ...Object.fromEntries(entries) };
}
