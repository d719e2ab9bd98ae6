/**
 * Puts what large geometries are made of on the GPU before they are drawn, a buffer in a task. three.js would copy all of a
 * geometry in one: 60 ms for a million triangles.
 */
import type { BufferAttribute, InterleavedBufferAttribute, Mesh, WebGPURenderer } from 'three/webgpu';

/** Bytes; less takes a few milliseconds. */
const LARGE = 2 * 1024 * 1024;

/** What @types/three leaves out. Both do nothing for what they have made. */
interface Buffers {
  has(attribute: BufferAttribute): boolean;
  createAttribute(attribute: BufferAttribute): void;
  createIndexAttribute(attribute: BufferAttribute): void;
}

/** @param between resolves in another task */
export async function uploadAhead(
  { backend }: WebGPURenderer,
  meshes: readonly Mesh[],
  between: () => Promise<void>,
): Promise<void> {
  const buffers = backend as unknown as Buffers;
  const isNew = (attribute: BufferAttribute | InterleavedBufferAttribute): attribute is BufferAttribute =>
    'isBufferAttribute' in attribute && attribute.array.byteLength >= LARGE && !buffers.has(attribute);
  for (const { attributes, index } of new Set(meshes.map(({ geometry }) => geometry))) {
    for (const attribute of Object.values(attributes)) {
      if (!isNew(attribute)) continue;
      buffers.createAttribute(attribute);
      await between();
    }
    if (!index || !isNew(index)) continue;
    buffers.createIndexAttribute(index);
    await between();
  }
}
