/**
 * `npm test`: the linter, the type checker, the build and the tests. All of them run even if one fails;
 * the closing line counts them together, and the exit code is 0 only if all passed.
 */
import { spawnSync } from 'node:child_process';

const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
const run = (args, env = {}) =>
  spawnSync(npm, args, { stdio: 'inherit', env: { ...process.env, ...env }, shell: npm.endsWith('.cmd') })
    .status ?? 1;

const checks = ['lint', 'typecheck', 'build'];
const failed = checks.filter((check) => run(['run', '--silent', check]) !== 0);
for (const check of failed) console.error(`npm run ${check} failed; see above`);

// The reporter in test/support adds these to its own numbers in the closing line.
const counts = { IRRADIA_CHECKS_PASSED: checks.length - failed.length, IRRADIA_CHECKS_FAILED: failed.length };
const tests = run(['exec', '--', 'vitest', 'run', ...process.argv.slice(2)], counts);
process.exitCode = failed.length ? 1 : tests;
