/** The ground that shows shadows, as kernel/ground.glsl reads it. */
import type { Matrix4 } from 'three/webgpu';
import { environmentScale } from '../../scene/environment-map.ts';
import { levelRadiance } from '../../scene/level-irradiance.ts';
import { BLOCK_NUMBERS, BLOCK_SLOTS, BLOCK_TRIANGLES, HEADER, NONE, WORDS_PER_SLOT } from './layout.ts';
import { blocksAt, type PackedMesh } from './mesh.ts';
import type { Instance, Scene } from './scene.ts';
import { uniformSky } from './sky.ts';
import type { Words } from './words.ts';

/**
 * @param boxes six numbers for each instance: minimum and maximum in the world
 * @param level the word of the sky's distribution for level ground
 */
export function writeGround(header: Words, scene: Scene, boxes: readonly number[], level: number): void {
  const { ground, background, environment } = scene.document;
  if (!ground.shadowCatcher) return;
  const height = ground.height ?? lowestOf(scene.instances);
  header.setFloats(HEADER.ground, height, ground.radius, ground.fade, ground.strength);
  const { upper } = uniformSky(scene.document);
  const scale = environmentScale(environment);
  const map = scene.map && levelRadiance(scene.map, environment.source.type === 'sky');
  const sky = upper.map((radiance, c) => Math.PI * (radiance + scale * (map?.[c] ?? 0)));
  header.setFloats(HEADER.levelSky, ...sky);
  header.setUint(HEADER.levelSky, 3, level);
  const isTransparent = background.type === 'transparent';
  header.setFloats(HEADER.groundPlace, middle(boxes, 0), middle(boxes, 2), 1, Number(isTransparent));
}

/** The middle of all boxes along an axis; 0 if there are none. */
function middle(boxes: readonly number[], axis: number): number {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let at = axis; at < boxes.length; at += 6) {
    low = Math.min(low, boxes[at]!);
    high = Math.max(high, boxes[at + 3]!);
  }
  return low <= high ? (low + high) / 2 : 0;
}

/** The height of the lowest point; 0 if there is none. */
function lowestOf(instances: readonly Instance[]): number {
  let lowest = Number.POSITIVE_INFINITY;
  for (const { mesh, placement } of instances)
    lowest = Math.min(lowest, lowestPoint(mesh, placement.toWorld));
  return Number.isFinite(lowest) ? lowest : 0;
}

function lowestPoint(mesh: PackedMesh, { elements: m }: Matrix4): number {
  const [a, b, c] = [m[1]!, m[5]!, m[9]!];
  const floats = new Float32Array(mesh.words.buffer, mesh.words.byteOffset, mesh.words.length);
  let least = Number.POSITIVE_INFINITY;
  for (let block = 0; block < mesh.blocks; block += 1) {
    const at = (blocksAt(mesh) + block * BLOCK_SLOTS) * WORDS_PER_SLOT;
    for (let lane = 0; lane < BLOCK_TRIANGLES; lane += 1) {
      if (mesh.words[at + BLOCK_NUMBERS * WORDS_PER_SLOT + lane] === NONE) continue;
      for (let i = at + lane; i < at + lane + BLOCK_NUMBERS * WORDS_PER_SLOT; i += 3 * WORDS_PER_SLOT)
        least = Math.min(
          least,
          a * floats[i]! + b * floats[i + WORDS_PER_SLOT]! + c * floats[i + 2 * WORDS_PER_SLOT]!,
        );
    }
  }
  return least + m[13]!;
}
