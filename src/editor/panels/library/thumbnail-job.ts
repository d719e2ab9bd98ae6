/** What the worker of small pictures is asked for, and what comes back. */
import type { PatternUse } from '../../../analysis/library/pattern-sampler.ts';
import { THUMBNAIL_VERSION } from '../../../analysis/library/thumbnail.ts';
import type { ParameterValue, Rgb } from '../../../brdf/model.ts';
import type { Model } from '../../../glsl/model.ts';
import { findModel, modelOrigin } from '../../../scene/models.ts';
import { isPattern } from '../../../scene/pattern/asset.ts';
import type { Document, Material } from '../../../scene/schema.ts';
import { ownModel } from '../bench/series.ts';
import type { OwnModel } from '../bench/settings.ts';

export interface ThumbnailJob {
  readonly model: string;
  /** Null for a model that ships. */
  readonly source: OwnModel | null;
  readonly parameters: Readonly<Record<string, ParameterValue>>;
  readonly multipleScattering: boolean;
  readonly emission: Rgb;
  readonly patterns: readonly PatternUse[];
}

export interface ThumbnailRequest {
  readonly job: ThumbnailJob;
  readonly size: number;
}

export type ThumbnailAnswer =
  | { readonly pixels: Uint8ClampedArray<ArrayBuffer> }
  | { readonly message: string };

/** A material's own light against the studio's, in nits: what is a thousand times as bright is white all the same. */
const STUDIO_NITS = 1;

/** Of a document's material, or of another material with what it needs. */
export function jobOf(
  document: Pick<Document, 'models' | 'assets'>,
  material: Pick<Material, 'model' | 'parameters' | 'multipleScattering'> & Partial<Material>,
): ThumbnailJob {
  const { model, parameters, multipleScattering, emissive = [0, 0, 0], emissiveIntensity = 0 } = material;
  const emission = emissive.map((c) => (c * emissiveIntensity) / STUDIO_NITS) as unknown as Rgb;
  return {
    model,
    source: ownModel(document as Document, model),
    parameters,
    multipleScattering,
    emission,
    patterns: patternsOf(document, material),
  };
}

function patternsOf(
  { assets }: Pick<Document, 'assets'>,
  { textures = {}, normalMap }: Partial<Material>,
): PatternUse[] {
  const refs = [...Object.entries(textures), ...(normalMap ? [['normalMap', normalMap] as const] : [])];
  return refs.flatMap(([place, ref]) => {
    const asset = assets[ref.asset];
    if (!asset || !isPattern(asset)) return [];
    const { texture, channel, repeat, offset, rotation } = ref;
    const scale = 'scale' in ref ? Number(ref.scale) : 1;
    return [{ place, data: asset.data, ref: { texture, channel, repeat, offset, rotation }, scale }];
  });
}

const NONE = { models: {}, assets: {} };
const modelKeys = new WeakMap<object, string>();

/** The same for what looks the same, here and in another session; null where the model is broken or gone. */
export function keyOf({ model: name, source, ...look }: ThumbnailJob, size: number): string | null {
  const document = source ?? NONE;
  const origin = modelOrigin(document as Document, name);
  let model: Model | undefined;
  try {
    model = findModel(document, name);
  } catch {
    return null;
  }
  if (!model) return null;
  const of = origin ?? model;
  const known = modelKeys.get(of) ?? hash(origin && 'data' in origin ? origin.data : textOf(model));
  modelKeys.set(of, known);
  const { parameters, multipleScattering, emission, patterns } = look;
  const values = Object.entries(parameters).sort(([a], [b]) => (a < b ? -1 : 1));
  return `${THUMBNAIL_VERSION} ${size} ${known} ${JSON.stringify([values, multipleScattering, emission, ...patterns])}`;
}

const textOf = ({ file }: Model): string =>
  [...file.shader.lines, ...(file.sampling?.lines ?? [])].map(({ text }) => text).join('\n');

/** 53 bits, which no two models of a library share by chance (bryc, 2018, "cyrb53"). */
function hash(text: string): string {
  let [a, b] = [0xdeadbeef, 0x41c6ce57];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    a = Math.imul(a ^ code, 2654435761);
    b = Math.imul(b ^ code, 1597334677);
  }
  a = Math.imul(a ^ (a >>> 16), 2246822507) ^ Math.imul(b ^ (b >>> 13), 3266489909);
  b = Math.imul(b ^ (b >>> 16), 2246822507) ^ Math.imul(a ^ (a >>> 13), 3266489909);
  return (4294967296 * (2097151 & b) + (a >>> 0)).toString(36);
}
