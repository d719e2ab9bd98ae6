/** The scenes in which path tracers are compared. */
import { parseDocument } from '../src/scene/document.ts';
import type { Document } from '../src/scene/schema.ts';

const square = (
  material: string,
  position: readonly number[],
  rotation: readonly number[],
  width = 2,
  height = 2,
) => ({
  name: material,
  material,
  position,
  rotation,
  geometry: { type: 'plane', width, height },
});

const matte = (name: string, albedo: readonly number[], more: object = {}) => ({
  name,
  model: 'lambert',
  parameters: { albedo },
  ...more,
});

/** Cornell's box with an area light, a block of rough metal and a glossy ball. */
export function cornellBox(): Document {
  return parseDocument(
    {
      format: 'irradia',
      version: 1,
      name: 'Cornell box',
      camera: { fov: 39.3, position: [0, 1, 3.9], target: [0, 1, 0] },
      background: { type: 'color', color: [0, 0, 0] },
      objects: {
        floor: square('white', [0, 0, 0], [-90, 0, 0]),
        ceiling: square('white', [0, 2, 0], [90, 0, 0]),
        back: square('white', [0, 1, -1], [0, 0, 0]),
        left: square('red', [-1, 1, 0], [0, 90, 0]),
        right: square('green', [1, 1, 0], [0, -90, 0]),
        lamp: square('lamp', [0, 1.99, 0], [90, 0, 0], 0.5, 0.4),
        block: {
          name: 'block',
          material: 'metal',
          position: [-0.35, 0.6, -0.35],
          rotation: [0, 17, 0],
          geometry: { type: 'box', width: 0.6, height: 1.2, depth: 0.6 },
        },
        ball: {
          name: 'ball',
          material: 'gloss',
          position: [0.4, 0.35, 0.35],
          geometry: { type: 'sphere', radius: 0.35, widthSegments: 48, heightSegments: 24 },
        },
      },
      materials: {
        white: matte('white', [0.73, 0.73, 0.73]),
        red: matte('red', [0.63, 0.06, 0.05]),
        green: matte('green', [0.14, 0.45, 0.09]),
        lamp: matte('lamp', [0, 0, 0], { emissive: [1, 0.7, 0.4], emissiveIntensity: 17 }),
        metal: {
          name: 'metal',
          model: 'principled',
          parameters: { metallic: 1, roughness: 0.4, baseColor: [0.9, 0.9, 0.9] },
        },
        gloss: {
          name: 'gloss',
          model: 'principled',
          parameters: { roughness: 0.1, baseColor: [0.2, 0.3, 0.8] },
        },
      },
    },
    'cornell box',
  );
}

/** Suzanne on a floor in a measured environment. */
export function suzanneOutdoors(): Document {
  return parseDocument(
    {
      format: 'irradia',
      version: 1,
      name: 'Suzanne',
      camera: { fov: 40, position: [0.6, 1.6, 4], target: [0, 0.8, 0] },
      environment: { source: { type: 'preset', name: 'city' } },
      background: { type: 'environment', blur: 0 },
      objects: {
        floor: square('floor', [0, 0, 0], [-90, 0, 0], 8, 8),
        suzanne: {
          name: 'suzanne',
          material: 'suzanne',
          position: [0, 0.95, 0],
          geometry: { type: 'suzanne' },
        },
      },
      materials: {
        floor: {
          name: 'floor',
          model: 'principled',
          parameters: { baseColor: [0.5, 0.5, 0.5], roughness: 0.6 },
        },
        suzanne: {
          name: 'suzanne',
          model: 'principled',
          parameters: { baseColor: [0.8, 0.3, 0.1], roughness: 0.35 },
        },
      },
    },
    'suzanne',
  );
}
