/**
 * `npm test`: the linter, the type checker, the build and the tests. All of them run even if one fails;
 * the closing line counts them together, and the exit code is 0 only if all passed.
 */
import { spawn } from 'node:child_process';

const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';

/** Runs npm and resolves to its exit code and, where it is not shown as it comes, its output. */
function run(args, { env = {}, isShown = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(npm, args, {
      stdio: isShown ? 'inherit' : ['ignore', 'pipe', 'pipe'],
      env: { ...process.env, ...env },
      shell: npm.endsWith('.cmd'),
    });
    const output = [];
    for (const stream of [child.stdout, child.stderr]) stream?.on('data', (data) => output.push(data));
    child.on('error', (error) => resolve({ code: 1, output: `${error.message}\n` }));
    child.on('close', (code) => resolve({ code: code ?? 1, output: Buffer.concat(output).toString() }));
  });
}

async function check(name) {
  const { code, output } = await run(['run', '--silent', name]);
  // Each in one piece, though they overlap.
  process.stdout.write(output);
  if (code !== 0) console.error(`npm run ${name} failed; see above`);
  return code === 0;
}

async function inTurn(names) {
  const results = [];
  for (const name of names) results.push(await check(name));
  return results;
}

// The type checker and the build read what this derives from the models, and would each derive it again.
await run(['run', '--silent', 'generate']);
// The build takes longest: the other two are done meanwhile.
const [isBuilt, others] = await Promise.all([check('build'), inTurn(['lint', 'typecheck'])]);
const results = [isBuilt, ...others];
const passed = results.filter(Boolean).length;
const failed = results.length - passed;

// The reporter in test/support adds these to its own numbers in the closing line.
const env = { IRRADIA_CHECKS_PASSED: passed, IRRADIA_CHECKS_FAILED: failed };
const tests = await run(['exec', '--', 'vitest', 'run', ...process.argv.slice(2)], { env, isShown: true });
process.exitCode = failed ? 1 : tests.code;
