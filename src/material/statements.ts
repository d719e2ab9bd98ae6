import { float, int, Loop } from 'three/tsl';
import type { Node } from 'three/webgpu';

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
