import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';
import { repository } from './vite.shared.config.ts';

/**
 * Three kinds of test, told apart by their names:
 *   x.test.ts      plain Node
 *   x.gpu.test.ts  a GPU in Node (Dawn)
 *   x.e2e.test.ts  a real browser
 * As many files at once as there are cores: a software GPU takes all of them to draw, but only one to compile shaders, and
 * a page often waits.
 * The timeouts only catch a hang; no test says how fast something must be.
 *
 * The files of a kind share processes, and what these have imported: importing the library and three.js afresh for every
 * file takes as long as many a file's tests. So a test file leaves behind what it found (vi.unstubAllGlobals()).
 */
const gpu = 'test/**/*.gpu.test.ts';
const e2e = 'test/**/*.e2e.test.ts';
const withGpu = {
  pool: 'forks',
  // Vitest would leave one core to itself, which has little to do once all is imported.
  maxWorkers: availableParallelism(),
  isolate: false,
  testTimeout: 300_000,
  hookTimeout: 300_000,
} as const;

export default defineConfig({
  root: repository,
  test: {
    reporters: ['default', './test/support/reporter.ts'],
    projects: [
      {
        extends: true,
        test: {
          name: { label: 'unit', color: 'green' },
          include: ['test/**/*.test.ts'],
          exclude: [gpu, e2e],
          isolate: false,
          maxWorkers: availableParallelism(),
          testTimeout: 60_000,
          hookTimeout: 60_000,
          sequence: { groupOrder: 0 },
        },
      },
      {
        extends: true,
        test: {
          name: { label: 'gpu', color: 'cyan' },
          include: [gpu],
          ...withGpu,
          sequence: { groupOrder: 1 },
        },
      },
      {
        extends: true,
        test: {
          name: { label: 'e2e', color: 'magenta' },
          include: [e2e],
          ...withGpu,
          sequence: { groupOrder: 1 },
        },
      },
    ],
  },
});
