import { expect, it } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { skyDefaults } from '../../../src/scene/environment-schema.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { skyMap } from '../../../src/scene/sky/sky.ts';
import { sunIlluminance } from '../../../src/scene/sky/sun.ts';
import { material, scene } from '../../pathtracer/scenes.ts';
import { trace } from '../../pathtracer/tracer.ts';
import { testRenderer } from '../../support/gpu.ts';
import { irradiance } from './quadrature.ts';

const [WIDTH, HEIGHT] = [32, 24];
const gpu = testRenderer(WIDTH, HEIGHT);

function mirrorOf(): SceneMirror {
  return new SceneMirror({
    assets: new AssetLoader(nodeAssets),
    onError(message) {
      throw new Error(message);
    },
  });
}

/** Mean radiance of the middle of the picture, in both renderers, and the whole of both pictures. */
async function both(document: Document, mirror: SceneMirror, samples: number) {
  mirror.apply(document);
  await mirror.settled();
  const { renderer } = await gpu;
  const realtime = new RealtimeRenderer(renderer, { samples: 1, precision: 'float' });
  realtime.render(mirror, { view: document.view }, { width: WIDTH, height: HEIGHT });
  const { pixels } = await realtime.readRadiance();
  const interactive = new Float32Array(3 * WIDTH * HEIGHT).map(
    (_, i) => pixels[4 * Math.floor(i / 3) + (i % 3)]!,
  );
  const film = await trace(document, { samples, width: WIDTH, height: HEIGHT, maxDepth: 2 });
  return { interactive, traced: film.mean() };
}

function mean(picture: Float32Array, c: number): number {
  let [sum, n] = [0, 0];
  for (let y = HEIGHT / 4; y < (3 * HEIGHT) / 4; y++)
    for (let x = WIDTH / 4; x < (3 * WIDTH) / 4; x++) {
      sum += picture[3 * (y * WIDTH + x) + c]!;
      n++;
    }
  return sum / n;
}

const sky = (azimuth: number, elevation: number) => ({
  ...skyDefaults,
  brightness: -15,
  sun: { type: 'direction' as const, azimuth, elevation },
});

it('white paper in the sun has what quadrature of the sky and the sun says, however it is turned', async () => {
  const mirror = mirrorOf();
  for (const [azimuth, elevation, tilt, rotation] of [
    [140, 50, 0, 0],
    [180, 12, 40, 30],
    [0, -2, 0, 0],
  ] as const) {
    const source = sky(azimuth, elevation);
    const document = scene({
      camera: { fov: 20, position: [0, 4, 0.01], target: [0, 0, 0] },
      background: { type: 'color', color: [0, 0, 0] },
      environment: { source, rotation, samples: 512 },
      // A plane that faces +z, turned to face up and then towards the south.
      objects: {
        paper: {
          name: 'paper',
          material: 'white',
          rotation: [-90 + tilt, 0, 0],
          geometry: { type: 'plane', width: 4, height: 4 },
        },
      },
      materials: { white: material('lambert', { albedo: [1, 1, 1] }) },
    });
    const t = (tilt * Math.PI) / 180;
    // The sky is turned, so turn the paper back: what it faces in the sky's own frame.
    const r = (rotation * Math.PI) / 180;
    const [n0, n1, n2] = [0, Math.cos(t), Math.sin(t)];
    const normal = [Math.cos(r) * n0 - Math.sin(r) * n2, n1, Math.sin(r) * n0 + Math.cos(r) * n2] as const;
    const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
    const sun = [Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)] as const;
    const cosine = Math.max(0, sun[0] * normal[0] + sun[1] * normal[1] + sun[2] * normal[2]);
    const direct = sunIlluminance(source.turbidity, e);
    const expected = irradiance(skyMap(source), normal).map(
      (value, c) => (2 ** -15 * (value + direct[c]! * cosine)) / Math.PI,
    );
    const { interactive, traced } = await both(document, mirror, 64);
    for (const c of [0, 1, 2]) {
      expect(Math.abs(mean(interactive, c) / expected[c]! - 1), 'interactive').toBeLessThan(0.02);
      expect(Math.abs(mean(traced, c) / expected[c]! - 1), 'traced').toBeLessThan(0.02);
    }
  }
});

it('sky and sun behind the scene are in the same place in both renderers, turned and changed', async () => {
  const mirror = mirrorOf();
  // The second one follows the first in the same texture.
  for (const [azimuth, elevation, rotation] of [
    [200, 60, 0],
    [30, 10, 25],
  ] as const) {
    const [a, e] = [((azimuth - rotation) * Math.PI) / 180, (elevation * Math.PI) / 180];
    const towards = [Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)];
    const document = scene({
      camera: { fov: 4, position: [0, 0, 0], target: towards },
      background: { type: 'environment', blur: 0 },
      environment: { source: sky(azimuth, elevation), rotation },
      objects: {},
      materials: {},
    });
    const { interactive, traced } = await both(document, mirror, 16);
    let [sunny, far] = [0, 0];
    for (let i = 0; i < interactive.length; i += 3) {
      const [x, y] = [interactive[i]!, traced[i]!];
      if (y > 100) sunny++;
      if (Math.abs(x - y) > 0.05 * y + 0.01) far++;
    }
    // A disc of 0.533 degrees in a picture of 4 by 5.33: 0.0105 of it, 8 of its pixels; those on its edge may differ.
    expect(sunny).toBeGreaterThan(4);
    expect(far).toBeLessThan(16);
  }
});
