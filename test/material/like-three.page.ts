import * as THREE from 'three/webgpu';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { brdf, different, draw, FEATURES, lambert } from './like-three.ts';
import { drawSphere, modelNamed, SIZE, sphereGeometry } from './lit-sphere.ts';

export interface Likeness {
  readonly backend: string;
  /** By feature: the share of values that differ from three.js's material, and from the plain sphere. */
  readonly features: Readonly<Record<string, { fromThree: number; fromPlain: number }>>;
  /** The same for a white texture on every parameter of a model against none. */
  readonly whiteMaps: number;
}

const COMBINED = ['a normal map', 'an occlusion map', 'emission with a map', 'a light map'];
/** An alpha test is not with the normal map: derivatives beside a pixel that was discarded are whatever the GPU makes them. */
const ALONE = [
  'an alpha test',
  'a bump map',
  'shadows',
  'colours of instances',
  'two sides',
  'vertex colours',
];

/** The features that need textures all at once, and others one by one. */
export default async function compare({ forceWebGL }: { forceWebGL: boolean }): Promise<Likeness> {
  const renderer = new THREE.WebGPURenderer({ forceWebGL, canvas: document.createElement('canvas') });
  await renderer.init();
  renderer.setSize(SIZE, SIZE, false);
  const plain = await draw(renderer, brdf(), {});
  const cases = {
    ...Object.fromEntries(ALONE.map((name) => [name, FEATURES[name] ?? {}])),
    [COMBINED.join(', ')]: {
      set: (material: Parameters<typeof draw>[1]) => {
        for (const name of COMBINED) FEATURES[name]?.set?.(material);
      },
    },
  };
  const features: Record<string, { fromThree: number; fromPlain: number }> = {};
  for (const [name, feature] of Object.entries(cases)) {
    const picture = await draw(renderer, brdf(), feature);
    const fromThree = different(picture, await draw(renderer, lambert(), feature));
    features[name] = { fromThree, fromPlain: different(picture, plain) };
  }
  const { backend } = renderer as unknown as { backend: { isWebGPUBackend?: boolean } };
  return {
    backend: backend.isWebGPUBackend ? 'webgpu' : 'webgl',
    features,
    whiteMaps: await whiteMaps(renderer),
  };
}

async function whiteMaps(renderer: THREE.WebGPURenderer): Promise<number> {
  const model = modelNamed('principled');
  const white = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
  white.needsUpdate = true;
  const light = new THREE.DirectionalLight(0xffffff, 3);
  light.position.set(1, 2, 2);
  const geometry = sphereGeometry();
  const mapped = new BrdfMaterial(model);
  // Every third parameter: WebGL 2 promises 16 textures.
  for (const { name } of model.parameters.filter((_, i) => i % 3 === 0)) mapped.setMap(name, white);
  const without = await drawSphere(renderer, geometry, new BrdfMaterial(model), [light]);
  return different(await drawSphere(renderer, geometry, mapped, [light]), without);
}
