import { Euler, MathUtils, Matrix4, Quaternion, Vector3 } from 'three/webgpu';
import type { SceneObject } from '../../scene/schema.ts';
import { buildBinaryTree } from './binary-tree.ts';
import { NODE_SLOTS, NODE_WIDTH } from './layout.ts';
import type { Pace } from './pace.ts';
import { widen, writeNodes } from './wide-tree.ts';
import type { Words } from './words.ts';

export interface Placement {
  readonly toWorld: Matrix4;
  readonly toObject: Matrix4;
  /** The transform turns right hands into left ones. */
  readonly mirrors: boolean;
}

/** What is flattened gets this part of its greatest scale as its thickness: a plane's transform must have an inverse. */
const LEAST_SCALE = 1e-5;
/** What is scaled to less is a point: its transform's inverse would be beyond what a float32 can reckon with. */
const VANISHING = 1e-12;

/** Where an object is; null if it is flattened to a line or a point, of which nothing can be seen. */
export function placementOf({ position, rotation, scale }: SceneObject): Placement | null {
  const greatest = Math.max(...scale.map(Math.abs));
  const least = greatest * LEAST_SCALE;
  if (scale.filter((s) => Math.abs(s) < least).length > 1 || greatest < VANISHING) return null;
  const [x, y, z] = rotation.map(MathUtils.degToRad) as [number, number, number];
  const toWorld = new Matrix4().compose(
    new Vector3(...position),
    new Quaternion().setFromEuler(new Euler(x, y, z, 'XYZ')),
    new Vector3(...scale.map((s) => (Math.abs(s) < least ? (s < 0 ? -least : least) : s))),
  );
  return { toWorld, toObject: toWorld.clone().invert(), mirrors: toWorld.determinant() < 0 };
}

/** The rows of an affine transform, 3 x 4. */
export function rowsOf({ elements: m }: Matrix4): number[] {
  return [0, 1, 2].flatMap((row) => [m[row]!, m[row + 4]!, m[row + 8]!, m[row + 12]!]);
}

/** float32's relative error, several times: of the transform here, and of the ray in the kernel. */
const PADDING = 4 * 2 ** -23;

/** The world's box around a transformed box (J. Arvo, 1990, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems). */
export function worldBox(box: Float32Array, toWorld: Matrix4): number[] {
  const m = toWorld.elements;
  const [low, high] = [[0, 0, 0] as number[], [0, 0, 0] as number[]];
  for (let row = 0; row < 3; row += 1) {
    let [min, max, reach] = [m[row + 12]!, m[row + 12]!, Math.abs(m[row + 12]!)];
    for (let column = 0; column < 3; column += 1) {
      const [a, b] = [m[row + 4 * column]! * box[column]!, m[row + 4 * column]! * box[column + 3]!];
      min += Math.min(a, b);
      max += Math.max(a, b);
      reach += Math.max(Math.abs(a), Math.abs(b));
    }
    low[row] = min - reach * PADDING;
    high[row] = max + reach * PADDING;
  }
  return [...low, ...high];
}

/** Writes the tree over instances' boxes. @returns its root's slot, and the most entries that its stack can have */
export async function writeInstanceTree(
  words: Words,
  boxes: readonly number[],
  pace: Pace,
): Promise<{ root: number; stack: number }> {
  const tree = await buildBinaryTree(Float32Array.from(boxes), 1, pace);
  const wide = widen(tree);
  const nodes = wide.children.length / NODE_WIDTH;
  const root = words.allocate(nodes * NODE_SLOTS);
  const instanceOf = (leaf: number): number => tree.order[tree.first[leaf] as number] as number;
  writeNodes(words.words, words.wordOf(root), root, tree, wide, instanceOf);
  return { root, stack: wide.stack };
}
