import { cameraViewMatrix, lightViewPosition, vec4 } from 'three/tsl';
import { type Node, type NodeBuilder, RectAreaLight, RectAreaLightNode } from 'three/webgpu';
import { lightColor } from './light-vector.ts';

/**
 * A rectangle of even radiance, `width` by `height` metres, that shines to one side, along its -z axis.
 * `intensity` is its luminance in nits.
 *
 * Lights BrdfMaterial only: the stock materials need three.js's RectAreaLight and its tables.
 */
export class BrdfRectLight extends RectAreaLight {}

class BrdfRectLightNode extends RectAreaLightNode {
  static get type(): string {
    return 'BrdfRectLightNode';
  }

  /** As the stock node, without the tables of linearly transformed cosines, which fit GGX alone. */
  override setupDirectRectArea(_builder: NodeBuilder) {
    return {
      lightColor: lightColor(this),
      lightPosition: lightViewPosition(this.light as RectAreaLight),
      halfWidth: cameraViewMatrix.mul(vec4(this.halfWidth as Node<'vec3'>, 0)).xyz,
      halfHeight: cameraViewMatrix.mul(vec4(this.halfHeight as Node<'vec3'>, 0)).xyz,
    } as unknown as ReturnType<RectAreaLightNode['setupDirectRectArea']>;
  }
}

BrdfRectLight.registerNode(BrdfRectLightNode);
