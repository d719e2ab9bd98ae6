import { int, Loop } from 'three/tsl';
import type { Node } from 'three/webgpu';

/** Runs `body` in the shader for i = 0 ... count - 1; i comes as a float. */
export function repeat(count: number | Node<'float'>, body: (i: Node<'float'>) => void): void {
  const end = typeof count === 'number' ? count : int(count);
  Loop({ start: 0, end, type: 'int' } as unknown as number, ({ i }: { i: Node }) => {
    body((i as Node<'int'>).toFloat() as Node<'float'>);
  });
}
