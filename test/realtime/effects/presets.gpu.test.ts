import { expect, test } from 'vitest';
import { type PresetName, withPreset } from '../../../src/scene/effect-presets.ts';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, shareThatDiffers } from './frames.ts';

const SIZE = { width: 32, height: 24 };
const maker = await frameMaker({ ...SIZE, frames: 2 });

const stage = scene({
  camera: { fov: 40, position: [0, 2, 5], target: [0, 0.4, 0] },
  materials: {
    floor: material('lambert', { albedo: [0.6, 0.5, 0.4] }),
    ball: material('principled', { roughness: 0.3, metallic: 1 }),
  },
  objects: {
    floor: {
      name: 'floor',
      material: 'floor',
      rotation: [-90, 0, 0],
      geometry: { type: 'plane', width: 8, height: 8 },
    },
    ball: {
      name: 'ball',
      material: 'ball',
      position: [0, 0.5, 0],
      geometry: { type: 'sphere', radius: 0.5 },
    },
  },
  lights: { sun: { type: 'directional', name: 'sun', illuminance: 3, position: [2, 4, 1] } },
  environment: { source: { type: 'constant', color: [0.2, 0.25, 0.3] }, samples: 8 },
});

/** The dearest has nothing that these have not, only more of it. */
const DRAWN: readonly PresetName[] = ['low', 'medium', 'high'];

test('every preset is another picture, and switching back gives the same bits', async () => {
  const mirror = await maker.mirror(stage);
  const draw = async (name: PresetName | null) => {
    const document = name === null ? stage : { ...stage, effects: withPreset(stage.effects, name) };
    maker.renderer.cut();
    for (let frame = 0; frame < 2; frame++) maker.renderer.render(mirror, document, SIZE, 1 / 60);
    return maker.renderer.readRadiance();
  };
  const plain = await draw(null);
  const pictures = [];
  for (const name of DRAWN) pictures.push(await draw(name));
  // The cheapest is the plain frame.
  expect(pictures[0]?.pixels).toEqual(plain.pixels);
  for (const [i, picture] of pictures.entries())
    if (i > 0) expect(shareThatDiffers(pictures[i - 1]!, picture)).toBeGreaterThan(0.02);
  expect((await draw('medium')).pixels).toEqual(pictures[1]?.pixels);
  expect((await draw('low')).pixels).toEqual(plain.pixels);
});

test('the GPU’s times are told by effect, and nothing is measured unless it is asked', async () => {
  const { renderer } = maker;
  const mirror = await maker.mirror(stage);
  renderer.render(mirror, stage, SIZE, 1 / 60);
  expect(await renderer.times.read()).toBe(null);
  expect(renderer.times.available).toBe(true);
  renderer.times.on = true;
  // Shadow maps of a scene that stands still are drawn once: this is that frame.
  renderer.render(mirror, { ...stage, effects: withPreset(stage.effects, 'medium') }, SIZE, 1 / 60);
  const times = await renderer.times.read();
  renderer.times.on = false;
  expect(times?.map(({ name }) => name).sort()).toEqual([
    'ambientOcclusion',
    'antialiasing',
    'output',
    'scene',
    'shadows',
    'surfaces',
  ]);
  // GPUs tell time in coarse steps: what is quick may take none of them.
  for (const { milliseconds } of times ?? []) expect(milliseconds).toBeGreaterThanOrEqual(0);
  expect(times?.reduce((sum, { milliseconds }) => sum + milliseconds, 0)).toBeGreaterThan(0);
});
