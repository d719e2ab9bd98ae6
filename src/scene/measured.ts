/**
 * Measured BRDFs as models like any other. Here, and nowhere else, it is said which formats there are; this file joins
 * those of io to the lookups of models.
 */
import { compileMeasured } from '../../models/index.ts';
import type { Model } from '../glsl/model.ts';
import { ByteError } from '../io/bytes.ts';
import { PACKED_CSAIL_MAGIC, packCsail, readCsail } from '../io/csail.ts';
import { PACKED_MERL_MAGIC, packMerl, readMerl } from '../io/merl.ts';
import { packRgl, readRgl } from '../io/rgl.ts';
import { TENSOR_MAGIC } from '../io/tensor-file.ts';
import { encodeBase64 } from './base64.ts';
import type { Asset } from './schema.ts';

interface MeasuredFormat {
  /** Whose format it is. */
  readonly origin: string;
  /** How the names of its files end, without the dot. */
  readonly extension: string;
  /** The lookup in models/measured. */
  readonly lookup: string;
  /** What files of it begin with, as far as that tells them apart. */
  readonly magic: Uint8Array;
  readonly mediaType: string;
  /** The triples that the lookup reads, of the file as it was published or as pack() makes it. */
  read(bytes: Uint8Array, fileName: string): Float32Array;
  /** The smaller form that a document keeps. */
  pack(bytes: Uint8Array, fileName: string): Uint8Array;
}

const FORMATS: readonly MeasuredFormat[] = [
  {
    origin: 'MERL',
    extension: 'binary',
    lookup: 'merl',
    magic: PACKED_MERL_MAGIC,
    mediaType: 'application/x-irradia-merl',
    read: readMerl,
    pack: (bytes, fileName) => packMerl(readMerl(bytes, fileName)),
  },
  {
    origin: 'RGL',
    extension: 'bsdf',
    lookup: 'rgl',
    magic: TENSOR_MAGIC,
    mediaType: 'application/x-rgl-bsdf',
    read: readRgl,
    pack: packRgl,
  },
  {
    origin: 'CSAIL, anisotropic',
    extension: 'dat',
    lookup: 'csail',
    magic: PACKED_CSAIL_MAGIC,
    mediaType: 'application/x-irradia-csail',
    read: readCsail,
    pack: (bytes, fileName) => packCsail(readCsail(bytes, fileName)),
  },
];

/** How the names of files of measurements end, without the dot. */
export const measuredExtensions: readonly string[] = FORMATS.map(({ extension }) => extension);

/** All formats in words: '.binary (MERL), ...'. */
export const measuredKinds: string = FORMATS.map(({ extension, origin }) => `.${extension} (${origin})`).join(
  ', ',
);

const extensionOf = (fileName: string) => /\.([A-Za-z0-9]+)$/.exec(fileName)?.[1]?.toLowerCase() ?? '';

/** Whether a file's name says that it holds measurements. */
export const isMeasuredFile = (fileName: string): boolean =>
  measuredExtensions.includes(extensionOf(fileName));

/** By its first bytes; where they say nothing, by its name. */
function formatOf(bytes: Uint8Array, fileName: string): MeasuredFormat {
  const extension = extensionOf(fileName);
  const found =
    FORMATS.find(({ magic }) => magic.every((byte, i) => bytes[i] === byte)) ??
    FORMATS.find((format) => format.extension === extension);
  if (found) return found;
  throw new ByteError(fileName, 0, `no file of measurements that is known here; expected ${measuredKinds}`);
}

/**
 * The model of a file of measurements.
 *
 * @throws ByteError naming the file, the byte and what is wrong there
 */
export function loadMeasured(bytes: Uint8Array, fileName: string): Model {
  const name = fileName.replace(/^.*[/\\]/, '').replace(/\.[A-Za-z0-9]+$/, '') || 'measured';
  const { lookup, read } = formatOf(bytes, fileName);
  return compileMeasured(lookup, read(bytes, fileName), name);
}

/**
 * A file of measurements as a document keeps it, packed.
 *
 * @throws ByteError as loadMeasured()
 */
export function measuredAsset(bytes: Uint8Array, fileName: string): Asset {
  const { mediaType, pack } = formatOf(bytes, fileName);
  const data = encodeBase64(pack(bytes, fileName));
  return { name: fileName.replace(/^.*[/\\]/, '').slice(0, 200), mediaType, data };
}
