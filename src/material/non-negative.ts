import type { Node } from 'three/webgpu';
import { glslFunction } from '../glsl/tsl.ts';

/**
 * f where it is a positive number, else 0, component by component. A stranger's model may yield negative
 * values or NaN, which would spread over the picture; comparisons with NaN are false.
 */
export const nonNegative = glslFunction(`
  vec3 nonNegative(vec3 f) {
    return mix(vec3(0.0), f, greaterThan(f, vec3(0.0)));
  }
`) as unknown as (f: Node<'vec3'>) => Node<'vec3'>;
