import { expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { testRenderer } from '../../support/gpu.ts';
import { randomDocument } from './random-documents.ts';

/** How many documents: as many as a test may take time for. All thousand: IRRADIA_RANDOM_DOCUMENTS=1000. */
const COUNT = Number(process.env.IRRADIA_RANDOM_DOCUMENTS ?? 10);
/** Documents of the same structure: only the first of them compiles. */
const ALIKE = 10;
/** Effects that gather frames have some to gather. */
const FRAMES = 2;
const SIZE = { width: 16, height: 16 };

const { renderer: three } = await testRenderer(SIZE.width, SIZE.height);
// As the page has it: half floats, so that what is too bright is infinite.
const renderer = new RealtimeRenderer(three);

/** What is wrong with the pictures of documents with this structure, and how many show anything. */
async function look(structure: number, count: number): Promise<{ errors: string[]; shown: number }> {
  const errors: string[] = [];
  let shown = 0;
  const mirror = new SceneMirror({
    assets: new AssetLoader(nodeAssets),
    onError: (message) => errors.push(message),
  });
  for (let i = 0; i < count; i++) {
    const document = randomDocument(structure, structure * ALIKE + i);
    mirror.apply(document);
    await mirror.settled();
    renderer.cut();
    for (let frame = 0; frame < FRAMES; frame++) renderer.render(mirror, document, SIZE, 1 / 60);
    const { pixels } = await renderer.readRadiance();
    const wrong = pixels.findIndex((value) => Number.isNaN(value) || value < 0);
    if (wrong >= 0) errors.push(`${document.name}: ${pixels[wrong]} at ${wrong}`);
    if (new Set(pixels).size > 4) shown++;
  }
  mirror.dispose();
  return { errors, shown };
}

test(`${COUNT} random documents have no negative pixel and none that is not a number`, async () => {
  const faults: string[] = [];
  let shown = 0;
  for (let done = 0; done < COUNT; done += ALIKE) {
    const seen = await look(done / ALIKE + 1, Math.min(ALIKE, COUNT - done));
    faults.push(...seen.errors);
    shown += seen.shown;
  }
  expect(faults).toEqual([]);
  // What is black is right, too, but says little.
  expect(shown).toBeGreaterThan(0.4 * COUNT);
}, 3_600_000);
