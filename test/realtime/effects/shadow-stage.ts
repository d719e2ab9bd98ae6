/** Lamps and things for tests of shadows. */
import { material, scene } from '../../pathtracer/scenes.ts';
import type { Picture } from './frames.ts';

export const [WIDTH, HEIGHT] = [60, 40];

export const settings = { shadows: { enabled: true, resolution: 256, samples: 32 } };
export const off = { shadows: { enabled: false } };

export const lights = {
  sun: { type: 'directional', illuminance: 3, position: [2, 4, 2], angularDiameter: 6 },
  point: { type: 'point', intensity: 30, position: [1.2, 3, 1], radius: 0.2 },
  spot: {
    type: 'spot',
    intensity: 40,
    position: [-1.5, 3, 1],
    target: [0, 0.3, 0],
    cutoff: 35,
    radius: 0.15,
  },
  'wide spot': {
    type: 'spot',
    intensity: 15,
    position: [-0.8, 1.8, 0.6],
    target: [0, 0, 0],
    cutoff: 85,
    radius: 0.06,
  },
  rectangle: {
    type: 'rectangle',
    luminance: 12,
    position: [1, 2.6, 1.5],
    target: [0, 0.3, 0],
    width: 1,
    height: 0.6,
  },
} as const;
export const kinds = Object.keys(lights) as (keyof typeof lights)[];

export const plane = (size: number, more: object = {}) => ({
  name: 'floor',
  material: 'floor',
  rotation: [-90, 0, 0],
  geometry: { type: 'plane', width: size, height: size },
  ...more,
});
export const ball = (radius: number, more: object = {}) => ({
  name: 'ball',
  material: 'm',
  geometry: { type: 'sphere', radius, widthSegments: 192, heightSegments: 96 },
  ...more,
});
export const white = { albedo: [0.8, 0.8, 0.8] };
export const materials = {
  m: material('lambert', white),
  // Seen from both sides: it is drawn into the maps, too.
  floor: material('lambert', white, { doubleSided: true }),
};

/** A ball above a floor. */
export const stage = (light: object, effects: object = settings) =>
  scene({
    camera: { fov: 40, position: [0, 3, 3], target: [0, 0.2, 0] },
    background: { type: 'color', color: [0, 0, 0] },
    objects: { floor: plane(40), ball: ball(0.4, { position: [0, 0.7, 0] }) },
    materials,
    lights: { light },
    effects,
  });

/** Luminance is the same in all channels here. */
export const grey = ({ pixels }: Picture) =>
  Float64Array.from({ length: pixels.length / 4 }, (_, i) => pixels[4 * i]!);
