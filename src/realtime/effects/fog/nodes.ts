/** Small parts of the fog's shaders. */
import { float, vec2, vec3 } from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { inputTexture } from '../../frame/pass.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** Kept where it is computed; see run() in src/material/statements.ts. */
export function kept(value: Vec3): Vec3 {
  const variable = vec3(0).toVar();
  variable.assign(value);
  return variable as unknown as Vec3;
}

export function kept2(value: Vec2): Vec2 {
  const variable = vec2(0).toVar();
  variable.assign(value);
  return variable as unknown as Vec2;
}

export function keptFloat(value: Float): Float {
  const variable = float(0).toVar();
  variable.assign(value);
  return variable as unknown as Float;
}

/** Read texel by texel: there is no transform of texture coordinates. */
export function dataTexture(): TextureNode {
  const node = inputTexture() as unknown as TextureNode & { setUpdateMatrix(value: boolean): TextureNode };
  return node.setUpdateMatrix(false);
}
