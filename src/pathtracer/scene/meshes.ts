import type { BufferGeometry } from 'three/webgpu';
import type { AssetLoader } from '../../scene/assets.ts';
import { quadCount } from '../../scene/geometry-schema.ts';
import { createPrimitive } from '../../scene/mirror/geometry.ts';
import type { Asset, Document, Geometry, SceneObject } from '../../scene/schema.ts';
import { PathTracerError } from './error.ts';
import { leastMeshBytes, type PackedMesh, packMesh } from './mesh.ts';
import type { Pace } from './pace.ts';

/** A geometry of a scene and the first object that has it, for messages. */
interface Wanted {
  readonly object: SceneObject;
  readonly geometry: BufferGeometry;
}

/** Packed meshes by what they are made of: an edit that leaves a geometry alone finds its mesh here. */
export class Meshes {
  readonly #assets: AssetLoader;
  /** Of primitives, which are made anew whenever they are asked for. */
  #primitives = new Map<string, PackedMesh>();
  /** Of the geometries of files, which the loader keeps. */
  readonly #loaded = new WeakMap<BufferGeometry, PackedMesh>();

  constructor(assets: AssetLoader) {
    this.#assets = assets;
  }

  /**
   * The mesh of each object, in their order.
   *
   * @param onProgress called with 0 to 1
   * @throws PathTracerError if they would take more than `maxBytes`, before that memory is asked for
   */
  async get(
    objects: readonly SceneObject[],
    { assets }: Pick<Document, 'assets'>,
    maxBytes: number,
    pace: Pace,
    onProgress: (part: number) => void,
  ): Promise<PackedMesh[]> {
    const geometries: (BufferGeometry | string)[] = [];
    const missing = new Map<BufferGeometry | string, Wanted>();
    checkPrimitives(objects, maxBytes);
    for (const object of objects) {
      const key = await guarded(object, () => this.#keyOf(object.geometry, assets));
      geometries.push(key);
      if (missing.has(key) || this.#find(key) !== undefined) continue;
      missing.set(key, { object, geometry: typeof key === 'string' ? create(object.geometry) : key });
      if (pace.due) await pace.rest();
    }
    this.#checkSize(geometries, missing, maxBytes);
    let [done, all] = [0, 0];
    for (const { geometry } of missing.values()) all += trianglesOf(geometry);
    for (const [key, { object, geometry }] of missing) {
      const share = trianglesOf(geometry) / Math.max(all, 1);
      const mesh = await guarded(object, () =>
        packMesh(geometry, maxBytes, pace, (part) => onProgress(done + share * part)),
      );
      done += share;
      if (typeof key === 'string') this.#primitives.set(key, mesh);
      else this.#loaded.set(key, mesh);
    }
    const meshes = geometries.map((key) => this.#find(key) as PackedMesh);
    this.#forgetOthers(geometries);
    return meshes;
  }

  clear(): void {
    this.#primitives.clear();
  }

  #find(key: BufferGeometry | string): PackedMesh | undefined {
    return typeof key === 'string' ? this.#primitives.get(key) : this.#loaded.get(key);
  }

  #forgetOthers(used: readonly (BufferGeometry | string)[]): void {
    const keys = new Set(used);
    this.#primitives = new Map([...this.#primitives].filter(([key]) => keys.has(key)));
  }

  /** Loaded geometries are their own keys; primitives have their parameters. */
  async #keyOf(
    geometry: Geometry,
    assets: Readonly<Record<string, Asset>>,
  ): Promise<BufferGeometry | string> {
    if (geometry.type === 'suzanne') return this.#assets.suzanne();
    if (geometry.type !== 'gltf') return JSON.stringify(geometry);
    const asset = assets[geometry.asset];
    if (asset === undefined) throw new PathTracerError('its glTF file is not there');
    return this.#assets.gltfGeometry(asset, geometry.node, geometry.primitive);
  }

  #checkSize(
    keys: readonly (BufferGeometry | string)[],
    missing: ReadonlyMap<BufferGeometry | string, Wanted>,
    maxBytes: number,
  ): void {
    let [bytes, triangles] = [0, 0];
    for (const key of new Set(keys)) {
      const geometry = missing.get(key)?.geometry;
      bytes +=
        geometry === undefined
          ? (this.#find(key)?.words.byteLength ?? 0)
          : leastMeshBytes(trianglesOf(geometry), geometry.getAttribute('position')?.count ?? 0);
      triangles += geometry === undefined ? (this.#find(key)?.triangles ?? 0) : trianglesOf(geometry);
    }
    if (bytes > maxBytes)
      throw new PathTracerError(
        `the scene's ${triangles} triangles take at least ${bytes} bytes of memory; the limit is ${maxBytes}`,
      );
  }
}

/**
 * Refuses primitives that cannot fit before they are made, which takes minutes for what is far too large. Poles and tips
 * have triangles where other quads have two: half of all is a bound from below.
 */
function checkPrimitives(objects: readonly SceneObject[], maxBytes: number): void {
  const primitives = new Map(objects.map(({ geometry }) => [JSON.stringify(geometry), geometry]));
  const quads = [...primitives.values()].reduce((sum, geometry) => sum + quadCount(geometry), 0);
  const bytes = leastMeshBytes(quads, quads / 2);
  if (bytes > maxBytes)
    throw new PathTracerError(
      `the scene's about ${Math.round(2 * quads)} triangles take more than ${Math.round(bytes)} bytes of memory; the limit is ${maxBytes}`,
    );
}

function create(geometry: Geometry): BufferGeometry {
  if (geometry.type === 'suzanne' || geometry.type === 'gltf')
    throw new TypeError(`${geometry.type} is no primitive`);
  return createPrimitive(geometry);
}

function trianglesOf({ index, attributes }: BufferGeometry): number {
  return Math.floor((index?.count ?? attributes.position?.count ?? 0) / 3);
}

/** Says of which object it is that something is wrong with. */
async function guarded<T>({ name }: SceneObject, work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (cause) {
    if (cause instanceof DOMException && cause.name === 'AbortError') throw cause;
    const message = cause instanceof Error ? cause.message : String(cause);
    throw new PathTracerError(`object "${name}": ${message}`, { cause });
  }
}
