import * as THREE from 'three/webgpu';
import { expect, test } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { parseDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { testRenderer } from '../support/gpu.ts';

/** Materials of one model share their shader; what light from everywhere makes of them is each one's own. */
test('a red, a green and a blue sphere under ambient light are red, green and blue', async () => {
  const colors = { red: [1, 0, 0], green: [0, 1, 0], blue: [0, 0, 1] } as const;
  const names = Object.keys(colors) as (keyof typeof colors)[];
  const document = parseDocument(
    {
      format: 'irradia',
      version: 1,
      camera: { fov: 30, position: [0, 0, 8], target: [0, 0, 0] },
      background: { type: 'color', color: [0, 0, 0] },
      lights: { ambient: { type: 'ambient', luminance: 1 } },
      materials: Object.fromEntries(
        names.map((name) => [name, { name, model: 'lambert', parameters: { albedo: colors[name] } }]),
      ),
      objects: Object.fromEntries(
        names.map((name, i) => [
          name,
          { material: name, position: [(i - 1) * 1.2, 0, 0], geometry: { type: 'sphere' } },
        ]),
      ),
    },
    'spheres.json',
  );
  const size = 64;
  const { renderer } = await testRenderer(size, size);
  const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: expect.fail });
  mirror.apply(document);
  const target = new THREE.RenderTarget(size, size, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(mirror.scene, mirror.camera);
  const row = (await renderer.readRenderTargetPixelsAsync(target, 0, size / 2, size, 1)) as Float32Array;
  for (const [i, name] of names.entries()) {
    const x = size / 2 + (i - 1) * 18;
    // A matte surface in a white furnace has the radiance of its albedo.
    for (const [c, value] of colors[name].entries()) expect(row[4 * x + c]).toBeCloseTo(value, 2);
  }
  mirror.dispose();
});
