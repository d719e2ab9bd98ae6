import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';
import LongestFirst from './test/support/sequencer.ts';
import { repository } from './vite.shared.config.ts';

/**
 * Three kinds of test, told apart by their names:
 *   x.test.ts      plain Node
 *   x.gpu.test.ts  a GPU in Node (Dawn)
 *   x.e2e.test.ts  a real browser
 * As many files at once as there are cores: a page often waits, but one file more costs as much in imports as it wins.
 * The timeouts only catch a hang; no test says how fast something must be. Vitest's own second for what is polled would.
 *
 * The files of a kind share processes, and what these have imported: importing the library and three.js afresh for every
 * file takes as long as many a file's tests. So a test file leaves behind what it found (vi.unstubAllGlobals()).
 */
const gpu = 'test/**/*.gpu.test.ts';
const e2e = 'test/**/*.e2e.test.ts';
const common = {
  expect: { poll: { timeout: 120_000 } },
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
    sequence: { sequencer: LongestFirst },
    projects: [
      {
        extends: true,
        test: {
          ...common,
          name: { label: 'unit', color: 'green' },
          include: ['test/**/*.test.ts'],
          exclude: [gpu, e2e],
          setupFiles: 'test/support/seed.ts',
        },
      },
      { extends: true, test: { ...common, name: { label: 'gpu', color: 'cyan' }, include: [gpu] } },
      { extends: true, test: { ...common, name: { label: 'e2e', color: 'magenta' }, include: [e2e] } },
    ],
  },
});
