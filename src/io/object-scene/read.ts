/**
 * A three.js scene file as a GLB of its geometries and images, with materials, lights and a camera of a document. Its nodes
 * are in one another as its objects are, but every mesh says where in the world it stands.
 */
import * as THREE from 'three/webgpu';
import { schemaIssues } from '../../scene/error.ts';
import type { Primitive } from '../../scene/mirror/geometry.ts';
import type { Camera } from '../../scene/schema.ts';
import type { Notes } from '../gltf/notes.ts';
import { GltfWriter, type Json } from '../gltf/writer.ts';
import type { Companions } from '../meshes/companions.ts';
import type { Converted } from '../meshes/converted.ts';
import { ModelFileError } from '../meshes/error.ts';
import { writeAttributes } from '../meshes/mesh.ts';
import { TextureWriter } from '../meshes/textures.ts';
import { geometryName, readGeometry, type SourceGeometry } from './geometry.ts';
import { sceneCamera, sceneLight } from './lights.ts';
import { sceneMaterial } from './material.ts';
import { ownPrimitive } from './primitives.ts';
import { isEditorProject, objectSchema, type SourceObject, type SourceScene, sceneSchema } from './schema.ts';
import { SceneTextures } from './textures.ts';

/** A document's objects end there. */
const MOST_OBJECTS = 20_000;

/** @throws ModelFileError with the path of the field that is wrong */
export function readObjectScene(
  json: unknown,
  file: string,
  companions: Companions,
  notes: Notes,
): Converted {
  const scene = parse(json, file);
  const writer = new GltfWriter();
  const textures = new SceneTextures(scene, new TextureWriter(writer, companions, notes), notes);
  const converted: Converted = {
    glb: new Uint8Array(0),
    materials: [],
    lights: [],
    primitives: [],
    camera: null,
  };
  const geometries = new Map(scene.geometries.map((entry, index) => [entry.uuid, { entry, index }]));
  const made = new Map<string, Written>();
  const shapes = new Map<SourceScene['geometries'][number], Primitive | null>();
  const shapeOf = (entry: SourceScene['geometries'][number]): Primitive | null => {
    const shape = shapes.get(entry) ?? ownPrimitive(entry);
    shapes.set(entry, shape);
    return shape;
  };
  const sources = new Map(scene.materials.map((material, index) => [material.uuid, { material, index }]));
  const materialIndices = new Map<string, number>();
  const materialOf = (uuid: string | undefined): number | undefined => {
    const source = sources.get(uuid ?? '');
    if (uuid === undefined || source === undefined) return undefined;
    const known = materialIndices.get(uuid);
    if (known !== undefined) return known;
    const material = sceneMaterial(source.material, source.index, textures, notes);
    if (source.material.vertexColors === true || source.material.vertexColors === 2)
      notes.add(`${material.name}: its vertex colours are not read`);
    const index = converted.materials.push(material) - 1;
    writer.add('materials', { name: material.name });
    materialIndices.set(uuid, index);
    return index;
  };

  const places = placesOf(scene, file);
  const byUuid = new Map(places.map((place) => [place.object.uuid, place.world]));
  if (scene.object.background || scene.object.environment || scene.object.fog)
    notes.add('its background, environment and fog are not read: the scene has its own');
  const tree = new NodeTree(writer, places);
  let objects = 0;
  for (const [index, place] of places.entries()) {
    const { object, world, visible } = place;
    const light = sceneLight(object, world, byUuid.get(object.target));
    if (light)
      converted.lights.push({ light: { ...light, visible }, node: tree.add(index, { name: light.name }) });
    converted.camera ??= sceneCamera(object, world);
    if (/^(Line|Points|Sprite)/.test(object.type))
      notes.add('its lines, points and sprites have no surface and are left out');
    else if (/Camera$/.test(object.type) && object.type !== 'PerspectiveCamera')
      notes.add(`a camera of type ${object.type} is left out`);
    if (object.geometry === undefined || !/Mesh$/.test(object.type)) continue;
    const geometry = geometries.get(object.geometry);
    if (geometry === undefined)
      throw new ModelFileError(file, place.path, `there is no geometry ${object.geometry.slice(0, 80)}`);
    const materials = [object.material ?? []].flat().map(materialOf);
    // Several materials are those of its sides, which a document's primitive has not.
    const shape = materials.length > 1 ? null : shapeOf(geometry.entry);
    let mesh: number | undefined;
    if (shape === null) {
      let written = made.get(object.geometry);
      if (written === undefined) {
        const data = readGeometry(geometry.entry, geometry.index, scene.shapes, file);
        written = { data, meshes: new Map(), attributes: writeAttributes(writer, data) };
        made.set(object.geometry, written);
      }
      mesh = writeMesh(writer, written, materials);
      noteLosses(object, written.data, notes);
    } else
      noteLosses(object, { name: geometryName(geometry.entry), hasColors: false, hasMorphs: false }, notes);
    for (const matrix of instancesOf(object, world)) {
      objects += 1;
      if (objects > MOST_OBJECTS)
        throw new ModelFileError(file, place.path, `more than ${MOST_OBJECTS} objects`);
      const node = tree.add(index, {
        ...(object.name && { name: object.name }),
        ...(mesh !== undefined && { mesh }),
        matrix: matrix.toArray(),
        ...(!visible && { extensions: { KHR_node_visibility: { visible: false } } }),
      });
      if (shape !== null)
        converted.primitives.push({
          name: geometryName(geometry.entry),
          shape,
          material: materials[0],
          node,
        });
    }
  }
  converted.camera ??= editorCamera(json);
  if (isEditorProject(json)) noteProject(json, notes);
  tree.finish();
  converted.glb = writer.finish();
  return converted;
}

/** The nodes of meshes and lights, in one another as the file's objects are. Objects with nothing in them have none. */
class NodeTree {
  readonly #writer: GltfWriter;
  readonly #places: readonly Place[];
  /** What each object has, itself and from below. */
  readonly #inside: { node: Json; index: number }[][];

  constructor(writer: GltfWriter, places: readonly Place[]) {
    this.#writer = writer;
    this.#places = places;
    this.#inside = places.map(() => []);
  }

  /** Returns the node's index. */
  add(place: number, node: Json): number {
    const index = this.#writer.add('nodes', node);
    this.#inside[place]?.push({ node, index });
    return index;
  }

  finish(): void {
    const handed = this.#places.map((): { node: Json; index: number }[] => []);
    for (const [i, { object, parent }] of [...this.#places.entries()].reverse()) {
      // Those of the last child came first.
      const all = [...(this.#inside[i] ?? []), ...(handed[i] ?? []).reverse()];
      const [only] = all;
      if (parent === null) {
        // A scene is the file itself.
        const roots = object.type !== 'Scene' && all.length > 1 ? [this.#around(object, all)] : all;
        if (only && all.length === 1) nameAfter(only.node, object);
        this.#writer.set('scenes', [{ nodes: roots.map(({ index }) => index) }]);
        continue;
      }
      const above = handed[parent];
      if (only && all.length === 1) nameAfter(only.node, object);
      // What hangs on bones is not in groups of them.
      if (all.length > 1 && object.type !== 'Bone') above?.push(this.#around(object, all));
      else above?.push(...all.reverse());
    }
  }

  #around({ name }: SourceObject, all: readonly { index: number }[]): { node: Json; index: number } {
    const node: Json = { ...(name && { name }), children: all.map(({ index }) => index) };
    return { node, index: this.#writer.add('nodes', node) };
  }
}

/** What is alone in an object, and has no name, has the object's. */
function nameAfter(node: Json, { name, type }: SourceObject): void {
  if (node.name === undefined && name && type !== 'Scene') node.name = name;
}

function parse(json: unknown, file: string): SourceScene {
  const { metadata } = json as { metadata?: { type?: unknown } };
  let whole: unknown = json;
  // A geometry alone becomes a mesh of it.
  if (isEditorProject(json)) whole = json.scene;
  else if (metadata?.type === 'BufferGeometry')
    whole = {
      geometries: [{ uuid: 'geometry', ...(json as object) }],
      object: { type: 'Mesh', name: 'Mesh', geometry: (json as { uuid?: string }).uuid ?? 'geometry' },
    };
  else if (metadata?.type === 'Geometry' || metadata?.type === 'Scene')
    throw new ModelFileError(
      file,
      'metadata',
      'a format of three.js before 2015, which three.js itself no longer reads; open and save it with an old version',
    );
  const result = sceneSchema.safeParse(whole);
  if (result.success) return result.data;
  const [issue] = schemaIssues(result.error);
  throw new ModelFileError(file, issue?.path ?? '', `not a scene of three.js: ${issue?.message}`);
}

/** A project of three.js's editor has the camera that its author last looked through beside the scene. */
function editorCamera(json: unknown): Camera | null {
  const camera = isEditorProject(json) ? (json.camera as { object?: unknown } | null) : null;
  const result = objectSchema.safeParse(camera?.object);
  if (!result.success) return null;
  const world = localMatrix(result.data);
  return world.elements.every(Number.isFinite) ? sceneCamera(result.data, world) : null;
}

/** Nothing that a file brings is run. */
function noteProject({ scripts, environment, project }: Record<string, unknown>, notes: Notes): void {
  const count = Object.values(scripts ?? {}).reduce(
    (sum: number, list: unknown) => sum + (Array.isArray(list) ? list.length : 0),
    0,
  );
  if (count > 0) notes.add(`its scripts (${count}) are left out: nothing in a file is run`);
  const hasEnvironment = typeof environment === 'string' && environment !== 'None';
  if (hasEnvironment || project)
    notes.add("the project's environment, shadows and tone mapping are not read");
}

interface Place {
  object: SourceObject;
  /** Its place in the list; null for the root. */
  parent: number | null;
  world: THREE.Matrix4;
  visible: boolean;
  path: string;
}

/** Every object with its world matrix, parents first. Without recursion: the depth is the file's. */
function placesOf(scene: SourceScene, file: string): Place[] {
  const places: Place[] = [];
  interface Pending {
    value: unknown;
    parent: number | null;
    around: THREE.Matrix4;
    visible: boolean;
    path: string;
  }
  const root = { value: scene.object as unknown, parent: null, around: new THREE.Matrix4(), visible: true };
  const pending: Pending[] = [{ ...root, path: 'object' }];
  for (let next = pending.pop(); next !== undefined; next = pending.pop()) {
    const { value, parent, around, path } = next;
    const result = objectSchema.safeParse(value);
    if (!result.success) {
      const [issue] = schemaIssues(result.error);
      throw new ModelFileError(file, `${path}.${issue?.path}`, `${issue?.message}`);
    }
    const object = result.data;
    const world = localMatrix(object).premultiply(around);
    if (!world.elements.every(Number.isFinite))
      throw new ModelFileError(file, path, 'its place is not made of finite numbers');
    const visible = next.visible && object.visible;
    const index = places.push({ object, parent, world, visible, path }) - 1;
    const below = { parent: index, around: world, visible };
    for (let i = object.children.length - 1; i >= 0; i--)
      pending.push({ ...below, value: object.children[i], path: `${path}.children[${i}]` });
  }
  return places;
}

function localMatrix({ matrix, position, rotation, quaternion, scale }: SourceObject): THREE.Matrix4 {
  if (matrix !== undefined) return new THREE.Matrix4().fromArray(matrix);
  const turn = new THREE.Quaternion();
  if (quaternion !== undefined) turn.set(...quaternion).normalize();
  else if (rotation !== undefined)
    turn.setFromEuler(
      new THREE.Euler(Number(rotation[0]) || 0, Number(rotation[1]) || 0, Number(rotation[2]) || 0),
    );
  return new THREE.Matrix4().compose(
    new THREE.Vector3(...(position ?? [0, 0, 0])),
    turn,
    new THREE.Vector3(...(scale ?? [1, 1, 1])),
  );
}

function instancesOf(object: SourceObject, world: THREE.Matrix4): THREE.Matrix4[] {
  const { type, instanceMatrix } = object;
  if (type !== 'InstancedMesh' || !instanceMatrix) return [world];
  const count = Math.min(
    object.count ?? Number.POSITIVE_INFINITY,
    Math.floor(instanceMatrix.array.length / 16),
  );
  return Array.from({ length: Math.min(count, MOST_OBJECTS + 1) }, (_, i) =>
    new THREE.Matrix4().fromArray(instanceMatrix.array, 16 * i).premultiply(world),
  );
}

function noteLosses(
  { name, type, instanceColor }: SourceObject,
  data: Pick<SourceGeometry, 'name' | 'hasColors' | 'hasMorphs'>,
  notes: Notes,
): void {
  const called = name || data.name || 'a mesh';
  if (data.hasColors) notes.add(`${called}: its vertex colours are not read`);
  if (data.hasMorphs) notes.add(`${called}: its morph targets are not read`);
  if (type === 'SkinnedMesh') notes.add(`${called}: its skeleton is not read; it is shown in its bind pose`);
  if (instanceColor) notes.add(`${called}: the colours of its instances are not read`);
  if (type === 'BatchedMesh') notes.add(`${called}: a BatchedMesh is shown as one mesh where it lies`);
}

interface Written {
  data: SourceGeometry;
  attributes: ReturnType<typeof writeAttributes>;
  /** By the materials that they have. */
  meshes: Map<string, number>;
}

/** The same geometry with the same materials is one mesh. */
function writeMesh(writer: GltfWriter, written: Written, materials: readonly (number | undefined)[]): number {
  const key = JSON.stringify(materials.map((material) => material ?? null));
  const known = written.meshes.get(key);
  if (known !== undefined) return known;
  const { data, attributes } = written;
  const vertices = data.positions.length / 3;
  const all =
    data.indices ??
    (data.groups.length > 0 ? Uint32Array.from({ length: vertices }, (_, i) => i) : undefined);
  const whole = [{ start: 0, count: all?.length ?? vertices, materialIndex: 0 }];
  // Groups say which material covers what, and with one material nothing.
  const groups = materials.length > 1 && data.groups.length > 0 ? data.groups : whole;
  const primitives = groups
    .filter(({ count }) => count >= 3)
    .map(({ start, count, materialIndex }) => {
      const material = materials[materialIndex];
      return {
        attributes,
        ...(all && { indices: writer.indices(all.slice(start, start + count), vertices) }),
        ...(material !== undefined && { material }),
      };
    });
  if (primitives.length === 0) primitives.push({ attributes });
  const mesh = writer.add('meshes', { name: data.name, primitives });
  written.meshes.set(key, mesh);
  return mesh;
}
