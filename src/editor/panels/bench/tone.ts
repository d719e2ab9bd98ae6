/** From linear values to the pixels of a picture. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import type { Rgb } from '../../../analysis/plots/curve.ts';
import type { Picture } from '../../../analysis/plots/picture.ts';
import { linearToSrgb } from '../../../color/srgb.ts';
import type { Pixels } from './painter.ts';
import type { PaneSettings } from './settings.ts';

type ToneSettings = Pick<PaneSettings, 'tint' | 'brightness' | 'chroma' | 'log'>;

/** A logarithmic picture goes from black to white in so many decades, up to 1. */
const DECADES = 4;

/** sRGB (IEC 61966-2-1), clipped at 1; a single channel is grey. */
export function tonedPixels({ size, pixels, alpha }: Picture, settings: ToneSettings): Pixels {
  const { tint, brightness, chroma, log } = settings;
  const exposure = 2 ** brightness;
  const rgba = new Uint8ClampedArray(4 * size * size);
  // Run for every pixel of every picture while a slider moves: colours make no objects here.
  for (let i = 0; i < size * size; i++) {
    const coverage = alpha ? (alpha[i] as number) : 1;
    if (coverage === 0) continue;
    const r = (pixels[3 * i] as number) / coverage;
    const g = (pixels[3 * i + 1] as number) / coverage;
    const b = (pixels[3 * i + 2] as number) / coverage;
    const gain = chroma ? 1 / Math.max(r, g, b, 1e-9) : exposure;
    const grey = tint === 'rgb' ? null : gain * channelOf([r, g, b], tint);
    for (let c = 0; c < 3; c++) {
      const linear = grey ?? gain * (c === 0 ? r : c === 1 ? g : b);
      rgba[4 * i + c] = log ? encodeLog(linear) : encodeSrgb(linear);
    }
    rgba[4 * i + 3] = 255 * coverage;
  }
  return { width: size, height: size, rgba };
}

const encodeLog = (linear: number) => 255 * (1 + Math.log10(Math.max(linear, 1e-12)) / DECADES);

/** Enough steps that neighbours are less than a quarter of an 8-bit level apart where the curve is steepest. */
const STEPS = 16384;
const SRGB = Float32Array.from({ length: STEPS + 1 }, (_, i) => 255 * linearToSrgb(i / STEPS));

/** 0 to 255; what is not a number is black. */
export function encodeSrgb(value: number): number {
  return SRGB[Math.round(STEPS * Math.max(0, Math.min(1, value)))] ?? 0;
}

/**
 * Where the first picture is brighter, its series' colour, and where the second is, that one's; black where they
 * are the same. A difference of 1 has the full colour at a brightness of 0 EV.
 *
 * @param hues the series' colours, as a browser computes them
 */
export function differencePixels(
  a: Picture,
  b: Picture,
  hues: readonly [string, string],
  { tint, brightness }: ToneSettings,
): Pixels | null {
  if (a.size !== b.size) return null;
  const channel = tint === 'rgb' ? 'luminance' : tint;
  const rgba = new Uint8ClampedArray(4 * a.size * a.size);
  const [ofFirst, ofSecond] = [rgbOf(hues[0]), rgbOf(hues[1])];
  for (let i = 0; i < a.size * a.size; i++) {
    const coverage = a.alpha ? (a.alpha[i] as number) : 1;
    if (coverage === 0) continue;
    const of = ({ pixels }: Picture) =>
      channelOf([0, 1, 2].map((c) => pixels[3 * i + c] as number) as unknown as Rgb, channel);
    const more = (2 ** brightness * (of(a) - of(b))) / coverage;
    const strength = encodeSrgb(Math.abs(more)) / 255;
    const hue = more >= 0 ? ofFirst : ofSecond;
    rgba.set([...hue.map((value) => value * strength), 255 * coverage], 4 * i);
  }
  return { width: a.size, height: a.size, rgba };
}

/** Of `rgb(r, g, b)`, as a browser computes colours. */
export function rgbOf(color: string): readonly number[] {
  return (color.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
}

/** The greatest difference of a channel between two pictures; null if they cannot be compared yet. */
export function greatestDifference(a: Picture, b: Picture): number | null {
  if (a.size !== b.size) return null;
  return a.pixels.reduce((most, value, i) => Math.max(most, Math.abs(value - (b.pixels[i] as number))), 0);
}
