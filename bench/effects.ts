/** What presets and effects cost, as ratios: `npm run bench -- effects` prints these alone. */
import { openHarness, type PageHarness } from '../test/support/harness.ts';
import type { EffectsRequest, EffectsResult } from './effects.page.ts';
import { median } from './median.ts';

/** Small and few: the GPU is made of software. */
const REQUEST = { frames: 5, width: 320, height: 180 };

export async function benchEffects(): Promise<void> {
  const harness = await openHarness(new URL('./effects.page.ts', import.meta.url));
  try {
    await printPresets(harness);
    await printEffects(harness);
  } finally {
    await harness.close();
  }
}

const measure = (harness: PageHarness, part: EffectsRequest['part']) =>
  harness.run<EffectsResult>({ ...REQUEST, part } satisfies EffectsRequest);

async function printPresets(harness: PageHarness): Promise<void> {
  const { width, height, frames } = REQUEST;
  const presets = await measure(harness, 'presets');
  console.log(`\nWhole frames of the presets, ${width} x ${height}, medians of ${frames}, ms on WebGPU\n`);
  console.log('| preset | irradia | three.js | ratio | of the plain frame |');
  console.log('| --- | --- | --- | --- | --- |');
  const plain = median(presets.low?.ours ?? []);
  for (const [name, { ours, beside }] of Object.entries(presets)) {
    const [a, b] = [median(ours), median(beside)];
    const cells = [name, a.toFixed(0), b.toFixed(0), (a / b).toFixed(2), (a / plain).toFixed(1)];
    console.log(`| ${cells.join(' | ')} |`);
  }
}

async function printEffects(harness: PageHarness): Promise<void> {
  const effects = await measure(harness, 'effects');
  console.log('\nEach effect alone: its frame over the plain one beside it\n');
  console.log('| effect | ratio |');
  console.log('| --- | --- |');
  for (const [name, { ours, beside }] of Object.entries(effects))
    console.log(`| ${name} | ${(median(ours) / median(beside)).toFixed(2)} |`);
}
