/** Runs a TypeScript file in Node, which cannot by itself at version 20: `node tools/run.mjs FILE`. */
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { runnerImport } from 'vite';

await runnerImport(pathToFileURL(resolve(process.argv[2])).href);
