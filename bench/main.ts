/** `npm run bench [-- spheres effects lab views tasks]`: prints what docs/benchmarks.md keeps. All on the software GPU of the tests' browser. */
import { parseArgs } from 'node:util';
import { openHarness } from '../test/support/harness.ts';
import { benchEffects } from './effects.ts';
import { measureLab } from './lab.ts';
import { measureLargeMesh } from './large-mesh.ts';
import { measureManyObjects } from './many-objects.ts';
import { median } from './median.ts';
import type { OperationTasks } from './operations.ts';
import type { SpheresRequest, SpheresResult } from './spheres.page.ts';
import { LONG } from './trace.ts';
import { measureViews } from './views.ts';

const { values, positionals: asked } = parseArgs({
  args: process.argv.slice(3),
  allowPositionals: true,
  options: {
    /** Of the tasks: those whose name has this in it. */
    only: { type: 'string', default: '' },
    /** With what the long ones are made of. */
    profile: { type: 'boolean', default: false },
    /** In the scenes whose name has this in it, such as `100,000` or `objects`. */
    scene: { type: 'string', default: '' },
  },
});

const FRAMES = 40;
const NAVIGATIONS = 5;
const DRAG_MS = 3000;

async function benchSpheres(): Promise<void> {
  const harness = await openHarness(new URL('./spheres.page.ts', import.meta.url));
  console.log('20 spheres, 4 lights, 640 x 360: median ms of a frame, the empty scene subtracted\n');
  console.log('| back end | principled | physical | ratio | all lobes: principled | physical | ratio |');
  console.log('| --- | --- | --- | --- | --- | --- | --- |');
  for (const forceWebGL of [false, true]) {
    const request: SpheresRequest = { forceWebGL, frames: FRAMES };
    const { backend, times } = await harness.run<SpheresResult>(request);
    const empty = median(times.empty ?? []);
    const cost = (name: string) => median(times[name] ?? []) - empty;
    const cells = ['', ', all lobes'].flatMap((lobes) => {
      const [ours, theirs] = [cost(`principled${lobes}`), cost(`physical${lobes}`)];
      return [ours.toFixed(1), theirs.toFixed(1), (ours / theirs).toFixed(2)];
    });
    console.log(`| ${[backend, ...cells].join(' | ')} |`);
  }
  await harness.close();
}

async function benchLab(): Promise<void> {
  const results = [];
  for (let i = 0; i < NAVIGATIONS; i++) results.push(await measureLab());
  const [{ scripts, compiledByChange }] = results as [(typeof results)[number]];
  const kilobytes = (named: boolean) =>
    scripts
      .filter(({ isNamedByPage }) => isNamedByPage === named)
      .reduce((sum, { gzipBytes }) => sum + gzipBytes / 1000, 0)
      .toFixed(0);
  const times = results.map(({ readyMs }) => Math.round(readyMs));
  console.log(`\nThe default scene is complete after ${median(times)} ms (of ${times.join(', ')})`);
  console.log(`JavaScript of the page: ${kilobytes(true)} kB gzip`);
  console.log(`Loaders, workers and data that it asked for: ${kilobytes(false)} kB gzip`);
  console.log(`Shaders and pipelines compiled by changes of parameters: ${compiledByChange}`);
}

async function benchViews(): Promise<void> {
  console.log('\nFrames and drawings per second while a slider moves, over those of the viewport alone\n');
  console.log(
    '| views | viewport alone, 1/s | viewport | the slowest of the views | main thread, ms a step |',
  );
  console.log('| --- | --- | --- | --- | --- |');
  for (const { views, plain, viewport, plots, busy } of await measureViews(DRAG_MS)) {
    const ratio = (rate: number) => (rate / plain).toFixed(2);
    const covered = viewport === 0 ? '-' : ratio(viewport);
    const cells = [views.join(', '), plain.toFixed(1), covered, ratio(Math.min(...plots)), busy.toFixed(1)];
    console.log(`| ${cells.join(' | ')} |`);
  }
}

const TRIANGLES = [100_000, 1_000_000];
const OBJECTS = 2000;

async function benchTasks(): Promise<void> {
  const { only, profile: profiled, scene } = values;
  const request = { only, profiled };
  const large = TRIANGLES.map(
    (triangles) => [`${triangles.toLocaleString('en')} triangles`, triangles] as const,
  );
  const asked = large.filter(([name]) => name.includes(scene));
  const measured = [];
  for (const [name, triangles] of asked)
    measured.push({ name, tasks: await measureLargeMesh(triangles, request) });
  if (measured.length > 0) printTasks(measured);
  const name = `${OBJECTS.toLocaleString('en')} objects`;
  if (name.includes(scene)) printTasks([{ name, tasks: await measureManyObjects(OBJECTS, request) }]);
}

function printTasks(columns: readonly { name: string; tasks: readonly OperationTasks[] }[]): void {
  console.log(
    `\nThe longest task of the page's thread, ms of its own time; how many took over ${LONG} ms; the longest on the wall's clock\n`,
  );
  console.log(`| | ${columns.map(({ name }) => `${name} | over ${LONG} | wall`).join(' | ')} |`);
  console.log(`| ---${' | --- | --- | ---'.repeat(columns.length)} |`);
  for (const [i, { name }] of (columns[0]?.tasks ?? []).entries()) {
    const cells = columns.flatMap(({ tasks }) => {
      const { longest = 0, long = 0, wall = 0 } = tasks[i] ?? {};
      return [longest.toFixed(0), long, wall.toFixed(0)];
    });
    console.log(`| ${[name, ...cells].join(' | ')} |`);
  }
  for (const { tasks } of columns)
    for (const { name, made } of tasks) if (made) console.log(`\n${name}: ${made}`);
}

const benches = {
  spheres: benchSpheres,
  effects: benchEffects,
  lab: benchLab,
  views: benchViews,
  tasks: benchTasks,
};
for (const [name, bench] of Object.entries(benches))
  if (asked.length === 0 || asked.includes(name)) await bench();
