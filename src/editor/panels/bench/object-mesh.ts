/** The triangles of an object of the scene, as the lit view wants them. */
import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three/webgpu';
import type { TriangleMesh } from '../../../analysis/plots/surface.ts';
import type { Document } from '../../../scene/schema.ts';
import { selectedMaterial } from '../../selected-material.ts';
import type { Selection } from '../../state.ts';

const meshes = new WeakMap<BufferGeometry, TriangleMesh>();

/** The selected object, or the first one that has the selected material. */
export function litObject(document: Document, selection: Selection): string | null {
  if (selection?.kind === 'objects') return selection.id;
  const material = selectedMaterial(document, selection);
  const found = Object.entries(document.objects).find(([, object]) => object.material === material);
  return found?.[0] ?? null;
}

/** The same mesh as long as the geometry is the same; null while it has no vertices yet. */
export function meshOf(geometry: BufferGeometry): TriangleMesh | null {
  const known = meshes.get(geometry);
  if (known) return known;
  const { position, normal, tangent } = geometry.attributes;
  if (!position || !normal) return null;
  const count = geometry.index?.count ?? position.count;
  const mesh = {
    positions: triples(position),
    normals: triples(normal),
    tangents: tangent ? triples(tangent) : null,
    index: Uint32Array.from({ length: count }, (_, i) => geometry.index?.getX(i) ?? i),
  };
  meshes.set(geometry, mesh);
  return mesh;
}

function triples(attribute: BufferAttribute | InterleavedBufferAttribute): Float32Array {
  const values = new Float32Array(3 * attribute.count);
  for (let i = 0; i < attribute.count; i++) {
    values.set([attribute.getX(i), attribute.getY(i), attribute.getZ(i)], 3 * i);
  }
  return values;
}
