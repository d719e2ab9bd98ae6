/** What is compiled ahead of a frame, one after the other: two at once would take each other's state in three.js for their own. */
import { Mesh, type Scene } from 'three/webgpu';
import { settledWithin } from './patience.ts';

/**
 * As long as one waits for the one before it, ms. On WebGL three.js asks for ever whether a shader has been compiled that was
 * let go meanwhile; by then it has long given its state back.
 */
const PATIENCE_MS = 10_000;

export class CompileQueue {
  #last: Promise<unknown> = Promise.resolve();

  /** @returns when it has been compiled, however long that takes */
  add(compile: () => Promise<void>): Promise<void> {
    const compiled = this.#last.then(compile);
    this.#last = this.#last.then(() => settledWithin(PATIENCE_MS, compiled));
    return compiled;
  }
}

/** Lets three.js see only some meshes of a scene, and its lights. `list` has to list what it is going to work on at once. */
export function withOnly<T>(scene: Scene, meshes: readonly Mesh[], list: () => T): T {
  const wanted = new Set(meshes);
  const others: Mesh[] = [];
  scene.traverseVisible((object) => {
    if (object instanceof Mesh && !wanted.has(object)) others.push(object);
  });
  const masks = others.map(({ layers }) => layers.mask);
  for (const { layers } of others) layers.mask = 0;
  try {
    return list();
  } finally {
    for (const [i, { layers }] of others.entries()) layers.mask = masks[i] as number;
  }
}
