import { defineConfig } from 'vite';
import { alias, repository, target } from './vite.shared.config.ts';

/** The lab: the page in src/editor, built into dist/lab. It may be served from any folder. */
export default defineConfig({
  root: `${repository}src/editor`,
  base: './',
  publicDir: false,
  cacheDir: `${repository}node_modules/.vite/lab`,
  resolve: { alias },
  server: {
    fs: { allow: [repository] },
    // As src/cli/static-server.ts: the path tracer's threads share memory only in an isolated page.
    headers: {
      'Cross-Origin-Opener-Policy': 'same-origin',
      'Cross-Origin-Embedder-Policy': 'require-corp',
    },
  },
  build: {
    target,
    outDir: `${repository}dist/lab`,
    emptyOutDir: true,
    sourcemap: true,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 2000,
  },
  worker: { format: 'es' },
});
