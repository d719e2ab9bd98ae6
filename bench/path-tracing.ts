/** `npm run bench:paths`: prints what docs/performance.md keeps of path tracing. */

import { nodeAssets } from '../src/cli/node-assets.ts';
import { createCpuPathTracer } from '../src/cli/path-tracer.ts';
import { ScenePacker } from '../src/pathtracer/scene/pack.ts';
import { AssetLoader } from '../src/scene/assets.ts';
import { openHarness } from '../test/support/harness.ts';
import type { PathTracingFigures, PathTracingRequest, PathTracingResult } from './path-tracing.page.ts';
import { cornellBox, suzanneOutdoors } from './path-tracing-scenes.ts';

const DEPTH = 6;
const SIDE = 64;
/** The error at which renderings are compared. */
const GOAL = 1e-2;

const harness = await openHarness(new URL('./path-tracing.page.ts', import.meta.url));
console.log('| scene | who | paths/s | relative MSE of 1 sample a pixel | time to 1e-2 at 64 x 64 |');
console.log('| --- | --- | --- | --- | --- |');
for (const [scene, document] of [
  ['cornell', cornellBox()],
  ['suzanne', suzanneOutdoors()],
] as const) {
  const request: PathTracingRequest = { scene, side: SIDE, depth: DEPTH, samples: { ours: 256, theirs: 4 } };
  const { ours, theirs } = await harness.run<PathTracingResult>(request);
  const tracer = createCpuPathTracer();
  await tracer.load(await new ScenePacker(new AssetLoader(nodeAssets)).pack(document));
  let time = 0;
  for (const seed of [0, 1, 2]) {
    tracer.start(document.camera, {
      width: SIDE,
      height: SIDE,
      maxDepth: DEPTH,
      seed,
      strategy: 'mis',
      clamp: 0,
    });
    const began = performance.now();
    await tracer.render(0, request.samples.ours);
    if (seed > 0) time += performance.now() - began;
  }
  tracer.dispose();
  const node = { ...ours, paths: (2 * request.samples.ours * SIDE * SIDE) / (time / 1000) };
  row(scene, `Irradia, page, ${ours.device}`, ours);
  row(scene, `Irradia, Node, ${ours.device}`, node);
  row(scene, `three-gpu-pathtracer, page, ${theirs.device}`, theirs);
}
await harness.close();

function row(scene: string, who: string, { paths, error }: PathTracingFigures): void {
  const time = ((error / GOAL) * SIDE * SIDE) / paths;
  console.log(`| ${scene} | ${who} | ${Math.round(paths)} | ${error.toFixed(2)} | ${time.toFixed(2)} s |`);
}
