/** The picture of a material of the scene, whose textures count by their mean. */

import { SRGBColorSpace, type Texture } from 'three/webgpu';
import type { ParameterValue, Rgb } from '../../../brdf/model.ts';
import { srgbToLinear } from '../../../color/srgb.ts';
import { materialDefaults } from '../../../scene/material-schema.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import { h } from '../../ui/dom.ts';
import { jobOf, type ThumbnailJob } from './thumbnail-job.ts';

/** Null for a material that has gone. */
export function sceneJob(document: Document, mirror: SceneMirror, id: string): ThumbnailJob | null {
  const material = document.materials[id];
  if (!material) return null;
  const job = jobOf(document, material);
  const three = mirror.materialFor(id);
  const parameters: Record<string, ParameterValue> = { ...job.parameters };
  for (const { name, default: usual } of three?.model.parameters ?? []) {
    const map = three?.getMap(name);
    const mean = map && meanOf(map);
    if (!mean) continue;
    const value = parameters[name] ?? usual;
    const channel = material.textures[name]?.channel ?? 'r';
    if (typeof value === 'number') parameters[name] = value * mean['rgba'.indexOf(channel)]!;
    else if (typeof value === 'object')
      parameters[name] = value.map((c, i) => c * mean[i]!) as unknown as Rgb;
  }
  const emission = material.emissiveMap ? materialDefaults.emissive : job.emission;
  return { ...job, parameters, emission: [...emission] };
}

type Rgba = readonly [number, number, number, number];

/** Pixels of a side that an image is shrunk to. */
const SIDE = 8;
const means = new WeakMap<Texture, { readonly version: number; readonly mean: Rgba | null }>();

/** Null for what the page cannot draw, such as a compressed texture. */
function meanOf(map: Texture): Rgba | null {
  const known = means.get(map);
  if (known?.version === map.version) return known.mean;
  const mean = compute(map);
  means.set(map, { version: map.version, mean });
  return mean;
}

function compute({ image, colorSpace }: Texture): Rgba | null {
  const drawable = [ImageBitmap, HTMLImageElement, HTMLCanvasElement].some((kind) => image instanceof kind);
  const context = h('canvas', { width: SIDE, height: SIDE }).getContext('2d', { willReadFrequently: true });
  if (!drawable || !context) return null;
  context.imageSmoothingQuality = 'high';
  context.drawImage(image as CanvasImageSource, 0, 0, SIDE, SIDE);
  const { data } = context.getImageData(0, 0, SIDE, SIDE);
  const sum = [0, 0, 0, 0];
  for (const [i, byte] of data.entries()) {
    const x = byte / 255;
    const isLinear = i % 4 === 3 || colorSpace !== SRGBColorSpace;
    sum[i % 4]! += isLinear ? x : srgbToLinear(x);
  }
  return sum.map((value) => Number((value / SIDE ** 2).toFixed(3))) as unknown as Rgba;
}
