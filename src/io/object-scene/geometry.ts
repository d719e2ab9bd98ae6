/** Geometries of a three.js scene file, made by three.js's own loader once they are known to be of a sensible size. */
import * as THREE from 'three/webgpu';
import { ModelFileError } from '../meshes/error.ts';
import type { MeshData } from '../meshes/mesh.ts';
import type { SourceScene } from './schema.ts';

export interface SourceGroup {
  start: number;
  count: number;
  materialIndex: number;
}
export interface SourceGeometry extends MeshData {
  name: string;
  hasColors: boolean;
  hasMorphs: boolean;
  /** Of corners; none where one material covers all. */
  groups: readonly SourceGroup[];
}

type Entry = SourceScene['geometries'][number];

/** three.js's primitives rarely have names, but kinds. */
export const geometryName = ({ name, type }: Entry): string =>
  name || type.replace(/^(Buffer)?(\w*?)Geometry$/, '$2');

/** As many as a document's own primitives may have. */
const MOST_QUADS = 2048 * 2048;

/** What three.js's declarations leave out. */
interface GeometryLoader {
  parseShapes(json: unknown): unknown;
  parseGeometries(json: readonly Entry[], shapes: unknown): Record<string, THREE.BufferGeometry | undefined>;
}

/** @throws ModelFileError naming the geometry */
export function readGeometry(entry: Entry, index: number, shapes: unknown, file: string): SourceGeometry {
  const fail = (message: string): never => {
    throw new ModelFileError(file, `geometries[${index}]`, message);
  };
  checkSize(entry, fail);
  if (entry.type !== 'BufferGeometry' && !(entry.type in THREE))
    fail(`there is no ${entry.type} in three.js`);
  let geometry: THREE.BufferGeometry | undefined;
  try {
    const loader = new THREE.ObjectLoader() as unknown as GeometryLoader;
    const made = loader.parseGeometries([entry], loader.parseShapes(shapes));
    geometry = made[entry.uuid];
  } catch (cause) {
    fail(`${entry.type} cannot be made: ${cause instanceof Error ? cause.message : String(cause)}`);
  }
  if (!geometry) return fail(`there is no ${entry.type} in three.js`);
  const positions = floats(geometry, 'position', 3) ?? fail('it has no positions');
  if (!positions.every(Number.isFinite)) fail('it has positions that are not finite numbers');
  const vertices = positions.length / 3;
  const index32 = geometry.getIndex();
  const indices = index32 ? Uint32Array.from(index32.array) : undefined;
  if (indices?.some((corner) => corner >= vertices)) fail('its index names vertices that are not there');
  const corners = indices?.length ?? vertices;
  return {
    name: geometryName(entry),
    positions,
    normals: floats(geometry, 'normal', 3, vertices),
    uvs: floats(geometry, 'uv', 2, vertices),
    uvs2: floats(geometry, 'uv1', 2, vertices) ?? floats(geometry, 'uv2', 2, vertices),
    indices,
    hasColors: geometry.hasAttribute('color'),
    hasMorphs: Object.keys(geometry.morphAttributes).length > 0,
    groups: geometry.groups.map(({ start, count, materialIndex = 0 }) => ({
      start: Math.min(Math.max(0, start | 0), corners),
      count: Math.min(Number.isFinite(count) ? count : corners, corners - Math.min(start, corners)),
      materialIndex,
    })),
  };
}

function floats(
  geometry: THREE.BufferGeometry,
  name: string,
  size: number,
  count?: number,
): Float32Array | undefined {
  const attribute = geometry.getAttribute(name);
  if (attribute === undefined || attribute.itemSize < size || attribute.count === 0) return undefined;
  if (count !== undefined && attribute.count !== count) return undefined;
  const values = new Float32Array(attribute.count * size);
  for (let i = 0; i < attribute.count; i++)
    for (let c = 0; c < size; c++) values[size * i + c] = attribute.getComponent(i, c);
  return values;
}

/** The parameters of three.js's primitives that say how fine they are. */
function checkSize(entry: Entry, fail: (message: string) => never): void {
  const parts: number[] = [];
  for (const [name, value] of Object.entries(entry)) {
    if (!/segments|detail|steps/i.test(name)) continue;
    if (typeof value !== 'number' || !(value >= 0 && value <= 4096))
      fail(`${name} is not between 0 and 4096`);
    // Each face of a polyhedron becomes (detail + 1)^2.
    parts.push(name === 'detail' ? 5 * (Number(value) + 1) ** 2 : Math.max(1, Number(value)));
  }
  if (parts.reduce((product, part) => product * part, 1) > MOST_QUADS) fail('it has too many segments');
  // Shapes and curves are sampled once for each segment, and the points of a lathe or polyhedron are in the file.
  const attributes = Object.values(entry.data?.attributes ?? {});
  for (const { array, itemSize } of attributes)
    if (array !== undefined && itemSize === undefined)
      fail('an attribute does not say how many values a vertex has');
}
