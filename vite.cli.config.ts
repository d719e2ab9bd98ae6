import { defineConfig } from 'vite';
import { alias, repository } from './vite.shared.config.ts';

/** The command line: plain ES modules for Node, one chunk per command, dependencies left outside. */
export default defineConfig({
  root: repository,
  publicDir: false,
  resolve: { alias },
  // The environments and Suzanne are data, not code to share: only what is used goes in, by parts.
  // three-mesh-bvh asks for plain three, which would be a second renderer beside three/webgpu.
  ssr: { noExternal: ['@pmndrs/assets', 'three-mesh-bvh'] },
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
