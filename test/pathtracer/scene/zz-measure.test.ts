import { test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { parseDocument } from '../../../src/scene/document.ts';
test('measure', async () => {
  for (const w of [50, 200]) {
    const doc = parseDocument({ format: 'irradia', version: 1, materials: { m: { model: 'principled', emissive: [1,1,1] } }, objects: {o: { material: 'm', geometry: { type: 'torus', radialSegments: w, tubularSegments: w } }} }, 't');
    const packer = new ScenePacker(new AssetLoader(nodeAssets));
    await packer.pack(doc);
    const c0 = process.cpuUsage(); const t = performance.now();
    const s = await packer.pack(doc);
    const c1 = process.cpuUsage(c0);
    console.log(s.lights, 'wall', (performance.now() - t).toFixed(0), 'cpu', ((c1.user + c1.system) / 1000).toFixed(0));
  }
}, 300000);
