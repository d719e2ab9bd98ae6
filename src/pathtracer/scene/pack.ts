/**
 * A document as the path tracer's kernel reads it: one array of words, laid out as docs/decisions/path-tracer.md says.
 *
 * What is large (meshes, texels, measurements, the sky's image) comes first, in parts that are kept from one packing
 * to the next; what an edit of a material, a light or a transform changes comes behind it and is written anew.
 */
import { type Model, multipleScatteringModel } from '../../glsl/model.ts';
import type { AssetLoader } from '../../scene/assets.ts';
import { environmentScale } from '../../scene/environment-map.ts';
import { findModel } from '../../scene/models.ts';
import type { Document, SceneObject } from '../../scene/schema.ts';
import { SUN_ANGULAR_RADIUS } from '../../scene/sky/atmosphere.ts';
import { LIMB_POWERS, sunOf } from '../../scene/sky/sun.ts';
import { PathTracerError } from './error.ts';
import { GenericTables } from './generic-table.ts';
import { writeGround } from './ground.ts';
import { type Placement, placementOf, rowsOf, worldBox, writeInstanceTree } from './instances.ts';
import {
  HEADER,
  HEADER_SLOTS,
  INSTANCE,
  INSTANCE_FLAGS,
  INSTANCE_SLOTS,
  MATERIAL_SLOTS,
  NONE,
  WORDS_PER_SLOT,
} from './layout.ts';
import { writeLights } from './light-list.ts';
import { tabulatedMaterial, type UsedMaterial, writeMaterials } from './materials.ts';
import { type PackedMesh, placeMesh } from './mesh.ts';
import { Meshes } from './meshes.ts';
import { Pace } from './pace.ts';
import { Places } from './places.ts';
import type { Instance, Scene } from './scene.ts';
import { SkyMaps, skyDistribution, uniformSky, writeSky } from './sky.ts';
import { srgbTable } from './srgb.ts';
import { Images, TextureTable } from './textures.ts';
import { Words } from './words.ts';

export interface PackedScene {
  /** The whole memory with its header; the slots that are written for each rendering are zero. */
  readonly words: Uint32Array<ArrayBuffer>;
  /** By the number that materials have for their model. */
  readonly models: readonly Model[];
  /** Of all instances together. */
  readonly triangles: number;
  /** Finite and infinite ones. */
  readonly lights: number;
  /** Entries that a traversal of both trees can have on its stack at most. */
  readonly stack: number;
}

export interface PackOptions {
  signal?: AbortSignal;
  /** Called with 0 to 1. */
  onProgress?(part: number): void;
  /** The most bytes that the memory may have, such as a GPU's limit of a binding. */
  maxBytes?: number;
}

/** What WebAssembly can address. */
const MAX_BYTES = 2 ** 32;
/** The part of the progress that is the meshes'. */
const MESHES_PART = 0.85;

export class ScenePacker {
  readonly #meshes: Meshes;
  readonly #images: Images;
  readonly #skies: SkyMaps;
  readonly #tables = new GenericTables();

  constructor(assets: AssetLoader) {
    this.#meshes = new Meshes(assets);
    this.#images = new Images(assets);
    this.#skies = new SkyMaps(assets);
  }

  /**
   * @throws AbortError by the signal
   * @throws PathTracerError that names the object and what is wrong, or the memory that would be needed and the limit
   */
  async pack(document: Document, options: PackOptions = {}): Promise<PackedScene> {
    const pace = new Pace(options.signal);
    try {
      return await this.#pack(document, options, pace);
    } finally {
      pace.end();
    }
  }

  dispose(): void {
    this.#meshes.clear();
  }

  async #pack(
    document: Document,
    { signal, onProgress, maxBytes = MAX_BYTES }: PackOptions,
    pace: Pace,
  ): Promise<PackedScene> {
    const { objects, placements } = visibleObjects(document);
    const meshes = await this.#meshes.get(objects, document, maxBytes, pace, (part) =>
      onProgress?.(MESHES_PART * part),
    );
    const { materials, models, indexOf } = usedMaterials(document, objects);
    const instances = objects
      .map((object, i): Instance => {
        const material = indexOf.get(object.material) ?? 0;
        return { object, placement: placements[i]!, mesh: meshes[i]!, material };
      })
      .filter(({ mesh }) => mesh.bounds !== null);
    const textures = await TextureTable.load(
      document,
      materials.map(({ material }) => material),
      this.#images,
    );
    const tables = await this.#tables.get(
      materials.map((used) => tabulatedMaterial(used, textures)),
      pace,
    );
    const map = await this.#skies.get(document);
    signal?.throwIfAborted();
    const distribution = await skyDistribution(
      map,
      environmentScale(document.environment),
      uniformSky(document),
      pace,
    );
    const scene: Scene = { document, instances, materials, models, textures, tables, map, distribution };
    const packed = await assemble(scene, maxBytes, pace);
    onProgress?.(1);
    return packed;
  }
}

function visibleObjects({ objects }: Document): { objects: SceneObject[]; placements: Placement[] } {
  const found = Object.values(objects).flatMap((object) => {
    const placement = object.visible ? placementOf(object) : null;
    return placement === null ? [] : [{ object, placement }];
  });
  return {
    objects: found.map(({ object }) => object),
    placements: found.map(({ placement }) => placement),
  };
}

function usedMaterials(
  document: Document,
  objects: readonly SceneObject[],
): { materials: UsedMaterial[]; models: Model[]; indexOf: Map<string, number> } {
  const materials: UsedMaterial[] = [];
  const models: Model[] = [];
  const indexOf = new Map<string, number>();
  for (const { name, material: id } of objects) {
    if (indexOf.has(id)) continue;
    const material = document.materials[id];
    const found = material && findModel(document, material.model);
    const model = found && material.multipleScattering ? multipleScatteringModel(found) : found;
    if (material === undefined || model === undefined)
      throw new PathTracerError(`object "${name}": its material or that one's model is not there`);
    let modelIndex = models.indexOf(model);
    if (modelIndex < 0) modelIndex = models.push(model) - 1;
    indexOf.set(id, materials.length);
    materials.push({ material, model, modelIndex });
  }
  return { materials, models, indexOf };
}

async function assemble(scene: Scene, maxBytes: number, pace: Pace): Promise<PackedScene> {
  const { document, instances, materials, models, textures, tables, map, distribution } = scene;
  const places = new Places();
  const meshWords = new Map<PackedMesh, number>();
  for (const { mesh } of instances) {
    if (meshWords.has(mesh)) continue;
    const place = (memory: Uint32Array<ArrayBuffer>, at: number) =>
      placeMesh(memory, at / WORDS_PER_SLOT, mesh);
    meshWords.set(mesh, places.reserve(mesh.words.length, place));
  }
  const imageWords = new Map(textures.images.map((texels) => [texels, places.bytes(texels.bytes)]));
  const dataWords = models.map(({ data }) => (data === null ? 0 : places.floats(data)));
  const tableWords = new Map(
    [...new Set(tables)].map((table) => [
      table,
      table === null ? 0 : places.reserve(table.length, (memory, at) => memory.set(table, at)),
    ]),
  );
  const hasSky = distribution.integral > 0;
  const skyPlaces = {
    texels: map === null || !hasSky ? 0 : places.floats(map.texels),
    marginal: hasSky ? places.floats(distribution.marginal) : 0,
    conditional: hasSky ? places.floats(distribution.conditional) : 0,
    level: hasSky ? places.floats(distribution.level) : 0,
  };
  const table = places.floats(Float32Array.from(srgbTable));

  const header = new Words();
  header.allocate(HEADER_SLOTS);
  const words = new Words(places.words);
  const materialSlot = writeMaterials(
    words,
    materials,
    textures,
    (texels) => imageWords.get(texels) ?? 0,
    tables.map((table) => (tableWords.get(table) ?? 0) / WORDS_PER_SLOT),
  );
  const lights = await writeLights(words, scene, pace);
  const instanceSlot = writeInstances(words, instances, meshWords, materialSlot, lights.firstOf);
  const boxes = instances.flatMap(({ mesh, placement }) => worldBox(mesh.bounds!, placement.toWorld));
  const tree = await writeInstanceTree(words, boxes, pace);
  const sky = hasSky ? writeSky(words, document, map, distribution, skyPlaces) : 0;
  const modelSlot = words.allocate(models.length);
  for (const [i, { data }] of models.entries())
    words.setUints(modelSlot + i, dataWords[i]!, (data?.length ?? 0) / 3);

  header.setUints(HEADER.instances, tree.root, instanceSlot, materialSlot, instances.length);
  header.setUints(HEADER.lights, lights.slot, lights.root, lights.finite, table);
  header.setUints(HEADER.infiniteLights, lights.infiniteSlot, lights.infinite, sky, lights.sky);
  header.setUints(HEADER.models, modelSlot, lights.rectangles, lights.lamps);
  writeSurroundings(header, document, boxes);
  writeGround(header, scene, boxes, skyPlaces.level);

  const length = places.words + words.length;
  if (4 * length > maxBytes)
    throw new PathTracerError(`the scene takes ${4 * length} bytes of memory; the limit is ${maxBytes}`);
  const memory = new Uint32Array(length);
  memory.set(header.words);
  places.write(memory);
  memory.set(words.words, places.words);
  return {
    words: memory,
    models,
    triangles: instances.reduce((sum, { mesh }) => sum + mesh.triangles, 0),
    lights: lights.finite + lights.infinite,
    stack: tree.stack + Math.max(0, ...instances.map(({ mesh }) => mesh.stack)),
  };
}

function writeInstances(
  words: Words,
  instances: readonly Instance[],
  meshWords: ReadonlyMap<PackedMesh, number>,
  materialSlot: number,
  firstLights: readonly number[],
): number {
  const first = words.allocate(instances.length * INSTANCE_SLOTS);
  for (const [i, { mesh, placement, material }] of instances.entries()) {
    const slot = first + i * INSTANCE_SLOTS;
    words.setFloats(slot + INSTANCE.toObject, ...rowsOf(placement.toObject));
    words.setFloats(slot + INSTANCE.toWorld, ...rowsOf(placement.toWorld));
    words.setUints(
      slot + INSTANCE.references,
      (meshWords.get(mesh) ?? 0) / WORDS_PER_SLOT,
      materialSlot + material * MATERIAL_SLOTS,
      placement.mirrors ? INSTANCE_FLAGS.mirrors : 0,
      firstLights[i] ?? NONE,
    );
  }
  return first;
}

/** Background, the sun's disc, the sky's even part, fog and the sphere around the objects, whose radius is 0 where there are none. */
function writeSurroundings(header: Words, document: Document, boxes: readonly number[]): void {
  const { background } = document;
  if (background.type === 'color') header.setFloats(HEADER.background, ...background.color);
  else if (background.type === 'environment') header.setFloats(HEADER.background, 0, 0, 0, 1);
  const sun = sunOf(document.environment);
  if (sun !== null && Math.max(...sun.luminance) > 0) {
    header.setFloats(HEADER.sunDirection, ...sun.direction, Math.sin(SUN_ANGULAR_RADIUS));
    header.setFloats(HEADER.sunLuminance, ...sun.luminance);
    header.setFloats(HEADER.sunLimb, ...LIMB_POWERS);
  }
  const { upper, lower } = uniformSky(document);
  header.setFloats(HEADER.upperSky, ...upper);
  header.setFloats(HEADER.lowerSky, ...lower);
  const { density, color, anisotropy, height, base } = document.fog;
  header.setFloats(HEADER.fog, density, anisotropy, height, base);
  header.setFloats(HEADER.fogAlbedo, ...color);
  if (boxes.length === 0) return;
  const low = [0, 1, 2].map(() => Number.POSITIVE_INFINITY);
  const high = [0, 1, 2].map(() => Number.NEGATIVE_INFINITY);
  for (const [i, value] of boxes.entries()) {
    const axis = i % 3;
    if (i % 6 < 3) low[axis] = Math.min(low[axis]!, value);
    else high[axis] = Math.max(high[axis]!, value);
  }
  const centre = low.map((value, axis) => (value + high[axis]!) / 2);
  const radius = Math.hypot(...low.map((value, axis) => high[axis]! - value)) / 2;
  header.setFloats(HEADER.boundingSphere, ...centre, radius);
}
