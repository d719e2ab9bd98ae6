import { referenceAttribute, tangentLocal, vec4 } from 'three/tsl';
import type { InstancedMesh, Node, NodeBuilder } from 'three/webgpu';

/**
 * Turns the tangent with the instance, as three.js turns position and normal only (r187, Instance.js): without
 * it the highlights of a brushed metal would run the same way on all instances.
 */
export function turnTangentWithInstance(builder: NodeBuilder): void {
  const { object, geometry } = builder as unknown as Pick<InstancedMesh, 'geometry'> & {
    object: InstancedMesh;
  };
  if (!object.isInstancedMesh || !geometry.hasAttribute('tangent')) return;
  const matrix = referenceAttribute('instanceMatrix', 'mat4') as unknown as Node<'mat4'>;
  const tangent = tangentLocal as unknown as Node<'vec3'> & { assign(value: Node): void };
  tangent.assign(matrix.mul(vec4(tangent, 0)).xyz.normalize());
}
