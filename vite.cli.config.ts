import { defineConfig } from 'vite';
import { repository } from './vite.shared.config.ts';

/** The command line: plain ES modules for Node, one chunk per command, dependencies left outside. */
export default defineConfig({
  root: repository,
  publicDir: false,
  // The environments and Suzanne are data, not code to share: only what is used goes in, by parts.
  ssr: { noExternal: ['@pmndrs/assets'] },
  build: {
    target: 'node20',
    ssr: true,
    rolldownOptions: {
      input: {
        main: `${repository}src/cli/main.ts`,
        'path-tracer-worker': `${repository}src/cli/path-tracer-worker.ts`,
      },
    },
    outDir: `${repository}dist/cli`,
    emptyOutDir: true,
    minify: false,
  },
});
