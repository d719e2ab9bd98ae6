/** EXT_mesh_gpu_instancing: where the copies of a node's mesh stand. */
import * as THREE from 'three/webgpu';
import { z } from 'zod';
import { GltfError } from './error.ts';
import type { GltfFile } from './file.ts';

const schema = z.looseObject({ attributes: z.record(z.string(), z.int().min(0)) });
/** glTF 2.0, 3.6.2.2: the numbers of each component type, and what a normalised one is divided by. */
const types = {
  5120: { array: Int8Array, most: 127 },
  5121: { array: Uint8Array, most: 255 },
  5122: { array: Int16Array, most: 32_767 },
  5123: { array: Uint16Array, most: 65_535 },
  5125: { array: Uint32Array, most: 4_294_967_295 },
  5126: { array: Float32Array, most: 1 },
} as const;
const sizes = { VEC3: 3, VEC4: 4 } as const;

/** More objects are in no document. */
export const MOST_INSTANCES = 20_000;

/** Null for a node without them, and 'packed' where they are compressed. @throws GltfError */
export function instancesOf(
  { json, binary, name }: GltfFile,
  index: number,
): readonly THREE.Matrix4[] | 'packed' | null {
  const result = schema.safeParse(json.nodes[index]?.extensions?.EXT_mesh_gpu_instancing);
  if (!result.success) return null;
  const path = `nodes[${index}].extensions.EXT_mesh_gpu_instancing`;
  const { TRANSLATION, ROTATION, SCALE } = result.data.attributes;
  const read = (at: number | undefined, type: keyof typeof sizes): Float32Array | 'packed' | null => {
    if (at === undefined) return null;
    const accessor = json.accessors[at];
    if (accessor?.type !== type) throw new GltfError(name, `${path}: accessors[${at}] is not a ${type}`);
    if (accessor.count > MOST_INSTANCES)
      throw new GltfError(name, `${path}: ${accessor.count} instances; at most ${MOST_INSTANCES}`);
    const size = sizes[type];
    const values = new Float32Array(accessor.count * size);
    const view = json.bufferViews[accessor.bufferView ?? -1];
    if (view?.extensions || accessor.sparse) return 'packed';
    if (view === undefined) return values;
    const { array, most } = types[accessor.componentType];
    const stride = view.byteStride ?? size * array.BYTES_PER_ELEMENT;
    const scale = accessor.normalized === true ? most : 1;
    for (let i = 0; i < accessor.count; i++) {
      const from = view.byteOffset + accessor.byteOffset + i * stride;
      // A copy: what is in the file may lie anywhere.
      const element = new array(binary.slice(from, from + size * array.BYTES_PER_ELEMENT).buffer);
      for (let c = 0; c < size; c++) values[size * i + c] = element[c]! / scale;
    }
    return values;
  };
  const [places, turns, scales] = [read(TRANSLATION, 'VEC3'), read(ROTATION, 'VEC4'), read(SCALE, 'VEC3')];
  if (places === 'packed' || turns === 'packed' || scales === 'packed') return 'packed';
  const counts = [places && places.length / 3, turns && turns.length / 4, scales && scales.length / 3];
  const count = Math.max(...counts.map((one) => one ?? 0));
  if (counts.some((one) => one !== null && one !== count))
    throw new GltfError(name, `${path}: its attributes are not equally many`);
  const matrices = Array.from({ length: count }, (_, i) =>
    new THREE.Matrix4().compose(
      new THREE.Vector3(...(places?.subarray(3 * i, 3 * i + 3) ?? [0, 0, 0])),
      new THREE.Quaternion(...(turns?.subarray(4 * i, 4 * i + 4) ?? [0, 0, 0, 1])).normalize(),
      new THREE.Vector3(...(scales?.subarray(3 * i, 3 * i + 3) ?? [1, 1, 1])),
    ),
  );
  if (!matrices.every(({ elements }) => elements.every(Number.isFinite)))
    throw new GltfError(name, `${path}: its places are not made of finite numbers`);
  return matrices;
}
