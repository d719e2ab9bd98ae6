/**
 * Directions as two numbers in -1..1: Q. Meyer et al., 2010, "On Floating-Point Normal Vectors", CGF 29(4).
 */
import type { Node } from 'three/webgpu';
import { glslFunction } from '../../../glsl/tsl.ts';

export const toOctahedron = glslFunction(`
  vec2 toOctahedron(vec3 d) {
    vec2 p = d.xy / max(abs(d.x) + abs(d.y) + abs(d.z), 1e-9);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return d.z < 0.0 ? (vec2(1.0) - abs(p.yx)) * side : p;
  }
`) as unknown as (direction: Node<'vec3'>) => Node<'vec2'>;

export const fromOctahedron = glslFunction(`
  vec3 fromOctahedron(vec2 p) {
    float z = 1.0 - abs(p.x) - abs(p.y);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    vec2 xy = z < 0.0 ? (vec2(1.0) - abs(p.yx)) * side : p;
    return normalize(vec3(xy, z));
  }
`) as unknown as (place: Node<'vec2'>) => Node<'vec3'>;
