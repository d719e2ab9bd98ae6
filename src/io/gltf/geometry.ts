/**
 * The geometry of a glTF file's primitives, through three's GLTFLoader: accessors, sparse
 * data, quantisation, Draco and meshopt. Materials, textures and nodes are read elsewhere,
 * so the loader gets a file without them and fetches nothing.
 */

import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import type { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import * as THREE from 'three/webgpu';
import { GltfError } from './error.ts';
import type { GltfFile } from './file.ts';
import { writeGlb } from './glb.ts';
import { isSurface } from './schema.ts';

export type Geometries = (node: number, primitive: number) => Promise<THREE.BufferGeometry>;

export async function openGeometries(file: GltfFile, draco: () => DRACOLoader): Promise<Geometries> {
  const { json, name } = file;
  const loader = new GLTFLoader();
  loader.setMeshoptDecoder(MeshoptDecoder);
  if (json.extensionsUsed.includes('KHR_draco_mesh_compression')) loader.setDRACOLoader(draco());
  const meshes = json.meshes.map((mesh) => ({
    primitives: mesh.primitives.map(({ material: _, ...primitive }) => primitive),
  }));
  const { asset, accessors, buffers, bufferViews, extensionsUsed } = json;
  const bare = {
    asset,
    accessors,
    buffers,
    bufferViews,
    extensionsUsed,
    meshes,
    scenes: [{ nodes: [] }],
    scene: 0,
  };
  const { parser } = await guarded(name, () => loader.parseAsync(writeGlb(bare, file.binary).buffer, ''));

  const done = new Map<string, Promise<THREE.BufferGeometry>>();
  return (node, primitive) => {
    const mesh = json.nodes[node]?.mesh;
    const found = mesh === undefined ? undefined : json.meshes[mesh]?.primitives[primitive];
    if (found === undefined)
      return Promise.reject(new GltfError(name, `nodes[${node}] has no mesh primitive ${primitive}`));
    if (!isSurface(found.mode))
      return Promise.reject(new GltfError(name, `nodes[${node}]: primitive ${primitive} has no triangles`));
    const key = `${mesh} ${primitive}`;
    const geometry =
      done.get(key) ??
      guarded(name, async () => {
        const loaded: THREE.Object3D = await parser.getDependency('mesh', mesh ?? 0);
        const part = json.meshes[mesh ?? 0]?.primitives.length === 1 ? loaded : loaded.children[primitive];
        if (!(part instanceof THREE.Mesh)) throw new Error(`no mesh came of meshes[${mesh}]`);
        return normalized(part.geometry);
      });
    done.set(key, geometry);
    return geometry;
  };
}

/**
 * Plain float attributes, normals where there are none, and v upwards: with v upwards the
 * bitangent of glTF (and of its normal maps) is the direction in which v grows, as it is for
 * three's own primitives.
 */
function normalized(source: THREE.BufferGeometry): THREE.BufferGeometry {
  if (!(source.getAttribute('position')?.count > 0)) throw new Error('a primitive has no positions');
  let geometry = new THREE.BufferGeometry();
  for (const name of ['position', 'normal', 'tangent', 'uv', 'uv1', 'uv2', 'uv3']) {
    const attribute = source.getAttribute(name);
    if (attribute !== undefined) geometry.setAttribute(name, floats(attribute, name.startsWith('uv')));
  }
  // One that is not a number would make the bounds so, and the object could not be drawn or found.
  if (!(geometry.getAttribute('position').array as Float32Array).every(Number.isFinite))
    throw new Error('a primitive has positions that are not finite numbers');
  geometry.setIndex(source.getIndex());
  // glTF 2.0, 3.7.2.1: without normals, faces are flat.
  if (!geometry.hasAttribute('normal')) {
    if (geometry.getIndex() !== null) geometry = geometry.toNonIndexed();
    geometry.computeVertexNormals();
    geometry.deleteAttribute('tangent');
  }
  return geometry;
}

type AnyAttribute = THREE.BufferAttribute | THREE.InterleavedBufferAttribute;

function floats(attribute: AnyAttribute, flipV: boolean): THREE.BufferAttribute {
  const { itemSize, count } = attribute;
  const values = new Float32Array(itemSize * count);
  for (let i = 0; i < count; i += 1)
    for (let c = 0; c < itemSize; c += 1) {
      const value = attribute.getComponent(i, c);
      values[i * itemSize + c] = flipV && c === 1 ? 1 - value : value;
    }
  return new THREE.BufferAttribute(values, itemSize);
}

async function guarded<T>(file: string, work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (cause) {
    if (cause instanceof GltfError) throw cause;
    const message = cause instanceof Error ? cause.message : String(cause);
    throw new GltfError(file, message.replace(/^THREE\.\w+: /, ''), { cause });
  }
}
