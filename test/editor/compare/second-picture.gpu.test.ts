import { afterAll, describe, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { SecondPicture } from '../../../src/editor/compare/second-picture.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { addLight, addObject } from '../../../src/scene/commands.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { materialDefaults } from '../../../src/scene/material-schema.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { DocumentStore } from '../../../src/scene/store.ts';
import { testRenderer } from '../../support/gpu.ts';

const SIZE = { width: 48, height: 32 };
/** So many are gathered by the effect over time. */
const FRAMES = 4;
const { renderer: three } = await testRenderer(SIZE.width, SIZE.height);
const renderer = new RealtimeRenderer(three, { samples: 1 });
const onError = (message: string) => {
  throw new Error(message);
};
const assets = new AssetLoader(nodeAssets);
const mirror = new SceneMirror({ assets, onError });
afterAll(() => {
  renderer.dispose();
  mirror.dispose();
});

const store = new DocumentStore(createDocument());
addObject(store, 'plane');
const sphere = addObject(store, 'sphere');
addLight(store, 'directional');
const a = store.document.objects[sphere]!.material;
const b = { ...materialDefaults, parameters: { baseColor: [0.9, 0.02, 0.01] as [number, number, number] } };

/** Of a document by a renderer of its own. */
async function alone(document: Document): Promise<Uint8Array> {
  mirror.apply(document);
  const own = renderer.beside();
  for (let i = 0; i < FRAMES; i++) own.draw(mirror, document, SIZE);
  const pixels = await renderer.readImage(document.view, { radiance: own.texture, from: 0 });
  own.release();
  return pixels;
}

describe('two materials side by side are each what it is alone', () => {
  test.each([
    ['without effects', () => {}],
    [
      'with shadows and antialiasing over time',
      ({ effects }: Document) => {
        effects.shadows.enabled = true;
        effects.shadows.resolution = 64;
        effects.antialiasing.method = 'temporal';
      },
    ],
  ])('%s', async (_, recipe) => {
    store.edit('Effects', recipe);
    const { document } = store;
    const { view } = document;
    mirror.apply(document);
    await mirror.settled();
    const first = renderer.beside();
    const picture = new SecondPicture({ mirror, renderer: first, assets, onError });
    picture.show(document, { material: b, models: {}, assets: {} });
    for (let i = 0; i < FRAMES; i++) {
      first.companion = picture.draw(document, a, SIZE, 0.5);
      first.render(mirror, document, SIZE);
    }
    const [left, right, both] = await Promise.all([
      first.readImage(view, null),
      first.readImage(view, picture.last(0)),
      first.readImage(view),
    ]);
    picture.dispose();
    first.release();
    for (let i = 0; i < both.length; i++) {
      const isLeft = (i >> 2) % SIZE.width < SIZE.width / 2;
      expect(both[i]).toBe((isLeft ? left : right)[i]);
    }
    expect(left).not.toEqual(right);
    expect(mirror.objectFor(sphere)?.material).toBe(mirror.materialFor(a));
    expect(left).toEqual(await alone(document));
    expect(right).toEqual(await alone({ ...document, materials: { ...document.materials, [a]: b } }));
  });
});
