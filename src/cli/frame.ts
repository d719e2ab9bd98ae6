import { type ExrImage, encodeExr } from '../io/exr.ts';
import { encodePng } from '../io/png.ts';
import { type Radiance, RealtimeRenderer, type Size } from '../realtime/renderer.ts';
import { AssetLoader } from '../scene/assets.ts';
import { SceneMirror } from '../scene/mirror.ts';
import type { Camera, Document } from '../scene/schema.ts';
import { CliError } from './command.ts';
import type { DeviceChoice } from './gpu.ts';
import { nodeAssets } from './node-assets.ts';
import { createNodeRenderer } from './node-renderer.ts';
import type { Shot } from './render/shots.ts';

export interface FrameOptions extends Size {
  readonly format: 'png' | 'exr';
  readonly device: DeviceChoice;
}

export interface Frames {
  /** What draws, for a person to read. */
  readonly device: string;
  /** @returns a file. @param attributes of its header, given the exposure in EV */
  draw(
    shot: Pick<Shot, 'camera' | 'before'>,
    attributes: (exposure: number) => Readonly<Record<string, string | number>>,
  ): Promise<Uint8Array>;
  dispose(): void;
}

/** A document, ready to be drawn by the interactive renderer from any camera. */
export async function openFrames(document: Document, options: FrameOptions): Promise<Frames> {
  const { width, height, format } = options;
  const node = await createNodeRenderer(options);
  const largest = node.gpu.device.limits.maxTextureDimension2D;
  const scale = format === 'exr' ? SUPERSAMPLING : 1;
  if (Math.max(width, height) * scale > largest) {
    throw new CliError(
      `--size ${width}x${height}: at most ${Math.floor(largest / scale)} pixels a side for ${format}`,
    );
  }
  const mirror = await mirrorOf(document);
  const settings = format === 'exr' ? ({ samples: 1, precision: 'float' } as const) : {};
  const renderer = new RealtimeRenderer(node.renderer, settings);
  const view = { ...document.view, resolutionScale: scale };
  const shown = { ...document, view };
  await renderer.compile(mirror, shown, options);
  return {
    device: node.gpu.adapter.info.description,
    async draw({ camera, before }, attributesFor) {
      const settings = { ...shown, camera };
      const show = (from: Camera) => mirror.apply({ ...document, camera: from });
      // Each picture is one of its own, and is taken when it has become as good as it will.
      renderer.cut();
      show(camera);
      let frames = 0;
      do renderer.render(mirror, settings, options);
      while (renderer.unsettled && ++frames < MOST_FRAMES);
      if (before !== null && document.effects.motionBlur.enabled) {
        // What moves is the camera: once more, as it comes from where it was.
        show(before.camera);
        renderer.render(mirror, { ...shown, camera: before.camera }, options, before.seconds);
        show(camera);
        renderer.render(mirror, settings, options, before.seconds);
      }
      await renderer.settleExposure(view);
      const attributes = attributesFor(renderer.exposure(view));
      if (format === 'png') return encodePng(await renderer.readImage(view), width, height, attributes);
      const names = document.background.type === 'transparent' ? 'RGBA' : 'RGB';
      return encodeExr({ ...exrImage(await renderer.readRadiance(), names), attributes });
    },
    dispose() {
      mirror.dispose();
      node.dispose();
    },
  };
}

/** Frames that a picture gathers at most. */
const MOST_FRAMES = 64;

/** Samples per pixel along each side for floats, which GPUs do not multisample. */
const SUPERSAMPLING = 2;

async function mirrorOf(document: Document): Promise<SceneMirror> {
  const faults: string[] = [];
  const mirror = new SceneMirror({
    assets: new AssetLoader(nodeAssets),
    onError: (message) => faults.push(message),
  });
  mirror.apply(document);
  await mirror.settled();
  if (faults.length) throw new CliError(faults.join('\nirradia: '));
  return mirror;
}

/** @param names of the channels; colours are multiplied by alpha, as files of this kind have it */
function exrImage(radiance: Radiance, names: string): ExrImage {
  const width = radiance.width / SUPERSAMPLING;
  const height = radiance.height / SUPERSAMPLING;
  const channels = [...names].map((name, channel) => ({
    name,
    type: 'float' as const,
    pixels: averaged(radiance, channel, width, height),
  }));
  return { width, height, channels };
}

/** One channel, each pixel the mean of its samples. */
function averaged(
  { pixels, width: stride }: Radiance,
  channel: number,
  width: number,
  height: number,
): Float32Array {
  const out = new Float32Array(width * height);
  for (let y = 0; y < height * SUPERSAMPLING; y++) {
    for (let x = 0; x < width * SUPERSAMPLING; x++) {
      const at = Math.floor(y / SUPERSAMPLING) * width + Math.floor(x / SUPERSAMPLING);
      out[at]! += pixels[(y * stride + x) * 4 + channel]! / SUPERSAMPLING ** 2;
    }
  }
  return out;
}
