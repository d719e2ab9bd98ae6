/** Parts of a rendering as one: the mean of what they hold, weighted by their numbers of samples. */
import type { ExrChannel, ExrImage } from '../../io/exr.ts';
import { formatRanges, joined, overlap, rangesLength } from '../../pathtracer/ranges.ts';
import { type RenderRecord, toAttributes } from '../../pathtracer/record.ts';
import { CliError } from '../command.ts';
import { COUNTS, NOISY } from './picture.ts';
import { difference, fromAttributes } from './record.ts';

export interface Part {
  readonly fileName: string;
  readonly image: ExrImage;
  readonly record: RenderRecord;
}

export function partOf(image: ExrImage, fileName: string): Part {
  const record = fromAttributes(image.attributes ?? {}, fileName);
  if (record.renderer !== 'pathtracer')
    throw new CliError(`${fileName}: renderer: ${record.renderer}; only path traced pictures can be merged`);
  return { fileName, image: unfiltered(image), record: { ...record, denoised: false } };
}

/** With its noise, of which samples take away more than a filter can: a mean of denoised pictures keeps their faults. */
function unfiltered(image: ExrImage): ExrImage {
  const noisy = image.channels.filter(({ name }) => name.startsWith(NOISY));
  const names = noisy.map(({ name }) => name.slice(NOISY.length));
  const others = image.channels.filter(
    (channel) => !noisy.includes(channel) && !names.includes(channel.name),
  );
  const radiance = noisy.map((channel, i) => ({ ...channel, name: names[i]! }));
  return { ...image, channels: [...radiance, ...others] };
}

/** @throws CliError naming the file and the field by which it is no part of the same rendering */
export function mergeParts(parts: readonly Part[]): { image: ExrImage; record: RenderRecord } {
  const [one, ...others] = parts as [Part, ...Part[]];
  for (const other of others) checkSame(one, other);
  for (const [i, part] of parts.entries()) {
    for (const earlier of parts.slice(0, i)) checkDisjoint(earlier, part);
  }
  const ranges = joined(parts.flatMap(({ record }) => record.samples));
  const devices = new Set(parts.map(({ record }) => record.device));
  const record = {
    ...one.record,
    samples: ranges,
    until: `samples ${formatRanges(ranges)}`,
    device: [...devices].join('; '),
  };
  const { width, height } = one.image;
  const counts = parts.map((part) => countsOf(part));
  const channels = one.image.channels
    .filter(({ name }) => name !== COUNTS)
    .map(({ name, type }) => ({ name, type, pixels: mergedChannel(name, parts, counts) }));
  if (parts.some(({ image }) => image.channels.some(({ name }) => name === COUNTS)))
    channels.push({ name: COUNTS, type: 'float', pixels: total(counts) });
  return { image: { width, height, channels, attributes: toAttributes(record) }, record };
}

/** How many samples each pixel has. */
function countsOf({ image: { width, height, channels }, record }: Part): Float32Array {
  return (
    channels.find(({ name }) => name === COUNTS)?.pixels ??
    new Float32Array(width * height).fill(rangesLength(record.samples))
  );
}

const total = (counts: readonly Float32Array[]): Float32Array =>
  counts[0]!.map((_, pixel) => counts.reduce((sum, count) => sum + count[pixel]!, 0));

function checkSame(one: Part, other: Part): void {
  const refuse = (field: string): never => {
    throw new CliError(`${other.fileName} is of another rendering than ${one.fileName}: ${field}`);
  };
  const size = ({ image: { width, height } }: Part) => `${width}x${height}`;
  if (size(other) !== size(one)) refuse(`size: ${size(other)}, not ${size(one)}`);
  const field = difference(other.record, one.record);
  if (field !== null) refuse(field);
  const names = ({ image }: Part) =>
    image.channels
      .map(({ name }) => name)
      .filter((name) => name !== COUNTS)
      .sort();
  const missing = names(one).find((name) => !names(other).includes(name));
  if (missing !== undefined) refuse(`channels: it has no ${missing}`);
  const extra = names(other).find((name) => !names(one).includes(name));
  if (extra !== undefined) refuse(`channels: only it has ${extra}`);
}

function checkDisjoint(a: Part, b: Part): void {
  const common = overlap(a.record.samples, b.record.samples);
  if (common !== null)
    throw new CliError(`${a.fileName} and ${b.fileName} both have the samples ${formatRanges([common])}`);
}

function mergedChannel(name: string, parts: readonly Part[], counts: readonly Float32Array[]): Float32Array {
  const of = (channel: string) => parts.map(({ image }) => pixelsOf(image.channels, channel));
  if (name.startsWith('variance.'))
    return mergedVariance(of(name), of(name.slice('variance.'.length)), counts);
  // Depth is the mean over the samples that hit something.
  if (name === 'depth.Z') {
    const hits = of('depth.A');
    return mean(of(name), (part, pixel) => counts[part]![pixel]! * hits[part]![pixel]!);
  }
  return mean(of(name), (part, pixel) => counts[part]![pixel]!);
}

function pixelsOf(channels: readonly ExrChannel[], name: string): Float32Array {
  const found = channels.find((channel) => channel.name === name);
  if (!found) throw new CliError(`there is no channel ${name}, which merging needs`);
  return found.pixels;
}

function mean(
  values: readonly Float32Array[],
  weightOf: (part: number, pixel: number) => number,
): Float32Array {
  return new Float32Array(values[0]!.length).map((_, pixel) => {
    let [sum, weights] = [0, 0];
    for (let part = 0; part < values.length; part++) {
      const weight = weightOf(part, pixel);
      sum += weight * values[part]![pixel]!;
      weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
  });
}

/**
 * The variance of the mean of all samples, from each part's. T. F. Chan, G. H. Golub and R. J. LeVeque, 1983,
 * "Algorithms for Computing the Sample Variance", eq. (2.1).
 */
function mergedVariance(
  variances: readonly Float32Array[],
  means: readonly Float32Array[],
  counts: readonly Float32Array[],
): Float32Array {
  return new Float32Array(variances[0]!.length).map((_, pixel) => {
    const own = counts.map((count) => count[pixel]!);
    const n = own.reduce((sum, count) => sum + count, 0);
    const whole = own.reduce((sum, count, part) => sum + count * means[part]![pixel]!, 0) / n;
    // Sum of squared distances from the mean of all.
    const squares = own.reduce((sum, count, part) => {
      const within = count * (count - 1) * variances[part]![pixel]!;
      return sum + within + count * (means[part]![pixel]! - whole) ** 2;
    }, 0);
    return n > 1 ? squares / (n * (n - 1)) : 0;
  });
}
