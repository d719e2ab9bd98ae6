import type { Node, NodeBuilder } from 'three/webgpu';
import type { ShadingFrame } from './shading-frame.ts';

/** What a fragment's shading hands to those who look into it: `context.fragmentData`, filled while a shader is built. */
export interface FragmentData {
  frame: ShadingFrame | null;
  /** How many lamps reach the fragment. */
  lights: Node<'float'> | null;
}

/** null where nobody looks. */
export function fragmentData(builder: NodeBuilder): FragmentData | null {
  const { fragmentData } = builder.context as { fragmentData?: FragmentData };
  return fragmentData ?? null;
}
