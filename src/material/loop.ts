import { float, Loop } from 'three/tsl';
import type { Node } from 'three/webgpu';

/** Runs `body` in the shader for i = 0 ... count - 1; i comes as a float. */
export function repeat(count: number, body: (i: Node<'float'>) => void): void {
  Loop(count, ({ i }: { i: Node }) => body(float(i as Node<'int'>) as unknown as Node<'float'>));
}
