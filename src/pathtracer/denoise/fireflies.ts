/**
 * Fireflies: pixels in which one rare sample outshines all others. A filter would make blots of them. What they have
 * too much goes to the pixels about them, as far as those are noisy enough to hide it; the rest is given up, and the
 * picture is darker by that much. The film keeps it all.
 */
import { type Features, featureDistance } from './features.ts';
import { falloff } from './nl-means.ts';
import type { Planes } from './planes.ts';

/** Pixels to each side among which a pixel's brightness should not stand out. */
const REACH = 2;
/** That many of them may be as bright: a pixel is measured by the next one. */
const EXEMPT = 2;
/** So many times as bright as that one it may be. */
const STANDS_OUT = 1.5;
/** A pixel whose standard deviation is a smaller part of it has four samples at least to thank: it stays. */
const KNOWN = 0.5;
/** Standard deviations beyond that which it may give up. A pixel that is one sample's work has its mean as deviation. */
const MOST_DEVIATIONS = 2;
/** Pixels to each side among which the excess is shared. */
const SHARE_REACH = 5;

export function tameFireflies(planes: Planes, features: Features): Planes {
  const { width, height, variance } = planes;
  const [a, b, c] = planes.channels as [Float32Array, Float32Array, Float32Array];
  const brightness = a.map((x, pixel) => x + b[pixel]! + c[pixel]!);
  const channels = planes.channels.map((channel) => channel.slice());
  const tamed = variance.slice();
  for (let pixel = 0; pixel < brightness.length; pixel++) {
    const own = brightness[pixel]!;
    const deviation = Math.sqrt(3 * variance[pixel]!);
    if (deviation === 0) continue;
    const most = MOST_DEVIATIONS * (deviation - KNOWN * own);
    if (most <= 0) continue;
    const excess = Math.min(own - STANDS_OUT * limit(brightness, width, height, pixel), most);
    if (excess <= 0) continue;
    const part = excess / own;
    for (const channel of channels) channel[pixel]! *= 1 - part;
    tamed[pixel]! *= (1 - part) ** 2;
    share(planes, features, pixel, part, channels);
  }
  return { ...planes, channels, variance: tamed };
}

/** The brightness of the next one after the EXEMPT brightest pixels about a pixel. */
function limit(brightness: Float32Array, width: number, height: number, pixel: number): number {
  const x = pixel % width;
  const y = (pixel - x) / width;
  const brightest = new Array<number>(EXEMPT + 1).fill(0);
  for (let v = Math.max(0, y - REACH); v <= Math.min(height - 1, y + REACH); v++) {
    for (let u = Math.max(0, x - REACH); u <= Math.min(width - 1, x + REACH); u++) {
      let value = brightness[v * width + u]!;
      if (u === x && v === y) continue;
      for (let i = 0; i <= EXEMPT && value > 0; i++) {
        const kept = brightest[i]!;
        if (value <= kept) continue;
        brightest[i] = value;
        value = kept;
      }
    }
  }
  return brightest[EXEMPT]!;
}

/** Gives a part of a pixel's radiance to its neighbours, none of them more than its own noise hides. */
function share(
  { width, height, channels: from, variance }: Planes,
  features: Features,
  pixel: number,
  part: number,
  channels: readonly Float32Array[],
): void {
  const x = pixel % width;
  const y = (pixel - x) / width;
  const takers: { pixel: number; weight: number }[] = [];
  let weights = 0;
  for (let v = Math.max(0, y - SHARE_REACH); v <= Math.min(height - 1, y + SHARE_REACH); v++) {
    for (let u = Math.max(0, x - SHARE_REACH); u <= Math.min(width - 1, x + SHARE_REACH); u++) {
      const other = v * width + u;
      const weight = other === pixel ? 0 : falloff(featureDistance(features, pixel, other));
      if (weight === 0) continue;
      takers.push({ pixel: other, weight });
      weights += weight;
    }
  }
  const brightness = from.reduce((sum, channel) => sum + channel[pixel]!, 0);
  for (const { pixel: taker, weight } of takers) {
    const fair = (part * weight) / weights;
    const most = Math.sqrt(3 * variance[taker]!) / brightness;
    const given = Math.min(fair, most);
    for (const [i, channel] of channels.entries()) channel[taker]! += given * from[i]![pixel]!;
  }
}
