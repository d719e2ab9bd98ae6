import { float, int, Loop, vec2, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';

/** A variable of a shader; three.js declares these for some nodes alone. */
export interface Assignable {
  assign(value: Node): void;
  addAssign(value: Node): void;
}

/** Runs `body` in the shader for i = 0 ... count - 1; i comes as a float. */
export function repeat(count: number | Node<'float'>, body: (i: Node<'float'>) => void): void {
  const end = typeof count === 'number' ? count : int(count);
  Loop({ start: 0, end, type: 'int' } as unknown as number, ({ i }: { i: Node }) => {
    body((i as Node<'int'>).toFloat() as Node<'float'>);
  });
}

/**
 * Calls a function here, for what it leaves in variables. toVar() would not do: three.js moves a variable to the
 * first place that reads it, into a loop too, and drops one that nothing reads.
 */
export function run(call: Node<'float'>): void {
  float(0).toVar().assign(call);
}

/** Computed here and kept: derivatives do not hold inside branches, where toVar() alone may move them. */
export function keptFloat(value: Node<'float'>): Node<'float'> {
  return keep(float(0).toVar(), value);
}

/** The same for two numbers. */
export function keptVec2(value: Node<'vec2'>): Node<'vec2'> {
  return keep(vec2(0).toVar(), value);
}

/** The same for three. @param name of the variable in the shader's text */
export function keptVec3(value: Node<'vec3'>, name?: string): Node<'vec3'> {
  return keep(vec3(0).toVar(name), value);
}

function keep<T extends Node>(variable: Node, value: T): T {
  (variable as unknown as Assignable).assign(value);
  return variable as unknown as T;
}
