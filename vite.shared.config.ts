import { fileURLToPath } from 'node:url';
import type { AliasOptions } from 'vite';

export const repository = fileURLToPath(new URL('.', import.meta.url));

/**
 * three's addons import plain `three`, which would bring the WebGLRenderer and a second copy of
 * everything that is not in three.core.js. Both builds offer the same classes.
 */
export const alias: AliasOptions = [{ find: /^three$/, replacement: 'three/webgpu' }];

/** WebGPU is the newest thing the pages need; browsers that have it have ES2022. */
export const target = 'es2022';

/** For the examples, which import the package by its name, as it is built. */
export const packageAlias = { find: /^irradia$/, replacement: `${repository}dist/lib/index.js` };
