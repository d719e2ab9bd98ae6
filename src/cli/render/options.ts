/** The options of `render`, checked. */
import { totalmem } from 'node:os';
import { extname } from 'node:path';
import { parseRange, RANGE_LIMIT, type Range } from '../../pathtracer/ranges.ts';
import { type PresetName, presetNames } from '../../scene/effect-presets.ts';
import type { PathTracing } from '../../scene/schema.ts';
import { type Call, type Command, UsageError } from '../command.ts';
import type { DeviceChoice } from '../gpu.ts';
import type { Until } from './passes.ts';

export const DEFAULTS = {
  size: '1280x720',
  /** Of --error: a tile that cannot become good enough must end some time. */
  mostSamples: 16_384,
  fps: 24,
  turntable: 36,
} as const;

/** What an EXR can hold besides the radiance. */
export const AOVS = ['albedo', 'normal', 'depth', 'variance'] as const;
export type Aov = (typeof AOVS)[number];

export const RENDERERS = ['pathtracer', 'realtime'] as const;
const DEVICES: readonly DeviceChoice[] = ['auto', 'gpu', 'software'];

export const renderOptions: Command['options'] = {
  output: { type: 'string', short: 'o' },
  renderer: { type: 'string', default: 'pathtracer' },
  size: { type: 'string', default: DEFAULTS.size },
  device: { type: 'string', default: 'auto' },
  preset: { type: 'string' },
  spp: { type: 'string' },
  time: { type: 'string' },
  error: { type: 'string' },
  samples: { type: 'string' },
  'max-depth': { type: 'string' },
  seed: { type: 'string' },
  clamp: { type: 'string' },
  denoise: { type: 'boolean' },
  aov: { type: 'string' },
  frames: { type: 'string' },
  fps: { type: 'string' },
  turntable: { type: 'string' },
};

export interface RenderOptions {
  readonly output: string;
  readonly format: 'png' | 'exr';
  readonly renderer: (typeof RENDERERS)[number];
  readonly width: number;
  readonly height: number;
  readonly device: DeviceChoice;
  readonly until: Until;
  /** Number of the first sample. */
  readonly first: number;
  readonly maxDepth: number;
  readonly seed: number;
  readonly clamp: number;
  readonly denoise: boolean;
  readonly aovs: readonly Aov[];
  readonly animation: Animation | null;
  /** Of the effects; null leaves the document's. */
  readonly preset: PresetName | null;
}

/** What a call says: null where the document is to say it. */
export interface RenderRequest extends Omit<RenderOptions, Settings | 'until'> {
  readonly until: Until | null;
  readonly maxDepth: number | null;
  readonly seed: number | null;
  readonly clamp: number | null;
}

type Settings = 'maxDepth' | 'seed' | 'clamp';

/** With the document's own settings where the call has none. */
export function completed(request: RenderRequest, settings: PathTracing): RenderOptions {
  return {
    ...request,
    until: request.until ?? { kind: 'samples', count: settings.samples },
    maxDepth: request.maxDepth ?? settings.maxDepth,
    seed: request.seed ?? settings.seed,
    clamp: request.clamp ?? settings.clamp,
  };
}

export interface Animation {
  readonly frames: Range;
  /** Degrees that the camera goes about its target from one frame to the next. */
  readonly degreesPerFrame: number;
  /** Frames per second. */
  readonly fps: number;
}

type Words = Readonly<Record<string, string | undefined>>;

export function parseRenderOptions(options: Call['options']): RenderRequest {
  const words = options as Words;
  const { output, renderer = '', device = '' } = words;
  if (!output) throw new UsageError('render: expected -o FILE.png or -o FILE.exr');
  const format = extname(output).slice(1).toLowerCase();
  if (format !== 'png' && format !== 'exr') throw new UsageError(`-o ${output}: expected a .png or an .exr`);
  if (!isOneOf(RENDERERS, renderer))
    throw new UsageError(`--renderer ${renderer}: expected ${RENDERERS.join(' or ')}`);
  if (!isOneOf(DEVICES, device)) throw new UsageError(`--device ${device}: expected ${DEVICES.join(', ')}`);
  if (renderer === 'pathtracer') refuse(words, ['preset'], '--renderer realtime');
  if (renderer === 'realtime') refuse(words, PATH_TRACER_ONLY, '--renderer pathtracer');
  if (words.frames === undefined) refuse(words, ['fps', 'turntable'], '--frames A:B');
  return {
    output,
    format,
    renderer,
    ...parseSize(words.size ?? DEFAULTS.size),
    device,
    ...parseUntil(words),
    maxDepth: integer(words, 'max-depth', [1, 1024]) ?? null,
    seed: integer(words, 'seed', [0, 2 ** 32 - 1]) ?? null,
    clamp: number(words, 'clamp', 'a radiance, 0 or more', (x) => x >= 0) ?? null,
    denoise: options.denoise === true,
    aovs: parseAovs(words.aov, format),
    animation: parseAnimation(words),
    preset: parsePreset(words.preset),
  };
}

const PATH_TRACER_ONLY = ['spp', 'time', 'error', 'samples', 'max-depth', 'seed', 'clamp', 'denoise', 'aov'];

function refuse(words: Words, names: readonly string[], unless: string): void {
  for (const name of names) {
    if (words[name] !== undefined) throw new UsageError(`--${name}: only with ${unless}`);
  }
}

const isOneOf = <T extends string>(choices: readonly T[], word: string): word is T =>
  (choices as readonly string[]).includes(word);

function number(words: Words, name: string, expected: string, isRight: (x: number) => boolean) {
  const word = words[name];
  if (word === undefined) return undefined;
  const value = word.trim() === '' ? Number.NaN : Number(word);
  if (!Number.isFinite(value) || !isRight(value))
    throw new UsageError(`--${name} ${word}: expected ${expected}`);
  return value;
}

const integer = (words: Words, name: string, [least, most]: readonly [number, number]) =>
  number(words, name, `${least} to ${most}`, (x) => Number.isInteger(x) && x >= least && x <= most);

function parseSize(text: string): { width: number; height: number } {
  const [, width, height] = /^(\d{1,5})x(\d{1,5})$/i.exec(text)?.map(Number) ?? [];
  if (!width || !height)
    throw new UsageError(`--size ${text}: expected WIDTHxHEIGHT, such as ${DEFAULTS.size}`);
  return { width, height };
}

/** Bytes of a pixel in a Film: 7 float64 and 9 float32 numbers; and about as many while it is written. */
const FILM_BYTES_PER_PIXEL = 2 * (7 * 8 + 9 * 4);

/** Refuses a film that this machine's memory does not hold. */
export function checkFilmSize({ width, height }: Pick<RenderOptions, 'width' | 'height'>): void {
  const [bytes, most] = [width * height * FILM_BYTES_PER_PIXEL, totalmem() / 2];
  const gigabytes = (n: number) => `${(n / 2 ** 30).toFixed(1)} GB`;
  if (bytes > most)
    throw new UsageError(
      `--size ${width}x${height}: takes ${gigabytes(bytes)} of memory; at most ${gigabytes(most)} here`,
    );
}

function parseUntil(words: Words): Pick<RenderRequest, 'until' | 'first'> {
  const given = (['spp', 'time', 'error', 'samples'] as const).filter(
    // With --error it is the most that any pixel gets.
    (name) => words[name] !== undefined && !(name === 'spp' && words.error !== undefined),
  );
  if (given.length > 1)
    throw new UsageError(`${given.map((name) => `--${name}`).join(' and ')}: expected one of them`);
  if (words.samples !== undefined) {
    const range = parseRange(words.samples);
    if (range === null)
      throw new UsageError(`--samples ${words.samples}: expected A:B with A < B, such as 0:64`);
    return { first: range.from, until: { kind: 'samples', count: range.to - range.from } };
  }
  const seconds = number(words, 'time', 'seconds, more than 0', (x) => x > 0);
  if (seconds !== undefined) return { first: 0, until: { kind: 'time', seconds } };
  const error = number(words, 'error', 'a number above 0, such as 0.02', (x) => x > 0);
  const spp = integer(words, 'spp', [1, RANGE_LIMIT]);
  if (error !== undefined)
    return { first: 0, until: { kind: 'error', error, most: spp ?? DEFAULTS.mostSamples } };
  return { first: 0, until: spp === undefined ? null : { kind: 'samples', count: spp } };
}

function parseAovs(text: string | undefined, format: 'png' | 'exr'): Aov[] {
  if (text === undefined) return [];
  if (format === 'png') throw new UsageError(`--aov ${text}: a .png has no layers; expected -o FILE.exr`);
  const names = text.split(',');
  const wrong = names.find((name) => !isOneOf(AOVS, name));
  if (wrong !== undefined) throw new UsageError(`--aov ${text}: expected some of ${AOVS.join(',')}`);
  return AOVS.filter((aov) => names.includes(aov));
}

function parsePreset(word: string | undefined): PresetName | null {
  if (word === undefined) return null;
  if (!isOneOf(presetNames, word))
    throw new UsageError(`--preset ${word}: expected ${presetNames.join(', ')}`);
  return word;
}

function parseAnimation(words: Words): Animation | null {
  if (words.frames === undefined) return null;
  const frames = parseRange(words.frames);
  if (frames === null)
    throw new UsageError(`--frames ${words.frames}: expected A:B with A < B, such as 0:240`);
  const fps = number(words, 'fps', 'frames per second, more than 0', (x) => x > 0) ?? DEFAULTS.fps;
  const degrees = number(words, 'turntable', 'degrees per second', () => true) ?? DEFAULTS.turntable;
  return { frames, degreesPerFrame: degrees / fps, fps };
}
