/** What the tests of glTF share: small files, and the way into a scene. */
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import type * as THREE from 'three/webgpu';
import { expect } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { writeGlb } from '../../src/io/gltf/glb.ts';
import { addImported, importGltf } from '../../src/io/gltf.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { createDocument } from '../../src/scene/document.ts';
import type { Document, Material } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

export const assets = new AssetLoader(nodeAssets);

/** Imports a file into a scene. */
export async function bringInto(
  store: DocumentStore,
  bytes: Uint8Array,
  files?: Map<string, Uint8Array>,
): Promise<{ notes: string[]; document: Document }> {
  const imported = await importGltf(bytes, 'sample.glb', assets, files && { companions: files });
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });
  return { notes: imported.notes, document: store.document };
}

/** Imports a file into an empty scene. */
export const bring = (bytes: Uint8Array) => bringInto(new DocumentStore(createDocument()), bytes);

export async function onlyMaterial(bytes: Uint8Array): Promise<Material & { notes: string[] }> {
  const { document, notes } = await bring(bytes);
  const materials = Object.values(document.materials);
  expect(materials).toHaveLength(1);
  return { ...materials[0]!, notes };
}

/** Node has none, and three's exporter wants one. */
class BlobReader {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((buffer) => {
      this.result = buffer;
      this.onloadend?.();
    });
  }
}
// Not a stub: what another file of this process takes back would be missing here, where this is imported once.
Object.assign(globalThis, { FileReader: BlobReader });

/** What three.js writes for a scene. */
export async function exported(scene: THREE.Object3D): Promise<Uint8Array> {
  const result = await new GLTFExporter().parseAsync(scene, { binary: true });
  return new Uint8Array(result as ArrayBuffer);
}

export type Json = Record<string, unknown>;

/** A triangle with everything that a test adds to or replaces in the file. */
export function triangle(changes: Json = {}, material: Json = {}): Uint8Array {
  const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const uv = new Float32Array([0, 0, 1, 0, 0, 0.25]);
  const binary = new Uint8Array(60);
  binary.set(new Uint8Array(positions.buffer));
  binary.set(new Uint8Array(uv.buffer), 36);
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: 'Triangle' }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    materials: [{ name: 'Paint', ...material }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count: 3, type: 'VEC2' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 36 },
      { buffer: 0, byteOffset: 36, byteLength: 24 },
    ],
    buffers: [{ byteLength: 60 }],
    ...changes,
  };
  return writeGlb(json, binary);
}

/** One white pixel. */
export const png =
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==';
export const images = { images: [{ uri: `data:image/png;base64,${png}` }], textures: [{ source: 0 }] };
