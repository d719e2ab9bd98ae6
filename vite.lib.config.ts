import { defineConfig } from 'vite';
import { repository, target } from './vite.shared.config.ts';

/** The library: what `import ... from 'irradia'` gives, with the models' text inside. */
export default defineConfig({
  root: repository,
  publicDir: false,
  build: {
    target,
    outDir: `${repository}dist/lib`,
    emptyOutDir: true,
    minify: false,
    sourcemap: true,
    lib: { entry: `${repository}src/index.ts`, formats: ['es'], fileName: 'index' },
    rolldownOptions: { external: [/^three($|\/)/, 'fflate', 'immer', 'zod'] },
  },
});
