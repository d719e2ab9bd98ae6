import { lightsOf } from '../../scene/sky/sun.ts';
import { writeTriangleLights } from './emitters.ts';
import { LIGHT_SLOTS, LIGHT_TYPES, NONE } from './layout.ts';
import { type TreeLight, writeLightTree } from './light-tree.ts';
import { type LightRecord, lightRecord, lightSlot, writeLight } from './lights.ts';
import { type Emission, emissionOf } from './materials.ts';
import type { Pace } from './pace.ts';
import type { Scene } from './scene.ts';
import type { Words } from './words.ts';

export interface WrittenLights {
  readonly slot: number;
  /** The first so many are rectangles. */
  readonly rectangles: number;
  readonly finite: number;
  /** The first so many are lamps; triangles of what glows follow. */
  readonly lamps: number;
  readonly infiniteSlot: number;
  readonly infinite: number;
  /** Root of the tree; 0 without finite lights. */
  readonly root: number;
  /** The sky's place among the infinite lights. */
  readonly sky: number;
  /** The first light of each instance's triangles, NONE for what does not shine. */
  readonly firstOf: readonly number[];
}

/** Writes all lights and the tree of the finite ones; their bit trails are set. */
export async function writeLights(words: Words, scene: Scene, pace: Pace): Promise<WrittenLights> {
  const { document, instances, materials, textures, distribution } = scene;
  const records = Object.values(lightsOf(document)).flatMap((light) => lightRecord(light) ?? []);
  // Rectangles come first: they are looked for along rays (kernel/integrator.glsl).
  const isRectangle = ({ type }: LightRecord) => type === LIGHT_TYPES.rectangle;
  const rectangles = records.filter(isRectangle);
  const near = [...rectangles, ...records.filter((record) => record.bounds !== null && !isRectangle(record))];
  const far = records.filter(({ bounds }) => bounds === null);
  if (distribution.integral > 0) far.push(SKY_LIGHT);
  const tree: TreeLight[] = [];

  const slot = words.allocate(near.length * LIGHT_SLOTS);
  for (const [light, record] of near.entries()) {
    writeLight(words, lightSlot(slot, light), record);
    if (record.bounds !== null) tree.push({ light, bounds: record.bounds });
  }
  let finite = near.length;
  const firstOf: number[] = [];
  const emissions = materials.map((used): Emission | null => emissionOf(used, textures));
  for (const [i, { mesh, placement, material }] of instances.entries()) {
    const emission = emissions[material] ?? null;
    firstOf.push(emission === null ? NONE : finite);
    if (emission === null) continue;
    await writeTriangleLights(words, finite, mesh, placement, i, emission, tree, pace);
    finite += mesh.triangles;
  }
  const infiniteSlot = words.allocate(far.length * LIGHT_SLOTS);
  for (const [i, record] of far.entries()) writeLight(words, lightSlot(infiniteSlot, i), record);
  const sky = far.indexOf(SKY_LIGHT);
  const root = await writeLightTree(words, tree, pace, (light, trail) =>
    words.setUint(lightSlot(slot, light), 3, trail),
  );
  return {
    slot,
    rectangles: rectangles.length,
    finite,
    lamps: near.length,
    infiniteSlot,
    infinite: far.length,
    root,
    sky: sky < 0 ? NONE : sky,
    firstOf,
  };
}

const SKY_LIGHT: LightRecord = { type: LIGHT_TYPES.sky, a: 0, b: 0, slots: [], bounds: null };
