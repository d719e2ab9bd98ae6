import { expect, it } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { importGltf } from '../../../src/io/gltf.ts';
import { exportGltf } from '../../../src/io/gltf-export.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { createDocument } from '../../../src/scene/document.ts';
import {
  setEarthlySky,
  setEnvironmentSource,
  setSunPositionType,
} from '../../../src/scene/environment-commands.ts';
import { skyDefaults } from '../../../src/scene/environment-schema.ts';
import type { LightOf } from '../../../src/scene/schema.ts';
import { lightsOf, SUN_ID } from '../../../src/scene/sky/sun.ts';
import { sunPosition } from '../../../src/scene/sky/sun-position.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

const sunOf = (store: DocumentStore) => lightsOf(store.document)[SUN_ID] as LightOf<'directional'>;

function skyStore(): DocumentStore {
  const store = new DocumentStore(createDocument());
  setEnvironmentSource(store, skyDefaults);
  return store;
}

it('a sky has a sun among the lights, which stands where it is said and turns with the environment', () => {
  const store = skyStore();
  expect(store.document.lights[SUN_ID]).toBeUndefined();
  store.edit('turn', ({ environment }) => {
    environment.rotation = 40;
    if (environment.source.type === 'sky')
      environment.source.sun = { type: 'direction', azimuth: 90, elevation: 0.0001 };
  });
  // East is +x; turned by 40 degrees about y, x goes towards -z.
  const [x, , z] = sunOf(store).position;
  expect(x).toBeCloseTo(Math.cos((40 * Math.PI) / 180), 5);
  expect(z).toBeCloseTo(-Math.sin((40 * Math.PI) / 180), 5);
  // The same object as long as nothing has changed.
  expect(lightsOf(store.document)).toBe(lightsOf(store.document));
});

it('is shown behind the scene, with shadows; what was chosen under a sky stays with another one', () => {
  const store = skyStore();
  expect(store.document.background).toEqual({ type: 'environment', blur: 0 });
  expect(store.document.effects.shadows.enabled).toBe(true);
  store.edit('choose', ({ effects }) => {
    effects.shadows.enabled = false;
  });
  setEnvironmentSource(store, { ...skyDefaults, turbidity: 4 });
  expect(store.document.environment.source).toMatchObject({ turbidity: 4 });
  expect(store.document.effects.shadows.enabled).toBe(false);
});

it('is as bright as on Earth at a click, where a meter exposes then, and back', () => {
  const store = skyStore();
  const before = sunOf(store).illuminance;
  setEarthlySky(store, true);
  expect(sunOf(store).illuminance / before).toBeCloseTo(2 ** 15, 3);
  expect(store.document.view.exposureMode).toBe('auto');
  store.undo();
  expect(sunOf(store).illuminance).toBe(before);
  expect(store.document.view.exposureMode).toBe('manual');
  store.redo();
  setEarthlySky(store, false);
  expect(sunOf(store).illuminance).toBe(before);
  expect(store.document.view.exposureMode).toBe('manual');
  // A camera's exposure stays the person's.
  store.edit('Expose as the camera', ({ view }) => {
    view.exposureMode = 'camera';
  });
  for (const earthly of [true, false]) {
    setEarthlySky(store, earthly);
    expect(store.document.view.exposureMode).toBe('camera');
  }
});

it('a place and a time become the direction that they have meant', () => {
  const store = skyStore();
  setSunPositionType(store, 'place');
  const placed = sunOf(store).position;
  const { source } = store.document.environment;
  const place = source.type === 'sky' ? source.sun : null;
  setSunPositionType(store, 'direction');
  const after = store.document.environment.source;
  expect(place?.type === 'place' && sunPosition(place).azimuth).toBeCloseTo(
    after.type === 'sky' && after.sun.type === 'direction' ? after.sun.azimuth : Number.NaN,
    1,
  );
  for (const [i, x] of sunOf(store).position.entries()) expect(x).toBeCloseTo(placed[i]!, 3);
});

it('goes into a glTF file while it is up', async () => {
  const assets = new AssetLoader(nodeAssets);
  const lights = async (elevation: number) => {
    const store = skyStore();
    store.edit('set', ({ environment: { source } }) => {
      if (source.type === 'sky') source.sun = { type: 'direction', azimuth: 200, elevation };
    });
    const { bytes } = await exportGltf(store.document, assets);
    return { sun: sunOf(store), found: (await importGltf(bytes, 'a.glb', assets)).contents.lights };
  };
  const { sun, found } = await lights(30);
  expect(found.length).toBe(1);
  expect((found[0]!.light as LightOf<'directional'>).illuminance).toBeCloseTo(sun.illuminance, 4);
  // One light less, and nothing to be imported at all.
  await expect(lights(-10)).rejects.toThrow();
});
