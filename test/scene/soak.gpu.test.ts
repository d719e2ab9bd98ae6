/**
 * The picture after a day of commands, all of them undone, is the picture before them, to the bit. Presets of effects are
 * not among them: those of `high` and `ultra` have noise that is another in each frame.
 */
import { expect, test } from 'vitest';
import { createRandom } from '../../src/analysis/random.ts';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { parseDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { removeEntities } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { testRenderer } from '../support/gpu.ts';
import { act, commandsOfScene } from './every-command.ts';

const SIZE = { width: 48, height: 27 };
/** How many: as many as a test may take time for. All thousand: IRRADIA_SOAK=1000, in some minutes. */
const COMMANDS = Number(process.env.IRRADIA_SOAK ?? 60);
/** The store keeps 500 steps; within a round none is forgotten. */
const ROUND = 250;
/** Where the picture is drawn on the way, so that there is something to be cleared away. */
const LOOK_EVERY = 30;
/** The compiler of the software GPU gives up on some twenty lamps of all kinds in one shader; then some go. */
const MOST_LIGHTS = 8;

const scene = parseDocument(
  {
    format: 'irradia',
    version: 1,
    camera: { fov: 40, position: [0, 1.5, 6], target: [0, 0.4, 0] },
    lights: {
      ambient: { type: 'ambient', luminance: 0.2 },
      key: { type: 'point', position: [2, 3, 3], intensity: 30 },
    },
    materials: {
      matte: { name: 'Matte', model: 'lambert' },
      glossy: { name: 'Glossy', model: 'principled', parameters: { roughness: 0.4 } },
    },
    objects: {
      floor: { material: 'matte', rotation: [-90, 0, 0], scale: [8, 8, 1], geometry: { type: 'plane' } },
      ball: { material: 'glossy', position: [-1, 0.5, 0], geometry: { type: 'sphere' } },
      box: { material: 'matte', position: [1, 0.5, 0], geometry: { type: 'box' } },
    },
  },
  'soak.json',
);

test('the picture before and after is the same', async () => {
  const random = createRandom(7);
  const below = (n: number) => Math.floor(random() * n);
  const { renderer: three } = await testRenderer(SIZE.width, SIZE.height);
  const renderer = new RealtimeRenderer(three);
  // A map without a picture in it is said to be missing; that is not what is tested.
  const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: () => undefined });
  const store = new DocumentStore(scene);
  const picture = async () => {
    mirror.apply(store.document);
    await mirror.settled();
    renderer.cut();
    renderer.render(mirror, store.document, SIZE);
    return (await renderer.readRadiance()).pixels;
  };

  const before = await picture();
  expect(new Set(before).size).toBeGreaterThan(100);
  for (let done = 0; done < COMMANDS; done += ROUND) {
    const seen: { index: number; pixels: Float32Array }[] = [];
    for (let i = 1; i <= Math.min(ROUND, COMMANDS - done); i += 1) {
      const lights = Object.keys(store.document.lights);
      if (lights.length > MOST_LIGHTS)
        removeEntities(
          store,
          lights.slice(0, MOST_LIGHTS / 2).map((id) => ({ kind: 'lights', id })),
        );
      act(store, commandsOfScene[below(commandsOfScene.length)], [
        below(1e6),
        below(1e6),
        below(1e6),
        below(1e6),
      ]);
      mirror.apply(store.document);
      if (i % LOOK_EVERY === 0) seen.push({ index: store.historyIndex, pixels: await picture() });
    }
    while (store.canUndo) {
      store.undo();
      mirror.apply(store.document);
    }
    expect(await picture()).toEqual(before);
    for (const { index, pixels } of seen) {
      store.goTo(index);
      expect(await picture()).toEqual(pixels);
    }
    store.goTo(0);
    store.open(scene);
  }
  mirror.dispose();
}, 1_200_000);
