import * as THREE from 'three/webgpu';
import { afterAll, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { testRenderer } from '../../support/gpu.ts';
import { Reader } from './reader.ts';

const size = 32;
const assets = new AssetLoader(nodeAssets);
const { renderer: three } = await testRenderer(size, size);
const renderer = new RealtimeRenderer(three, { samples: 1, precision: 'float' });
afterAll(() => renderer.dispose());

/** A Radiance HDR image whose texels all differ: red along u, green along v, from the top; blue is 1. */
function gradient(width: number, height: number): Uint8Array {
  const head = new TextEncoder().encode(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`);
  const pixels = Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    // Mantissas over 256 times 2^(exponent - 128).
    return [Math.round((255 * x) / width), Math.round((255 * y) / height), 255, 128];
  });
  return Uint8Array.from([...head, ...pixels.flat()]);
}

/** As the kernel reads the map (kernel/sky.glsl). */
function radiance(reader: Reader, [dx, dy, dz]: readonly [number, number, number]): number[] {
  const sky = reader.uint4(2)[2];
  const [width, height, texels] = reader.uint4(sky);
  const [intensity, cos, sin] = reader.float4(sky + 2);
  const [x, z] = [cos * dx - sin * dz, sin * dx + cos * dz];
  const u = (Math.atan2(z, x) / (2 * Math.PI) + 0.5) * width - 0.5;
  const v = (Math.asin(dy) / Math.PI + 0.5) * height - 0.5;
  const texel = (i: number, j: number) =>
    reader.float4(texels + Math.min(Math.max(j, 0), height - 1) * width + ((i + width) % width));
  const [i, j] = [Math.floor(u), Math.floor(v)];
  const [s, t] = [u - i, v - j];
  return [0, 1, 2].map(
    (c) =>
      intensity *
      ((1 - t) * ((1 - s) * texel(i, j)[c]! + s * texel(i + 1, j)[c]!) +
        t * ((1 - s) * texel(i, j + 1)[c]! + s * texel(i + 1, j + 1)[c]!)),
  );
}

test.each([
  ['an HDR file', 0, [0, 0, -1]],
  ['an HDR file', 70, [1, 0.3, 0.5]],
  ['preset', 0, [-1, 0, 0.2]],
  ['preset', -130, [0.4, -0.5, 1]],
] as const)(
  '%s turned by %d degrees: the background towards %j is what the map in memory says',
  async (kind, rotation, target) => {
    const data = Buffer.from(gradient(64, 32)).toString('base64');
    const document = parseDocument(
      {
        format: 'irradia',
        version: 1,
        camera: { fov: 50, position: [0, 0, 0], target },
        assets: { image: { name: 'gradient.hdr', mediaType: 'image/vnd.radiance', data } },
        environment: {
          source: kind === 'preset' ? { type: 'preset', name: 'venice' } : { type: 'hdr', asset: 'image' },
          rotation,
          intensity: 0.5,
        },
        background: { type: 'environment', blur: 0 },
      },
      'sky.json',
    );
    const mirror = new SceneMirror({ assets, onError: expect.fail });
    mirror.apply(document);
    await mirror.settled();
    renderer.render(mirror, document, { width: size, height: size });
    const { pixels } = await renderer.readRadiance();
    mirror.camera.updateMatrixWorld();
    const reader = new Reader(await new ScenePacker(assets).pack(document));
    let [difference, sum] = [0, 0];
    for (let y = 0; y < size; y += 1)
      for (let x = 0; x < size; x += 1) {
        const d = new THREE.Vector3((2 * (x + 0.5)) / size - 1, 1 - (2 * (y + 0.5)) / size, 0.5)
          .unproject(mirror.camera)
          .normalize();
        const expected = radiance(reader, d.toArray());
        for (let c = 0; c < 3; c += 1) {
          const shown = pixels[4 * (y * size + x) + c]!;
          difference += Math.abs(shown - expected[c]!);
          sum += expected[c]!;
        }
      }
    expect(sum).toBeGreaterThan(10);
    // The renderer resamples the map to a cube; an image that is upside down or turned is off by far more.
    expect(difference / sum).toBeLessThan(kind === 'preset' ? 0.08 : 0.02);
    mirror.dispose();
  },
);
