/** The picture that a noisy film would become (docs/decisions/denoising.md). */
import type { Film } from '../film.ts';
import { Pace } from '../scene/pace.ts';
import { featuresOf } from './features.ts';
import { tameFireflies } from './fireflies.ts';
import { type NlMeansOptions, nlMeans } from './nl-means.ts';
import { type FilmPlanes, filmPlanes, type Planes } from './planes.ts';
import { boxMean, noiseScale, usableVariance } from './statistics.ts';

export interface DenoiseOptions {
  readonly signal?: AbortSignal;
  /** Called with 0 to 1. */
  onProgress?(part: number): void;
}

/** Passes over the radiance: pixels that touch, then wider. */
const STEPS = [1, 3, 9] as const;
const RADIUS = 3;
/** Of the albedo, which has little noise: a window as wide as that of the first pass would smear its pattern. */
const ALBEDO_RADIUS = 2;
/**
 * By measurement (docs/decisions/denoising.md): 0.6 leaves more noise, 1 blurs details; both have the larger error.
 */
const STRENGTH = 0.8;
/** Over what is to be denoised, one after the other. */
export const PASSES = STEPS.map((step) => ({ step, radius: RADIUS, strength: STRENGTH }));
/** What is darker is taken for this: the light on it would be noise, divided by nearly nothing. */
const LEAST_ALBEDO = 0.02;

/** @returns radiance, RGB; the film is left as it is @throws AbortError by the signal */
export async function denoise(
  film: Film,
  { signal, onProgress }: DenoiseOptions = {},
): Promise<Float32Array> {
  const pace = new Pace(signal);
  try {
    const planes = filmPlanes(film);
    const stages = PASSES.length + 1;
    const stage = (i: number): Pick<NlMeansOptions, 'pace' | 'onProgress'> => ({
      pace,
      onProgress: (part) => onProgress?.((i + part) / stages),
    });
    const albedo = await nlMeans(planes.albedo, {
      step: 1,
      radius: ALBEDO_RADIUS,
      strength: 1,
      features: featuresOf(planes, null, film.count),
      ...stage(0),
    });
    const features = featuresOf(planes, albedo, film.count);
    const beyond = backgroundAlbedo(planes);
    const divisor = albedo.channels.map((channel) =>
      channel.map((x, pixel) => Math.max(x, LEAST_ALBEDO) + beyond * (1 - planes.alpha[pixel]!)),
    );
    let light = usableVariance(demodulated(planes.radiance, divisor), film.count);
    const scale = noiseScale(light, features);
    light = tameFireflies(light, features);
    light = { ...light, variance: light.variance.map((x) => x * scale) };
    for (const [i, pass] of PASSES.entries()) {
      light = await nlMeans(
        { ...light, variance: boxMean(light.variance, film, 1) },
        { ...pass, features, ...stage(i + 1) },
      );
    }
    onProgress?.(1);
    return new Float32Array(film.radiance.length).map((_, i) => {
      const [pixel, c] = [Math.floor(i / 3), i % 3];
      // What no surface covers is an image, seen sharply: what is bright in it, such as a sun, is no speck to be spread.
      if (planes.alpha[pixel] === 0 && film.count[pixel]! > 0) return film.radiance[i]! / film.count[pixel]!;
      return light.channels[c]![pixel]! * divisor[c]![pixel]!;
    });
  } finally {
    pace.end();
  }
}

/** What a background would reflect that was a surface among the others: edges before it then have no light of their own. */
function backgroundAlbedo({ radiance, albedo, alpha }: FilmPlanes): number {
  let [light, reflected, behind, open] = [0, 0, 0, 0];
  for (let pixel = 0; pixel < alpha.length; pixel++) {
    const sum = (channels: readonly Float32Array[]) =>
      channels.reduce((total, one) => total + one[pixel]!, 0);
    if (alpha[pixel] === 1) {
      light += sum(radiance.channels);
      reflected += sum(albedo.channels);
    } else if (alpha[pixel] === 0) {
      behind += sum(radiance.channels);
      open += 1;
    }
  }
  const irradiance = light / reflected;
  return open > 0 && irradiance > 0 ? Math.min(1, behind / (3 * open) / irradiance) : 1;
}

/** Light without the pattern of what reflects it. */
function demodulated(radiance: Planes, divisor: readonly Float32Array[]): Planes {
  const scale = divisor[0]!.map((_, pixel) => {
    const mean = divisor.reduce((sum, channel) => sum + channel[pixel]!, 0) / 3;
    return 1 / mean ** 2;
  });
  return {
    ...radiance,
    channels: radiance.channels.map((channel, c) => channel.map((x, pixel) => x / divisor[c]![pixel]!)),
    variance: radiance.variance.map((x, pixel) => x * scale[pixel]!),
  };
}
