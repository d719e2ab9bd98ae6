/** The nodes of a glTF scene as objects, lights, groups and a camera of a document, in world space. */
import * as THREE from 'three/webgpu';
import { memberDefaults } from '../../scene/group-schema.ts';
import { lightDefaults } from '../../scene/light-schema.ts';
import type { Primitive } from '../../scene/mirror/geometry.ts';
import type { Camera, Light, SceneObject } from '../../scene/schema.ts';
import { cameraDefaults } from '../../scene/stage-schema.ts';
import { GltfError } from './error.ts';
import type { GltfFile } from './file.ts';
import { groupNodes, type ImportedGroup, type TreeNode } from './groups.ts';
import { instancesOf, MOST_INSTANCES } from './instances.ts';
import type { Notes } from './notes.ts';
import { type Gltf, type GltfNode, isGroupOfOurs, isSceneOfOurs, isSurface, lightsSchema } from './schema.ts';

export interface GltfObject {
  object: Omit<SceneObject, 'material' | 'geometry'>;
  node: number;
  primitive: number;
  /** What it is instead of a primitive of the file. */
  shape: Primitive | null;
  material: number | undefined;
  /** Its group's place in the list. */
  group: number | null;
}

export interface GltfLight {
  light: Light;
  group: number | null;
}

export interface GltfContents {
  objects: GltfObject[];
  lights: GltfLight[];
  groups: ImportedGroup[];
  camera: Camera | null;
}

/** A light of a file that says its lights better than glTF does, at the node that stands for it. */
export interface NodeLight {
  light: Light;
  node: number;
}

/** An object with a shape that the document has itself, at the node that stands for it. */
export interface NodePrimitive {
  /** Where neither the node nor what is around it has a name. */
  name: string;
  shape: Primitive;
  /** By the number that it has among the file's. */
  material: number | undefined;
  node: number;
}

type Vector = [number, number, number];

/** @param own what there is beside the glTF's own lights and meshes */
export function convertNodes(
  source: GltfFile,
  file: string,
  notes: Notes,
  own: { lights: readonly NodeLight[]; primitives: readonly NodePrimitive[] } = {
    lights: [],
    primitives: [],
  },
): GltfContents {
  const gltf = source.json;
  const objects: Omit<GltfObject, 'group'>[] = [];
  const lights: NodeLight[] = [];
  let camera: Camera | null = null;
  const punctuals = lightsSchema.safeParse(gltf.extensions?.KHR_lights_punctual).data?.lights ?? [];
  const lightsAt = byNode(own.lights);
  const primitivesAt = byNode(own.primitives);
  const joints = new Set(gltf.skins.flatMap((skin) => skin.joints));
  const tree: TreeNode[] = [];
  const places = new Map<number, number>();
  for (const { index, node, world, visible, parent, name } of walk(gltf)) {
    const before = objects.length + lights.length;
    const instances = node.mesh === undefined ? null : instancesOf(source, index);
    if (instances === 'packed')
      notes.add(`${nameOf(node, index)}: its instances are compressed; only one of them is shown`);
    const copies = instances === null || instances === 'packed' ? [new THREE.Matrix4()] : instances;
    for (const own of copies)
      objects.push(...surfacesOf(gltf, index, node, name, own.clone().premultiply(world), visible, notes));
    if (objects.length > MOST_INSTANCES)
      throw new GltfError(file, `nodes[${index}]: more than ${MOST_INSTANCES} objects`);
    const punctual = node.extensions?.KHR_lights_punctual as { light?: unknown } | undefined;
    const light = typeof punctual?.light === 'number' ? punctuals[punctual.light] : undefined;
    if (light !== undefined)
      lights.push({ light: { ...convertLight(light, name, world), visible }, node: index });
    lights.push(...(lightsAt.get(index) ?? []));
    for (const { name: kind, shape, material } of primitivesAt.get(index) ?? []) {
      const called = (name || kind).slice(0, 180);
      const object = { name: called, visible, ...memberDefaults, ...decompose(world, called, notes) };
      objects.push({ object, node: index, primitive: 0, shape, material });
    }
    if (node.camera !== undefined && camera === null)
      camera = convertCamera(gltf.cameras[node.camera], world, notes);
    const group = isGroupOfOurs(node) ? 'always' : joints.has(index) ? 'never' : 'if several';
    const around = parent === null ? null : places.get(parent)!;
    const there = objects.length + lights.length - before;
    places.set(index, tree.push({ name: nameIn(node), parent: around, own: there, group }) - 1);
  }
  const title = file.replace(/\.[A-Za-z0-9]+$/, '').slice(0, 180) || file;
  const { groups, groupOf } = groupNodes(tree, isSceneOfOurs(gltf) ? null : title, notes);
  const at = (node: number) => groupOf[places.get(node)!]!;
  return {
    objects: objects.map((object) => ({ ...object, group: at(object.node) })),
    lights: lights.map(({ light, node }) => ({ light, group: at(node) })),
    groups,
    camera,
  };
}

function byNode<T extends { node: number }>(all: readonly T[]): Map<number, T[]> {
  const found = new Map<number, T[]>();
  for (const one of all) {
    const there = found.get(one.node);
    if (there) there.push(one);
    else found.set(one.node, [one]);
  }
  return found;
}

const nameIn = (node: GltfNode): string => (node.name ?? '').trim().slice(0, 180);

interface Visit {
  index: number;
  node: GltfNode;
  parent: number | null;
  world: THREE.Matrix4;
  visible: boolean;
  /** Its own, or that of the node around it that has nothing else in it; '' where there is none. */
  name: string;
}

/** Every node of the scene with its world matrix, parents first. Without recursion: depth is the file's. */
function* walk(gltf: Gltf): Generator<Visit> {
  const children = new Set(gltf.nodes.flatMap((node) => node.children));
  const roots =
    gltf.scenes[gltf.scene ?? 0]?.nodes ?? [...gltf.nodes.keys()].filter((index) => !children.has(index));
  interface Pending {
    index: number;
    parent: number | null;
    around: THREE.Matrix4;
    shown: boolean;
    spare: string;
  }
  const pending: Pending[] = [...roots]
    .reverse()
    .map((index) => ({ index, parent: null, around: new THREE.Matrix4(), shown: true, spare: '' }));
  const seen = new Set<number>();
  for (let next = pending.pop(); next !== undefined; next = pending.pop()) {
    const { index, parent, around, shown, spare } = next;
    const node = gltf.nodes[index];
    if (node === undefined || seen.has(index)) continue;
    seen.add(index);
    const world = localMatrix(node).premultiply(around);
    // KHR_node_visibility: what is below a hidden node is hidden, too.
    const visibility = node.extensions?.KHR_node_visibility as { visible?: unknown } | undefined;
    const visible = shown && visibility?.visible !== false;
    const name = nameIn(node) || spare;
    yield { index, node, parent, world, visible, name };
    const below = { parent: index, around: world, shown: visible };
    const handed = node.mesh === undefined && node.children.length === 1 ? name : '';
    for (const child of [...node.children].reverse()) pending.push({ ...below, index: child, spare: handed });
  }
}

function localMatrix({ matrix, translation, rotation, scale }: GltfNode): THREE.Matrix4 {
  if (matrix !== undefined) return new THREE.Matrix4().fromArray(matrix);
  return new THREE.Matrix4().compose(
    new THREE.Vector3(...(translation ?? [0, 0, 0])),
    new THREE.Quaternion(...(rotation ?? [0, 0, 0, 1])).normalize(),
    new THREE.Vector3(...(scale ?? [1, 1, 1])),
  );
}

const nameOf = (node: GltfNode, index: number): string =>
  (node.name ?? '').slice(0, 180) || `Node ${index + 1}`;

function surfacesOf(
  gltf: Gltf,
  index: number,
  node: GltfNode,
  called: string,
  world: THREE.Matrix4,
  visible: boolean,
  notes: Notes,
): Omit<GltfObject, 'group'>[] {
  const found: Omit<GltfObject, 'group'>[] = [];
  const mesh = node.mesh === undefined ? undefined : gltf.meshes[node.mesh];
  if (mesh === undefined) return found;
  const name = (called || mesh.name || `Mesh ${index + 1}`).slice(0, 180);
  if (node.skin !== undefined) notes.add(`${name}: its skeleton is not read; it is shown in its bind pose`);
  // 3.7.3.3: the transform of a skinned mesh's node does not count.
  const place =
    node.skin === undefined ? decompose(world, name, notes) : decompose(new THREE.Matrix4(), name, notes);
  for (const [primitive, { mode, material, targets, attributes }] of mesh.primitives.entries()) {
    if (!isSurface(mode)) {
      notes.add(`${name}: points and lines have no surface and are left out`);
      continue;
    }
    if (targets !== undefined && targets.length > 0) notes.add(`${name}: its morph targets are not read`);
    if (attributes.COLOR_0 !== undefined) notes.add(`${name}: its vertex colours are not read`);
    const part = mesh.primitives.length > 1 ? ` ${primitive + 1}` : '';
    found.push({
      object: { name: name + part, visible, ...memberDefaults, ...place },
      node: index,
      primitive,
      shape: null,
      material,
    });
  }
  return found;
}

function decompose(world: THREE.Matrix4, name: string, notes: Notes) {
  const position = new THREE.Vector3();
  const quaternion = new THREE.Quaternion();
  const scale = new THREE.Vector3();
  world.decompose(position, quaternion, scale);
  const again = new THREE.Matrix4().compose(position, quaternion, scale);
  const error = Math.max(...again.elements.map((value, i) => Math.abs(value - (world.elements[i] ?? 0))));
  const size = Math.max(...world.elements.slice(0, 12).map(Math.abs));
  if (error > 1e-3 * size) notes.add(`${name}: it is sheared, which is approximated`);
  const euler = new THREE.Euler().setFromQuaternion(quaternion, 'XYZ');
  const rotation: Vector = [euler.x, euler.y, euler.z].map(THREE.MathUtils.radToDeg) as Vector;
  return { position: position.toArray(), rotation, scale: scale.toArray() };
}

/** Lights and cameras look along their -z; the target is a point on the way. */
function aim(world: THREE.Matrix4, distance: number): { position: Vector; target: Vector } {
  const position = new THREE.Vector3().setFromMatrixPosition(world);
  const direction = new THREE.Vector3(0, 0, -1).transformDirection(world);
  return { position: position.toArray(), target: direction.multiplyScalar(distance).add(position).toArray() };
}

type Punctual = NonNullable<ReturnType<typeof lightsSchema.parse>['lights'][number]>;

/** KHR_lights_punctual: candela for point and spot, lux for directional, as here. */
function convertLight(light: Punctual, called: string, world: THREE.Matrix4): Light {
  const { position, target } = aim(world, 5);
  // Brightness beyond 1 is for the intensity; here a colour is a colour.
  const brightest = Math.max(...light.color, 1);
  const intensity = THREE.MathUtils.clamp(light.intensity * brightest, 0, 1e9);
  const color = light.color.map((value) => THREE.MathUtils.clamp(value / brightest, 0, 1)) as Vector;
  const name = (light.name || called || lightDefaults[light.type].name).slice(0, 180);
  const range = THREE.MathUtils.clamp(light.range ?? 0, 0, 1e6);
  switch (light.type) {
    case 'directional':
      return { ...lightDefaults.directional, name, color, illuminance: intensity, position, target };
    case 'point':
      return { ...lightDefaults.point, name, color, intensity, position, range };
    case 'spot': {
      const inner = light.spot?.innerConeAngle ?? 0;
      const outer = THREE.MathUtils.clamp(light.spot?.outerConeAngle ?? Math.PI / 4, 0.002, Math.PI / 2);
      return {
        ...lightDefaults.spot,
        name,
        color,
        intensity,
        position,
        target,
        range,
        exponent: 0,
        cutoff: THREE.MathUtils.radToDeg(outer),
        penumbra: THREE.MathUtils.clamp(1 - inner / outer, 0, 1),
      };
    }
  }
}

function convertCamera(
  camera: Gltf['cameras'][number] | undefined,
  world: THREE.Matrix4,
  notes: Notes,
): Camera | null {
  const { perspective } = camera ?? {};
  if (perspective === undefined) {
    notes.add('its camera is orthographic and is left out');
    return null;
  }
  const near = THREE.MathUtils.clamp(perspective.znear, 1e-4, 1e4);
  return {
    ...cameraDefaults,
    fov: THREE.MathUtils.clamp(THREE.MathUtils.radToDeg(perspective.yfov), 1, 170),
    ...aim(world, Math.max(5, near * 2)),
    near,
    far: THREE.MathUtils.clamp(perspective.zfar ?? 1000, near * 2, 1e7),
  };
}
