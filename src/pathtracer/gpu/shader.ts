import type { Kernel } from '../../glsl/kernel.ts';
import { reachable } from '../../glsl/order.ts';
import { emitFunction } from '../../glsl/shader-text.ts';
import { TILE } from '../tiles.ts';

/** Pixels along each side of a workgroup; a tile has a whole number of them. */
export const WORKGROUP = 8;

/** Starts every global name of the kernel. */
const PREFIX = 'kernel';

/**
 * The kernel as one compute shader in WGSL.
 *
 * Group 0: 0 the scene's memory, 1 the film, 2 a uniform (left, top, first sample, number of samples) of the
 * part that a dispatch takes, one invocation a pixel, 3 a word for every tile of the picture: 0 if it is not taken.
 */
export function kernelShader(kernel: Kernel): string {
  const entry = kernel.entry('renderPixel');
  const needs = new Map<string, string>();
  const code: string[] = [];
  let main = '';
  for (const f of reachable([entry])) {
    const emitted = emitFunction(PREFIX, f, 'wgsl');
    for (const [name, text] of emitted.needs) needs.set(name, text);
    code.push(emitted.code);
    main = emitted.name;
  }
  return `
@group(0) @binding(0) var<storage, read> scene: array<vec4<u32>>;
@group(0) @binding(1) var<storage, read_write> film: array<vec4<f32>>;
@group(0) @binding(2) var<uniform> job: vec4<u32>;
@group(0) @binding(3) var<storage, read> tiles: array<u32>;
${[...needs.values()].join('\n')}
${code.join('\n')}
@compute @workgroup_size(${WORKGROUP}, ${WORKGROUP})
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
  let size = scene[16].xy;
  let place = job.xy + id.xy;
  if (any(place >= size)) { return; }
  // A workgroup is of one tile: none of its invocations waits for another.
  let tile = place / ${TILE}u;
  if (tiles[tile.y * ((size.x + ${TILE - 1}u) / ${TILE}u) + tile.x] == 0u) { return; }
  let pixel = i32(place.y * size.x + place.x);
  ${main}(pixel, 5 * pixel, job.z, job.w);
}
`;
}

export const ADD_WORKGROUP = 64;

/** Adds one film to another. Group 0: 0 what is added, 1 what it is added to. */
export const ADD_SHADER = `
@group(0) @binding(0) var<storage, read> part: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read_write> total: array<vec4<f32>>;
@compute @workgroup_size(${ADD_WORKGROUP})
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
  let i = id.y * groups.x * ${ADD_WORKGROUP}u + id.x;
  if (i < arrayLength(&total)) { total[i] += part[i]; }
}
`;
