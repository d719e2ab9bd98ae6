import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { buildAll } from '../../tools/build.mjs';
import { repository } from '../../vite.shared.config.ts';

export const irradiaPath = join(repository, 'bin/irradia.js');

/** Builds what a test runs, if its sources are newer than the last build. */
export const built = (...parts: ('lab' | 'lib' | 'cli')[]): Promise<void> =>
  buildAll(parts, { ifStale: true });

export interface CliResult {
  code: number | null;
  stdout: string;
  stderr: string;
}

/** Runs `irradia` as a user does: a process of its own. */
export function irradia(words: readonly string[], input = ''): Promise<CliResult> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [irradiaPath, ...words], { cwd: repository });
    let stdout = '';
    let stderr = '';
    child.stdout.on('data', (data) => {
      stdout += data;
    });
    child.stderr.on('data', (data) => {
      stderr += data;
    });
    child.on('error', reject);
    child.on('close', (code) => resolve({ code, stdout, stderr }));
    // A process that ends before it has read everything is no failure of the test.
    child.stdin.on('error', () => {});
    child.stdin.end(input);
  });
}
