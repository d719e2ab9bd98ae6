/** A film as a file. */
import { displayPixels } from '../../color/tone-mapping.ts';
import { type ExrChannel, type ExrImage, encodeExr } from '../../io/exr.ts';
import { encodePng } from '../../io/png.ts';
import type { Film } from '../../pathtracer/film.ts';
import { type RenderRecord, toAttributes } from '../../pathtracer/record.ts';
import type { Aov } from './options.ts';

/** Names of the components of layers; 'depth.A' is the part of the samples that hit something, which merging needs. */
const COMPONENTS: Readonly<Record<Aov, readonly string[]>> = {
  albedo: ['R', 'G', 'B'],
  normal: ['X', 'Y', 'Z'],
  depth: ['Z', 'A'],
  variance: ['R', 'G', 'B'],
};

/** The channel of the numbers of samples, where pixels have different ones. */
export const COUNTS = 'samples';
/** The layer of the radiance before it was denoised. */
export const NOISY = 'noisy.';
const RGB = ['R', 'G', 'B'];

/**
 * @param denoised instead of the film's own radiance and alpha, which are then in a layer
 * @param transparent whether there is an alpha channel, by which colours are multiplied as files of this kind have it
 */
export function filmToExr(
  film: Film,
  record: RenderRecord,
  aovs: readonly Aov[],
  denoised: { readonly radiance: Float32Array; readonly alpha: Float32Array } | null = null,
  transparent = false,
): Uint8Array {
  const channels = [
    ...layer('', RGB, denoised?.radiance ?? film.mean()),
    ...(transparent ? layer('', ['A'], denoised?.alpha ?? film.meanAlpha()) : []),
    ...(denoised === null ? [] : layer(NOISY, RGB, film.mean())),
    ...(denoised === null || !transparent ? [] : layer(NOISY, ['A'], film.meanAlpha())),
    ...(film.count.every((n) => n === film.count[0])
      ? []
      : [{ name: COUNTS, type: 'float' as const, pixels: Float32Array.from(film.count) }]),
    ...aovs.flatMap((aov) => layer(`${aov}.`, COMPONENTS[aov], aovPixels(film, aov))),
  ];
  const { width, height } = film;
  return encodeExr({ width, height, channels, attributes: toAttributes(record) });
}

/** Values of a layer, all components of a pixel together. */
function aovPixels(film: Film, aov: Aov): Float32Array {
  if (aov === 'albedo') return film.meanAlbedo();
  if (aov === 'normal') return film.meanNormal();
  if (aov === 'variance') return film.variance();
  const depth = film.meanDepth();
  return new Float32Array(2 * depth.length).map((_, i) => {
    const pixel = i >> 1;
    return i % 2 === 0 ? depth[pixel]! : film.alpha[pixel]! / film.count[pixel]!;
  });
}

function layer(prefix: string, components: readonly string[], values: Float32Array): ExrChannel[] {
  const stride = components.length;
  return components.map((component, c) => ({
    name: prefix + component,
    type: 'float',
    pixels: new Float32Array(values.length / stride).map((_, pixel) => values[stride * pixel + c]!),
  }));
}

/** As the lab shows it. @param radiance RGB @param alpha by which that is multiplied; left out, all is opaque */
export function radianceToPng(
  radiance: Float32Array,
  { width, height }: Pick<ExrImage, 'width' | 'height'>,
  record: RenderRecord,
  falseColor = false,
  alpha?: Float32Array,
): Uint8Array {
  const pixels = displayPixels(radiance, { ...record, falseColor }, alpha);
  return encodePng(pixels, width, height, toAttributes(record));
}
