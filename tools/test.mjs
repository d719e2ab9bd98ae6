/**
 * `npm test`: the build, the linter, the type checker and the tests. All of them run even if one fails;
 * the closing line counts them together, and the exit code is 0 only if all passed.
 */
import { spawn } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const tool = (name) => fileURLToPath(new URL(name, import.meta.url));
/** The file that a package's command runs: npm would take half a second to find it. */
const command = (name, file) =>
  join(dirname(fileURLToPath(import.meta.resolve(`${name}/package.json`))), file);
const tsc = command('typescript', 'bin/tsc');

/** Runs a program of Node and resolves to its exit code and, where it is not shown as it comes, its output. */
function run(words, { env = {}, isShown = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, words, {
      stdio: isShown ? 'inherit' : ['ignore', 'pipe', 'pipe'],
      env: { ...process.env, ...env },
    });
    const output = [];
    for (const stream of [child.stdout, child.stderr]) stream?.on('data', (data) => output.push(data));
    child.on('error', (error) => resolve({ code: 1, output: `${error.message}\n` }));
    child.on('close', (code) => resolve({ code: code ?? 1, output: Buffer.concat(output).toString() }));
  });
}

/** All of a check's programs at once; what they print comes in one piece, though checks overlap. */
async function check(name, ...programs) {
  const results = await Promise.all(programs.map((words) => run(words)));
  process.stdout.write(results.map(({ output }) => output).join(''));
  const isPassed = results.every(({ code }) => code === 0);
  if (!isPassed) console.error(`npm run ${name} failed; see above`);
  return isPassed;
}

// The build and the type checker read what this derives from the models.
await run([tool('named-materials.mjs')]);
const results = [
  // `npm ci` has built what was checked out.
  await check('build', [tool('build.mjs'), '--if-stale']),
  ...(await Promise.all([
    check('lint', [command('@biomejs/biome', 'bin/biome'), 'check']),
    // Threads of one checker would each work out the types of three.js.
    check(
      'typecheck',
      ...['', '.node'].map((part) => [tsc, '-p', `tsconfig${part}.json`, '--singleThreaded']),
    ),
  ])),
];
const passed = results.filter(Boolean).length;
const failed = results.length - passed;

// The reporter in test/support adds these to its own numbers in the closing line.
const env = { IRRADIA_CHECKS_PASSED: passed, IRRADIA_CHECKS_FAILED: failed };
const tests = await run([command('vitest', 'vitest.mjs'), 'run', ...process.argv.slice(2)], {
  env,
  isShown: true,
});
process.exitCode = failed ? 1 : tests.code;
