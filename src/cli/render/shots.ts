/** The pictures of a call: one, or the frames of a turntable. */
import { existsSync } from 'node:fs';
import { extname } from 'node:path';
import { decodeExr } from '../../io/exr.ts';
import { readPngHeader } from '../../io/png-header.ts';
import type { RenderRecord } from '../../pathtracer/record.ts';
import type { Camera, Document } from '../../scene/schema.ts';
import { readInput } from '../files.ts';
import type { RenderOptions } from './options.ts';
import { difference, fromAttributes } from './record.ts';

export interface Shot {
  readonly path: string;
  readonly camera: Camera;
  /** Where the camera was one frame before, and how many seconds that was; null for a single picture. */
  readonly before: { readonly camera: Camera; readonly seconds: number } | null;
  readonly seed: number;
  /** Before its figures; empty for a single picture. */
  readonly title: string;
}

export function shotsOf({ camera }: Document, { output, seed, animation }: RenderOptions): Shot[] {
  if (animation === null) return [{ path: output, camera, before: null, seed, title: '' }];
  const { frames, degreesPerFrame, fps } = animation;
  return Array.from({ length: frames.to - frames.from }, (_, i) => {
    const frame = frames.from + i;
    const path = framePath(output, frame);
    return {
      path,
      camera: turned(camera, frame * degreesPerFrame),
      before: { camera: turned(camera, (frame - 1) * degreesPerFrame), seconds: 1 / fps },
      // Noise that stands still while the picture moves is seen more than noise that changes.
      seed: (seed + frame) % 2 ** 32,
      title: `${path}: `,
    };
  });
}

/** 'name.0007.png' */
export function framePath(output: string, frame: number): string {
  const ending = extname(output);
  return `${output.slice(0, -ending.length)}.${String(frame).padStart(4, '0')}${ending}`;
}

/** A camera that has gone about the vertical through its target, counter-clockwise as seen from above. */
export function turned(camera: Camera, degrees: number): Camera {
  const { position, target } = camera;
  const angle = (degrees * Math.PI) / 180;
  const [x, z] = [position[0] - target[0], position[2] - target[2]];
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return {
    ...camera,
    position: [target[0] + x * cos + z * sin, position[1], target[2] - x * sin + z * cos],
  };
}

/** Why a frame must be rendered: null if its file is there, whole, and what this call would make. */
export function whyRender(
  path: string,
  wanted: RenderRecord,
  { width, height, aovs }: Pick<RenderOptions, 'width' | 'height' | 'aovs'>,
): string | null {
  if (!existsSync(path)) return 'missing';
  try {
    const found = readPicture(path);
    if (found.width !== width || found.height !== height) return `size: ${found.width}x${found.height}`;
    const lacking = aovs.find((aov) => !found.layers.has(aov));
    if (lacking !== undefined) return `it has no ${lacking}`;
    const record = fromAttributes(found.attributes, path);
    if (record.until !== wanted.until) return `it was rendered for ${record.until}, not ${wanted.until}`;
    if (record.denoised !== wanted.denoised)
      return `it was rendered ${wanted.denoised ? 'without' : 'with'} --denoise`;
    return difference(record, wanted);
  } catch (error) {
    return (error as Error).message;
  }
}

function readPicture(path: string) {
  const file = readInput(path);
  if (extname(path).toLowerCase() === '.png') {
    const { texts, ...size } = readPngHeader(file, path);
    return { ...size, attributes: texts, layers: new Set<string>() };
  }
  const { channels, attributes = {}, width, height } = decodeExr(file, path);
  const layers = new Set(channels.map(({ name }) => name.split('.')[0] ?? ''));
  return { width, height, attributes, layers };
}
