/** A document as a GLB: objects, materials, punctual lights, groups and the camera, with notes of what glTF cannot say. */
import * as THREE from 'three/webgpu';
import type { AssetLoader } from '../scene/assets.ts';
import { keyOf } from '../scene/groups.ts';
import { createPrimitive } from '../scene/mirror/geometry.ts';
import type { Document, Geometry } from '../scene/schema.ts';
import { Notes } from './gltf/notes.ts';
import { OUR_SCENE } from './gltf/schema.ts';
import { GltfWriter, type Json } from './gltf/writer.ts';
import { exportGroups, type NodeOf } from './gltf-export/groups.ts';
import { exportCamera, exportLights } from './gltf-export/lights.ts';
import { exportMaterial } from './gltf-export/material.ts';
import { TextureExport } from './gltf-export/textures.ts';
import { type MeshData, writeAttributes } from './meshes/mesh.ts';

export interface GltfExport {
  bytes: Uint8Array<ArrayBuffer>;
  /** What could not be kept. */
  notes: string[];
}

/** @param onProgress how much is done, 0 to 1 */
export async function exportGltf(
  document: Document,
  assets: AssetLoader,
  onProgress: (fraction: number) => void = () => {},
): Promise<GltfExport> {
  const writer = new GltfWriter();
  const notes = new Notes();
  const textures = new TextureExport(document, assets, writer, notes);
  const objects = Object.entries(document.objects);
  const used = new Set(objects.map(([, { material }]) => material));
  const steps = objects.length + used.size;
  let done = 0;
  const materials = new Map<string, number>();
  for (const id of used) {
    const material = document.materials[id];
    if (material) materials.set(id, await exportMaterial(document, material, writer, textures, notes));
    onProgress(++done / steps);
  }
  const geometries = new Map<string, Json>();
  const meshes = new Map<string, number>();
  const nodes: NodeOf = new Map();
  for (const [id, object] of objects) {
    const key = JSON.stringify(object.geometry);
    let primitive = geometries.get(key);
    if (primitive === undefined) {
      primitive = writeGeometry(writer, await geometryOf(object.geometry, document, assets));
      geometries.set(key, primitive);
    }
    const material = materials.get(object.material);
    const meshKey = `${object.material} ${key}`;
    const mesh =
      meshes.get(meshKey) ??
      writer.add('meshes', { primitives: [{ ...primitive, ...(material !== undefined && { material }) }] });
    meshes.set(meshKey, mesh);
    const [x, y, z] = object.rotation.map(THREE.MathUtils.degToRad) as [number, number, number];
    if (!object.visible) writer.use('KHR_node_visibility');
    const node = writer.add('nodes', {
      name: object.name,
      mesh,
      translation: object.position,
      rotation: new THREE.Quaternion().setFromEuler(new THREE.Euler(x, y, z, 'XYZ')).toArray(),
      scale: object.scale,
      ...(!object.visible && { extensions: { KHR_node_visibility: { visible: false } } }),
    });
    nodes.set(keyOf({ kind: 'objects', id }), node);
    onProgress(++done / steps);
  }
  exportLights(document, writer, nodes, notes);
  exportGroups(document, writer, nodes);
  exportCamera(document.camera, writer, notes);
  writer.set('extras', OUR_SCENE);
  if (document.environment.source.type !== 'none')
    notes.add('the environment is not in a glTF file: whoever shows it chooses one');
  if (document.fog.density > 0) notes.add('fog has no counterpart in glTF');
  return { bytes: writer.finish(), notes: notes.list };
}

async function geometryOf(
  geometry: Geometry,
  document: Document,
  assets: AssetLoader,
): Promise<THREE.BufferGeometry> {
  if (geometry.type === 'suzanne') return assets.suzanne();
  if (geometry.type !== 'gltf') return createPrimitive(geometry);
  const asset = document.assets[geometry.asset];
  if (asset === undefined) throw new Error(`there is no asset ${geometry.asset}`);
  return assets.gltfGeometry(asset, geometry.node, geometry.primitive);
}

/** A primitive without a material. */
function writeGeometry(writer: GltfWriter, geometry: THREE.BufferGeometry): Json {
  const values = (name: string): Float32Array | undefined => {
    const attribute = geometry.getAttribute(name);
    return attribute && Float32Array.from(attribute.array);
  };
  const mesh: MeshData = {
    positions: values('position') ?? new Float32Array(0),
    normals: values('normal'),
    uvs: values('uv'),
    uvs2: values('uv1'),
  };
  const index = geometry.getIndex();
  const vertices = mesh.positions.length / 3;
  return {
    attributes: writeAttributes(writer, mesh),
    ...(index && { indices: writer.indices(Uint32Array.from(index.array), vertices) }),
  };
}
