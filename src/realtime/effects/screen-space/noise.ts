/** Numbers that differ from pixel to pixel, such that neighbours have different ones. */
import type { Node } from 'three/webgpu';
import { glslFunction } from '../../../glsl/tsl.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;

/**
 * Interleaved gradient noise, in 0..1: any 3 x 3 pixels have values that are spread evenly (J. Jimenez, 2014, "Next
 * Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH course).
 */
export const gradientNoise = glslFunction(`
  float gradientNoise(vec2 pixel) {
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  }
`) as unknown as (pixel: Vec2) => Float;

/**
 * The R2 sequence's lattice over the pixels, in 0..1; independent of the gradient noise (M. Roberts, 2018, "The
 * Unreasonable Effectiveness of Quasirandom Sequences").
 */
export const latticeNoise = glslFunction(`
  float latticeNoise(vec2 pixel) {
    return fract(dot(pixel, vec2(0.7548776662, 0.5698402910)));
  }
`) as unknown as (pixel: Vec2) => Float;
