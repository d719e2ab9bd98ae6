/**
 * Whole frames of each preset, by Irradia and by a pipeline of what three.js ships, and what each effect adds to the plain
 * frame. All take turns, one frame each; the camera and a sphere move from frame to frame, so that nothing is kept.
 */
import * as THREE from 'three/webgpu';
import { createRenderer } from '../src/realtime/renderer.ts';
import { AssetLoader } from '../src/scene/assets.ts';
import { parseDocument } from '../src/scene/document.ts';
import { presetNames, withPreset } from '../src/scene/effect-presets.ts';
import type { Effects } from '../src/scene/effects-schema.ts';
import { SceneMirror } from '../src/scene/mirror.ts';
import { pageAssets } from '../src/scene/page-assets.ts';
import type { Document } from '../src/scene/schema.ts';
import { stockPipeline, stockShadows } from './stock-pipeline.ts';

export interface EffectsRequest {
  part: 'presets' | 'effects';
  frames: number;
  width: number;
  height: number;
}

/**
 * Milliseconds of each frame, by what was drawn. Of presets: beside those of a three.js pipeline; of effects: beside as many
 * plain ones.
 */
export type EffectsResult = Record<string, { ours: number[]; beside: number[] }>;

const SPHERES = Array.from({ length: 20 }, (_, i) => ({
  position: [((i % 5) - 2) * 1.2, 0.45, (Math.floor(i / 5) - 1.5) * 1.2] as const,
}));
const FOG_DENSITY = 0.05;

const document = parseDocument(
  {
    format: 'irradia',
    version: 1,
    name: 'Bench',
    camera: { fov: 45, position: [0, 3, 6.5], target: [0, 0.3, 0], fStop: 2.8, near: 0.1, far: 50 },
    materials: {
      floor: { name: 'Floor', model: 'principled', parameters: { roughness: 0.4 } },
      ball: { name: 'Ball', model: 'principled', parameters: { roughness: 0.2, metallic: 0.5 } },
    },
    objects: {
      floor: {
        name: 'Floor',
        material: 'floor',
        rotation: [-90, 0, 0],
        geometry: { type: 'plane', width: 20, height: 20 },
      },
      ...Object.fromEntries(
        SPHERES.map(({ position }, i) => [
          `s${i}`,
          {
            name: `${i}`,
            material: 'ball',
            position,
            geometry: { type: 'sphere', radius: 0.45, widthSegments: 64, heightSegments: 32 },
          },
        ]),
      ),
    },
    lights: {
      ambient: { type: 'ambient', name: 'Ambient', luminance: 0.2 },
      sun: { type: 'directional', name: 'Sun', illuminance: 2, position: [2, 4, 3], target: [0, 0, 0] },
      bulb: { type: 'point', name: 'Bulb', intensity: 8, position: [-2, 3, 2] },
      spot: { type: 'spot', name: 'Spot', intensity: 20, position: [3, 4, 3], target: [0, 0, 0] },
    },
  },
  'bench',
);

/** The document in one of its frames. */
function at(frame: number, effects: Effects, more: Partial<Document> = {}): Document {
  const [x, y, z] = document.camera.position;
  const ball = document.objects.s7!;
  return {
    ...document,
    ...more,
    effects,
    camera: { ...document.camera, position: [x + frame / 50, y, z] },
    objects: { ...document.objects, s7: { ...ball, position: [ball.position[0], 0.45 + frame / 50, 0] } },
  };
}

export default async function effects({
  part,
  frames,
  width,
  height,
}: EffectsRequest): Promise<EffectsResult> {
  const size = { width, height };
  const renderer = await createRenderer();
  const plain = withPreset(document.effects, 'low');
  const ours = async (settings: Effects, more: Partial<Document> = {}) => {
    const mirror = new SceneMirror({ assets: new AssetLoader(pageAssets), onError: console.error });
    mirror.apply(at(0, settings, more));
    await mirror.settled();
    return async (frame: number) => {
      const shown = at(frame, settings, more);
      mirror.apply(shown);
      renderer.render(mirror, shown, size, 1 / 60);
      await finished(renderer.three);
    };
  };
  const result: EffectsResult = {};
  for (const name of part === 'presets' ? presetNames : []) {
    const settings = withPreset(document.effects, name);
    const [own, stock] = [await ours(settings), await stockFrame(settings, size)];
    result[name] = { ours: [], beside: [] };
    for (let frame = -WARM_UP; frame < frames; frame++) {
      const [a, b] = [await timed(own, frame), await timed(stock, frame)];
      if (frame < 0) continue;
      result[name].ours.push(a);
      result[name].beside.push(b);
    }
  }

  const high = withPreset(document.effects, 'high');
  const alone = (change: Partial<Effects>): Effects => ({ ...plain, ...change });
  const on = <E extends keyof Effects>(effect: E, settings: Effects = high) =>
    alone({ [effect]: { ...settings[effect], enabled: true } });
  const method = (name: Effects['antialiasing']['method']) => alone({ antialiasing: { method: name } });
  const fog = { fog: { ...document.fog, density: FOG_DENSITY } };
  const variants: Record<string, [Effects, Partial<Document>?]> = {
    'one sample a pixel': [method('none')],
    shadows: [on('shadows')],
    ambientOcclusion: [on('ambientOcclusion')],
    contactShadows: [on('contactShadows')],
    reflections: [on('reflections')],
    indirectLight: [on('indirectLight', withPreset(document.effects, 'ultra'))],
    fog: [on('fog'), fog],
    temporal: [method('temporal')],
    smaa: [method('smaa')],
    fxaa: [method('fxaa')],
    depthOfField: [on('depthOfField')],
    motionBlur: [on('motionBlur')],
    bloom: [on('bloom')],
    lens: [on('lens')],
  };
  // Effects are built anew when they change: a few frames in a row of each, then as many plain ones.
  const plainFrame = await ours(plain);
  for (const [name, [settings, more]] of part === 'effects' ? Object.entries(variants) : []) {
    const draw = await ours(settings, more);
    result[name] = { ours: await inARow(draw, frames), beside: await inARow(plainFrame, frames) };
  }
  return result;
}

async function inARow(draw: (frame: number) => Promise<void>, frames: number): Promise<number[]> {
  const times: number[] = [];
  for (let frame = -WARM_UP; frame < frames; frame++) {
    const ms = await timed(draw, frame);
    if (frame >= 0) times.push(ms);
  }
  return times;
}

/** Frames that compile, and fill what gathers frames. */
const WARM_UP = 2;

async function timed(draw: (frame: number) => Promise<void>, frame: number): Promise<number> {
  const start = performance.now();
  await draw(frame);
  return performance.now() - start;
}

async function stockFrame(settings: Effects, { width, height }: { width: number; height: number }) {
  const renderer = new THREE.WebGPURenderer();
  await renderer.init();
  renderer.setSize(width, height, false);
  renderer.toneMapping = THREE.NeutralToneMapping;
  renderer.shadowMap.enabled = settings.shadows.enabled;
  const { camera: lens } = document;
  const camera = new THREE.PerspectiveCamera(lens.fov, width / height, lens.near, lens.far);
  const scene = stockScene();
  const ball = scene.getObjectByName('7') as THREE.Mesh;
  stockShadows(scene, settings);
  const pipeline = stockPipeline(renderer, scene, camera, settings, lens.fStop);
  return async (frame: number) => {
    const shown = at(frame, settings);
    camera.position.set(...shown.camera.position);
    camera.lookAt(...(shown.camera.target as [number, number, number]));
    ball.position.set(...shown.objects.s7!.position);
    pipeline.render();
    await finished(renderer);
  };
}

function stockScene(): THREE.Scene {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0.02, 0.02, 0.022);
  const sun = new THREE.DirectionalLight(0xffffff, 2);
  sun.position.set(2, 4, 3);
  const bulb = new THREE.PointLight(0xffffff, 8);
  bulb.position.set(-2, 3, 2);
  const spot = new THREE.SpotLight(0xffffff, 20, 0, Math.PI / 6, 0.3);
  spot.position.set(3, 4, 3);
  scene.add(new THREE.AmbientLight(0xffffff, 0.6), sun, sun.target, bulb, spot, spot.target);
  const floor = new THREE.Mesh(
    new THREE.PlaneGeometry(20, 20),
    new THREE.MeshPhysicalNodeMaterial({ roughness: 0.4 }),
  );
  floor.rotation.x = -Math.PI / 2;
  const geometry = new THREE.SphereGeometry(0.45, 64, 32);
  const material = new THREE.MeshPhysicalNodeMaterial({ roughness: 0.2, metalness: 0.5 });
  for (const [i, { position }] of SPHERES.entries()) {
    const sphere = new THREE.Mesh(geometry, material);
    sphere.name = `${i}`;
    sphere.position.set(...position);
    scene.add(sphere);
  }
  scene.add(floor);
  return scene;
}

async function finished(renderer: THREE.WebGPURenderer): Promise<void> {
  const { device } = renderer.backend as { device?: GPUDevice };
  await device?.queue.onSubmittedWorkDone();
}
