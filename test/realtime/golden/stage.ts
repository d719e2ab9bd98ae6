/** What the golden pictures show: a stage with something for every effect to do, and the effects one by one. */
import { loadScene } from '../../../scenes/index.ts';
import { withPreset } from '../../../src/scene/effect-presets.ts';
import type { Document, Effects } from '../../../src/scene/schema.ts';
import { material, scene } from '../../pathtracer/scenes.ts';

const ball = (position: readonly number[], of: string) => ({
  name: of,
  material: of,
  position,
  geometry: { type: 'sphere', radius: 0.5, widthSegments: 48, heightSegments: 24 },
});

const plane = (more: object) => ({
  name: 'plane',
  material: 'plaster',
  geometry: { type: 'plane', width: 8, height: 8 },
  ...more,
});

/** A room's corner with a matt, a glossy and a brushed ball and a block, a sun, a lamp, a panel and a dim sky. */
const stage = scene({
  camera: { fov: 38, position: [0.6, 1.8, 5.2], target: [0, 0.55, 0], fStop: 0, shutter: 0.05 },
  materials: {
    plaster: material('lambert', { albedo: [0.62, 0.58, 0.52] }),
    red: material('lambert', { albedo: [0.7, 0.12, 0.08] }),
    mirror: material('cook-torrance', { roughness: 0.15 }),
    brushed: material('principled', {
      baseColor: [0.9, 0.7, 0.4],
      metallic: 1,
      roughness: 0.35,
      anisotropic: 0.7,
    }),
    lamp: material('lambert', { albedo: [0, 0, 0] }, { emissive: [1, 0.7, 0.4], emissiveIntensity: 12 }),
  },
  objects: {
    floor: plane({ rotation: [-90, 0, 0] }),
    wall: plane({ position: [0, 0, -1.4] }),
    red: ball([-1.25, 0.5, -0.3], 'red'),
    mirror: ball([0, 0.5, 0.2], 'mirror'),
    brushed: ball([1.25, 0.5, -0.3], 'brushed'),
    block: {
      name: 'block',
      material: 'plaster',
      position: [-0.55, 0.15, 1.1],
      rotation: [0, 30, 0],
      geometry: { type: 'box', width: 0.3, height: 0.3, depth: 0.3 },
    },
    bulb: {
      name: 'bulb',
      material: 'lamp',
      position: [0.8, 0.12, 1.0],
      geometry: { type: 'sphere', radius: 0.12, widthSegments: 24, heightSegments: 12 },
    },
  },
  lights: {
    sun: { type: 'directional', name: 'sun', illuminance: 2.5, position: [3, 5, 3], target: [0, 0, 0] },
    lamp: { type: 'point', name: 'lamp', intensity: 2.4, position: [-1.8, 2, 1.2] },
  },
  environment: { source: { type: 'constant', color: [0.12, 0.15, 0.2] }, samples: 8 },
});

type Changes = { readonly [E in keyof Effects]?: Partial<Effects[E]> };

function withEffects(changes: Changes, more: Partial<Document> = {}): Document {
  const effects = { ...stage.effects } as Record<string, object>;
  for (const [name, change] of Object.entries(changes)) effects[name] = { ...effects[name], ...change };
  return { ...stage, ...more, effects: effects as unknown as Effects };
}

const on = { enabled: true };
const lens = { ...stage.camera, fStop: 1.4, sensorHeight: 36, focusDistance: 2 };

/** Every picture by its name; `moving` ones have the camera on its way. */
export const goldenDocuments: Readonly<Record<string, () => Promise<Document> | Document>> = {
  plain: () => stage,
  shadows: () => withEffects({ shadows: on }),
  'ambient-occlusion': () => withEffects({ ambientOcclusion: on }),
  'contact-shadows': () => withEffects({ contactShadows: on }),
  reflections: () => withEffects({ reflections: on }),
  'indirect-light': () => withEffects({ indirectLight: on }),
  fog: () => withEffects({ shadows: on }, { fog: { ...stage.fog, density: 0.12 } }),
  temporal: () => withEffects({ antialiasing: { method: 'temporal' } }),
  smaa: () => withEffects({ antialiasing: { method: 'smaa' } }),
  fxaa: () => withEffects({ antialiasing: { method: 'fxaa' } }),
  'depth-of-field': () => withEffects({ depthOfField: on }, { camera: lens }),
  'motion-blur, moving': () => withEffects({ motionBlur: on }),
  bloom: () => withEffects({ bloom: on }),
  lens: () => withEffects({ lens: { ...on, dispersion: 0.02 } }),
  'preset high': () => ({ ...stage, effects: withPreset(stage.effects, 'high') }),
  'shading normals': () => ({ ...stage, view: { ...stage.view, show: 'shadingNormals' } }),
  luminance: () => ({ ...stage, view: { ...stage.view, show: 'luminance' } }),
  thesis: () => loadScene('thesis'),
  'thesis-demo02': () => loadScene('thesis-demo02'),
};
