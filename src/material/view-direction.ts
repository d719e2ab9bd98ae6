import { renderGroup, uniform } from 'three/tsl';
import { type Camera, type DirectionalLight, type Node, type SpotLight, Vector3 } from 'three/webgpu';

type Vec3 = Node<'vec3'>;
type Aimed = DirectionalLight | SpotLight;

const directions = new WeakMap<Aimed, Vec3>();
const target = new Vector3();

/**
 * From a light's target to the light, in view space: a unit vector. three.js computes the same anew for every fragment,
 * from its matrices.
 */
export function viewDirection(light: Aimed): Vec3 {
  let direction = directions.get(light);
  if (!direction) {
    direction = scaledViewDirection(light, () => 1);
    directions.set(light, direction);
  }
  return direction;
}

/** The same, of another length. */
export function scaledViewDirection(light: Aimed, length: () => number): Vec3 {
  return uniform(new Vector3())
    .setGroup(renderGroup)
    .onRenderUpdate(({ camera }, { value }) =>
      value
        .setFromMatrixPosition(light.matrixWorld)
        .sub(target.setFromMatrixPosition(light.target.matrixWorld))
        .transformDirection((camera as Camera).matrixWorldInverse)
        .multiplyScalar(length()),
    ) as unknown as Vec3;
}
