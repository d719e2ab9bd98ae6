import { property } from 'three/tsl';
import type { Node, NodeBuilder } from 'three/webgpu';

/**
 * What a fragment's shading hands to those who look into it: variables of the shader, set while it shades where
 * `context.fragmentData` is true.
 */
export const fragmentData = {
  /** The tangent that the model is given, in view space. */
  tangent: property('vec3', 'shadedTangent') as Node<'vec3'>,
  /** How many lamps reach the fragment. */
  lamps: property('float', 'shadedLamps') as Node<'float'>,
  /** The cascade of the last light from far away that casts shadows, from 1 for the finest; 0 where there is none. */
  cascade: property('float', 'shadedCascade') as Node<'float'>,
};

export function wantsFragmentData(builder: NodeBuilder): boolean {
  return (builder.context as { fragmentData?: boolean }).fragmentData === true;
}
