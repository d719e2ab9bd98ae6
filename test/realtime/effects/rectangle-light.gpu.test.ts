import { expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, type Picture } from './frames.ts';
import { meanError, reduced, traced } from './reference.ts';

/** A still life under two soft boxes, as a photographer lights it: within 5 % of the path tracer in the mean. */

const SIZE = { width: 48, height: 32 };
const FINER = 4;
const maker = await frameMaker({ width: SIZE.width * FINER, height: SIZE.height * FINER });

const ball = (x: number, of: string) => ({
  name: of,
  material: of,
  position: [x, 0.5, 0],
  geometry: { type: 'sphere', radius: 0.5, widthSegments: 96, heightSegments: 48 },
});

const document = scene({
  camera: { fov: 35, position: [0, 1.3, 5], target: [0, 0.4, 0] },
  background: { type: 'color', color: [0, 0, 0] },
  materials: {
    floor: material('principled', { baseColor: [0.4, 0.4, 0.4], roughness: 0.3 }),
    clay: material('lambert', { albedo: [0.7, 0.5, 0.4] }),
    metal: material('principled', { baseColor: [0.9, 0.7, 0.4], metallic: 1, roughness: 0.25 }),
    lacquer: material('cook-torrance', { roughness: 0.15 }),
  },
  objects: {
    floor: {
      name: 'f',
      material: 'floor',
      rotation: [-90, 0, 0],
      geometry: { type: 'plane', width: 9, height: 9 },
    },
    clay: ball(-1.2, 'clay'),
    metal: ball(0, 'metal'),
    lacquer: ball(1.2, 'lacquer'),
  },
  lights: {
    key: {
      type: 'rectangle',
      luminance: 4,
      position: [-2.5, 2.2, 2],
      target: [0, 0.3, 0],
      width: 1.4,
      height: 1,
    },
    rim: {
      type: 'rectangle',
      luminance: 6,
      position: [2.2, 2.4, -1.8],
      target: [0, 0.5, 0],
      width: 0.4,
      height: 0.8,
    },
  },
  effects: { antialiasing: { method: 'none' }, shadows: { enabled: true, resolution: 512, samples: 16 } },
});

/** A lamp's image in what is glossy is smaller than a pixel, and far brighter than white. */
const shownWhite = (picture: Picture): Picture => ({
  ...picture,
  pixels: picture.pixels.map((x) => Math.min(x, 1)),
});

test('soft boxes on matt, glossy and metal things are the path tracer’s', async () => {
  const shown = reduced(shownWhite(reduced(await maker.draw(document), FINER)), 2);
  const film = reduced(shownWhite(await traced(document, SIZE, 128, 1)), 2);
  const { error, bias } = meanError(shown, film);
  expect(error).toBeLessThan(0.05);
  expect(Math.abs(bias)).toBeLessThan(0.02);
});
