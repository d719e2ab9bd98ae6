/**
 * One scene by Irradia's path tracer and by three-gpu-pathtracer, in one page: samples per second, and from the difference
 * of two renderings the relative mean squared error that they have, so that no reference is needed.
 */

import * as THREE from 'three/webgpu';
import { WebGPUPathTracer } from 'three-gpu-pathtracer/webgpu';
import { openStage } from '../src/editor/path-tracing/back-end.ts';
import { ScenePacker } from '../src/pathtracer/scene/pack.ts';
import { AssetLoader } from '../src/scene/assets.ts';
import { SceneMirror } from '../src/scene/mirror.ts';
import { pageAssets } from '../src/scene/page-assets.ts';
import type { Document, Material } from '../src/scene/schema.ts';
import { cornellBox, suzanneOutdoors } from './path-tracing-scenes.ts';

export interface PathTracingRequest {
  scene: 'cornell' | 'suzanne';
  side: number;
  depth: number;
  samples: { ours: number; theirs: number };
}

export interface PathTracingFigures {
  device: string;
  /** Camera paths per second. */
  paths: number;
  /** Relative mean squared error of a picture of one sample a pixel. */
  error: number;
}

export interface PathTracingResult {
  ours: PathTracingFigures;
  theirs: PathTracingFigures;
}

const scenes = { cornell: cornellBox, suzanne: suzanneOutdoors };

export default async function run(request: PathTracingRequest): Promise<PathTracingResult> {
  const document = scenes[request.scene]();
  const assets = new AssetLoader(pageAssets);
  return {
    ours: await measureOurs(document, assets, request),
    theirs: await measureTheirs(document, assets, request),
  };
}

async function measureOurs(
  document: Document,
  assets: AssetLoader,
  { side, depth, samples: { ours: samples } }: PathTracingRequest,
): Promise<PathTracingFigures> {
  const { tracer } = await openStage(() => {});
  await tracer.load(await new ScenePacker(assets).pack(document));
  const pictures: Float32Array[] = [];
  let time = 0;
  for (const seed of [0, 1, 2]) {
    tracer.start(document.camera, {
      width: side,
      height: side,
      maxDepth: depth,
      seed,
      strategy: 'mis',
      clamp: 0,
    });
    const began = performance.now();
    await tracer.render(0, samples);
    // The first rendering compiles.
    if (seed > 0) time += performance.now() - began;
    pictures.push((await tracer.film()).mean());
  }
  tracer.dispose();
  const paths = (2 * samples * side * side) / (time / 1000);
  return { device: tracer.device, paths, error: errorOf(pictures[1]!, pictures[2]!, 3) * samples };
}

async function measureTheirs(
  document: Document,
  assets: AssetLoader,
  { side, depth, samples: { theirs: samples } }: PathTracingRequest,
): Promise<PathTracingFigures> {
  const mirror = new SceneMirror({
    assets,
    onError(message) {
      throw new Error(message);
    },
  });
  mirror.apply(document);
  await mirror.settled();
  const renderer = new THREE.WebGPURenderer();
  renderer.setPixelRatio(1);
  renderer.setSize(side, side);
  await renderer.init();
  const scene = theirScene(document, mirror);
  mirror.camera.aspect = 1;
  mirror.camera.updateProjectionMatrix();
  mirror.camera.updateMatrixWorld(true);

  const tracer = new WebGPUPathTracer(renderer);
  // Its wavefront tracer, the default, has shaders that this version of three.js refuses.
  // The package's types leave this method out.
  (tracer as unknown as { useMegakernel(value: boolean): void }).useMegakernel(true);
  tracer.maxBounces = depth;
  // A round for about a sample a pixel: its default of 250,000 paths takes a software GPU a minute.
  tracer.frameBudget = side * side;
  // From the first round on, at full resolution.
  tracer.renderDelay = 0;
  tracer.minSamples = 0;
  tracer.dynamicLowRes = false;
  tracer.setScene(scene, mirror.camera);
  const trace = async (count: number): Promise<{ count: number; picture: Float32Array; time: number }> => {
    const began = performance.now();
    let taken = 0;
    while (taken < count) {
      tracer.renderSample();
      taken = await meanCount(renderer, tracer, side);
    }
    const time = performance.now() - began;
    const picture = await readTexture(renderer, tracer.target as unknown as THREE.Texture, side);
    return { count: taken, picture, time };
  };
  // The first round compiles. Its random numbers begin anew with every reset, so the second picture goes on where the
  // first one ended.
  await trace(1);
  tracer.reset();
  const first = await trace(samples);
  const both = await trace(2 * samples);
  const ofSecond = both.count / (both.count - first.count);
  const second = both.picture.map((x, i) => x * ofSecond - first.picture[i]! * (ofSecond - 1));
  const paths = (both.count * side * side) / ((first.time + both.time) / 1000);
  const error = errorOf(first.picture, second, 4) * (both.count / 2);
  return { device: 'WebGPU', paths, error };
}

/**
 * Samples a pixel so far. Its own getSampleCountsAsync() has a shader that this version of three.js refuses, so its
 * texture of counts is read.
 */
async function meanCount(
  { backend }: THREE.WebGPURenderer,
  tracer: WebGPUPathTracer,
  side: number,
): Promise<number> {
  const { _pathTracer } = tracer as unknown as { _pathTracer: { sampleCountTarget: THREE.Texture } };
  const { device, get } = backend as unknown as {
    device: GPUDevice;
    get: (texture: THREE.Texture) => { texture?: GPUTexture };
  };
  const { texture } = get.call(backend, _pathTracer.sampleCountTarget);
  if (!texture || texture.width !== side) return 0;
  const usage = GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST;
  const buffer = device.createBuffer({ size: 4 * side * side, usage });
  const encoder = device.createCommandEncoder();
  encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow: 4 * side }, [side, side]);
  device.queue.submit([encoder.finish()]);
  await buffer.mapAsync(GPUMapMode.READ);
  const sum = new Uint32Array(buffer.getMappedRange()).reduce((a, b) => a + b, 0);
  buffer.destroy();
  return sum / (side * side);
}

/** The same meshes with three.js' materials, as far as these have the same parameters. */
function theirScene(document: Document, mirror: SceneMirror): THREE.Scene {
  const scene = new THREE.Scene();
  scene.environment = mirror.scene.environment;
  scene.background = mirror.scene.background;
  const materials = new Map(
    Object.entries(document.materials).map(([id, material]) => [id, theirMaterial(material)]),
  );
  for (const [id, { material }] of Object.entries(document.objects)) {
    const mesh = mirror.objectFor(id) as THREE.Mesh;
    mesh.updateMatrixWorld(true);
    const copy = new THREE.Mesh(mesh.geometry, materials.get(material));
    copy.applyMatrix4(mesh.matrixWorld);
    scene.add(copy);
  }
  scene.updateMatrixWorld(true);
  return scene;
}

function theirMaterial({ parameters, emissive, emissiveIntensity }: Material): THREE.MeshPhysicalMaterial {
  const { baseColor, albedo, roughness, metallic } = parameters as Record<string, number & number[]>;
  return new THREE.MeshPhysicalMaterial({
    color: new THREE.Color(...((baseColor ?? albedo) as unknown as [number, number, number])),
    roughness: roughness ?? 1,
    metalness: metallic ?? 0,
    specularIntensity: albedo ? 0 : 1,
    emissive: new THREE.Color(...emissive),
    emissiveIntensity,
  });
}

async function readTexture(
  renderer: THREE.WebGPURenderer,
  texture: THREE.Texture,
  side: number,
): Promise<Float32Array> {
  const target = new THREE.RenderTarget(side, side, {
    type: THREE.FloatType,
    colorSpace: THREE.NoColorSpace,
  });
  const quad = new THREE.QuadMesh(new THREE.MeshBasicNodeMaterial({ map: texture }));
  renderer.setRenderTarget(target);
  quad.render(renderer);
  renderer.setRenderTarget(null);
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, side, side);
  return Float32Array.from(pixels as Float32Array);
}

/** Relative mean squared error of each of two pictures of the same, independent of each other. */
function errorOf(a: Float32Array, b: Float32Array, channels: number): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < a.length; i++) {
    if (i % channels === 3) continue;
    const mean = (a[i]! + b[i]!) / 2;
    sum += (a[i]! - b[i]!) ** 2 / 2 / (mean * mean + 0.01);
    count++;
  }
  return sum / count;
}
