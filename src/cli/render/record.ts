/** What a rendering was made of, as files keep it: the attributes of an EXR, the texts of a PNG. */
import { createHash } from 'node:crypto';
import type { RenderSettings } from '../../pathtracer/scene/camera.ts';
import { serializeDocument } from '../../scene/document.ts';
import type { Document, View } from '../../scene/schema.ts';
import { CliError } from '../command.ts';
import { formatRanges, parseRanges, type Range } from './ranges.ts';

/** What must be the same for two renderings to be parts of one. */
export interface RenderIdentity {
  readonly renderer: 'pathtracer' | 'realtime';
  /** Irradia's. */
  readonly version: string;
  /** SHA-256 of the document, serialized. */
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

export function documentHash(document: Document): string {
  return createHash('sha256').update(serializeDocument(document)).digest('hex');
}

type Attributes = Readonly<Record<string, string | number>>;

const PREFIX = 'irradia:';

export function toAttributes({
  samples,
  denoised,
  ...record
}: RenderRecord): Record<string, string | number> {
  const own = { ...record, samples: formatRanges(samples), ...(denoised && { denoised: 'yes' }) };
  const entries = Object.entries(own).map(([name, value]) => [
    PREFIX + name,
    // A whole number of an EXR's header has 32 bits, one of them its sign.
    typeof value === 'number' && (value | 0) !== value ? String(value) : value,
  ]);
  return { software: `Irradia ${record.version}`, ...Object.fromEntries(entries) };
}

/** @throws CliError naming the file and the attribute that is missing or wrong */
export function fromAttributes(attributes: Attributes, fileName: string): RenderRecord {
  const text = (name: string): string => {
    const value = attributes[PREFIX + name];
    if (value === undefined)
      throw new CliError(
        `${fileName}: the header has no ${PREFIX}${name}; expected a file by \`irradia render\``,
      );
    return String(value);
  };
  const number = (name: string): number => {
    const value = Number(text(name));
    if (!Number.isFinite(value))
      throw new CliError(`${fileName}: ${PREFIX}${name} is '${text(name)}'; expected a number`);
    return value;
  };
  const samples = parseRanges(text('samples'));
  if (samples === null)
    throw new CliError(`${fileName}: ${PREFIX}samples is '${text('samples')}'; expected ranges such as 0:64`);
  return {
    renderer: text('renderer') as RenderRecord['renderer'],
    version: text('version'),
    document: text('document'),
    camera: text('camera'),
    seed: number('seed'),
    maxDepth: number('maxDepth'),
    clamp: number('clamp'),
    strategy: text('strategy') as RenderRecord['strategy'],
    name: text('name'),
    samples,
    until: text('until'),
    device: text('device'),
    exposure: number('exposure'),
    toneMapping: text('toneMapping') as RenderRecord['toneMapping'],
    denoised: attributes[`${PREFIX}denoised`] === 'yes',
  };
}

/** What the fields of RenderIdentity are called in messages. */
const FIELDS: Readonly<Record<keyof RenderIdentity, string>> = {
  renderer: 'renderer',
  version: 'version of Irradia',
  document: 'document',
  camera: 'camera',
  seed: 'seed',
  maxDepth: 'maximal depth',
  clamp: 'clamp',
  strategy: 'strategy',
};

/** The first field in which two renderings differ, with both values; null if they are parts of one. */
export function difference(a: RenderIdentity, b: RenderIdentity): string | null {
  for (const [field, what] of Object.entries(FIELDS) as [keyof RenderIdentity, string][]) {
    if (a[field] === b[field]) continue;
    return field === 'camera' ? what : `${what}: ${shown(field, a[field])}, not ${shown(field, b[field])}`;
  }
  return null;
}

const shown = (field: keyof RenderIdentity, value: string | number): string =>
  field === 'document' ? `SHA-256 ${String(value).slice(0, 12)}…` : String(value);
