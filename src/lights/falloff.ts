import { renderGroup, uniform } from 'three/tsl';
import { type Node, type UniformNode, Vector3 } from 'three/webgpu';
import { glslFunction } from '../glsl/tsl.ts';

/**
 * How a light's irradiance falls with the distance r in metres: as 1/r^2, which is physics, as 1/r, or
 * not at all, as in the thesis's demo (E. Yerga, 2018, section 4.7: f_dist is a choice).
 */
export type Falloff = 'inverse-square' | 'linear' | 'constant';

export const FALLOFFS: readonly Falloff[] = ['inverse-square', 'linear', 'constant'];

/** f_dist(r) for a point or spot light. @param range where the light ends, in metres; 0 is nowhere */
export function falloffAt(r: number, falloff: Falloff, range = 0): number {
  const base = falloff === 'constant' ? 1 : falloff === 'linear' ? 1 / r : 1 / (r * r);
  return base * (range > 0 ? Math.max(0, 1 - (r / range) ** 4) ** 2 : 1);
}

const windowed = glslFunction(`
  float windowed(float inverseDistance, vec3 coefficients, float inverseRange4) {
    float base = (coefficients.z * inverseDistance + coefficients.y) * inverseDistance + coefficients.x;
    float distance2 = 1.0 / (inverseDistance * inverseDistance);
    float window = max(1.0 - distance2 * distance2 * inverseRange4, 0.0);
    return base * window * window;
  }
`) as unknown as (inverseDistance: Node, coefficients: Node, inverseRange4: Node) => Node<'float'>;

/**
 * falloffAt() on the GPU, without branches or pow(): a polynomial in 1/r whose coefficients are the
 * choice, so that another falloff compiles nothing.
 */
export class FalloffNodes {
  /** Factors of 1, 1/r and 1/r^2. */
  private readonly coefficients: UniformNode<'vec3', Vector3> = uniform(new Vector3()).setGroup(renderGroup);
  private readonly inverseRange4: UniformNode<'float', number> = uniform(0).setGroup(renderGroup);

  set(falloff: Falloff, range: number): void {
    this.coefficients.value.set(
      Number(falloff === 'constant'),
      Number(falloff === 'linear'),
      Number(falloff === 'inverse-square'),
    );
    this.inverseRange4.value = range > 0 ? range ** -4 : 0;
  }

  /**
   * @param inverseDistance 1/r
   * @returns f_dist(r) with the window of Lagarde and de Rousiers, 2014, "Moving Frostbite to Physically
   *   Based Rendering", equation 26, which ends the light at its range without an edge
   */
  at(inverseDistance: Node<'float'>): Node<'float'> {
    return windowed(inverseDistance, this.coefficients, this.inverseRange4);
  }
}
