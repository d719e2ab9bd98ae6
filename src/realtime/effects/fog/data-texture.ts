import type { TextureNode } from 'three/webgpu';
import { inputTexture } from '../../frame/pass.ts';

/** Read texel by texel: there is no transform of texture coordinates. */
export function dataTexture(): TextureNode {
  const node = inputTexture() as unknown as TextureNode & { setUpdateMatrix(value: boolean): TextureNode };
  return node.setUpdateMatrix(false);
}
