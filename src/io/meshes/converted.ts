import type { Camera, Material } from '../../scene/schema.ts';
import type { NodeLight, NodePrimitive } from '../gltf/nodes.ts';

/** What a file of another format becomes: triangles and images in a GLB, and beside it what a document says better. */
export interface Converted {
  glb: Uint8Array<ArrayBuffer>;
  /** By the numbers that the GLB's primitives have; their textures name no asset yet. */
  materials: Material[];
  lights: NodeLight[];
  /** Objects that need no triangles from the GLB. */
  primitives: NodePrimitive[];
  camera: Camera | null;
}
