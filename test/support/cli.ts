import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { Readable } from 'node:stream';
import { vi } from 'vitest';
import { irradia as call } from '../../src/cli/irradia.ts';
import { buildAll } from '../../tools/build.mjs';
import { repository } from '../../vite.shared.config.ts';

export const irradiaPath = join(repository, 'bin/irradia.js');

/** Builds what a test runs, if its sources are newer than the last build. */
export const built = (...parts: ('lab' | 'lib' | 'cli')[]): Promise<void> =>
  buildAll(parts, { ifStale: true });

export interface CliResult {
  /** Null for a process that a signal ended. */
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

/**
 * The same call in this process: what is said about a call, not that a build or a process works, for which each command
 * has a test, too. A process takes half a second to begin. One call at a time.
 */
export async function called(words: readonly string[], input = ''): Promise<CliResult> {
  let [stdout, stderr] = ['', ''];
  const spies = [
    vi
      .spyOn(process, 'stdin', 'get')
      .mockReturnValue(Readable.from([Buffer.from(input)]) as typeof process.stdin),
    vi.spyOn(process.stdout, 'write').mockImplementation((text) => {
      stdout += text;
      return true;
    }),
    vi.spyOn(process.stderr, 'write').mockImplementation((text) => {
      stderr += text;
      return true;
    }),
    vi.spyOn(console, 'log').mockImplementation((text) => {
      stdout += `${text}\n`;
    }),
  ];
  try {
    return { code: await call(words), stdout, stderr };
  } finally {
    for (const spy of spies) spy.mockRestore();
  }
}
