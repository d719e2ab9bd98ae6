/**
 * Builds what ships: `node tools/build.mjs [--if-stale] [lab|lib|cli ...]`.
 *
 * Each part is built beside its place and then moved into it, so that a page being served or a test
 * being run never sees half a build.
 */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readdirSync, renameSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));

const parts = {
  lab: { config: 'vite.config.ts', entry: 'src/editor/index.html' },
  lib: { config: 'vite.lib.config.ts', entry: 'src/index.ts' },
  cli: { config: 'vite.cli.config.ts', entry: 'src/cli/main.ts' },
};

/** What the builds are made of; a change in any of it makes them stale. */
const inputs = [
  ...['src', 'models', 'scenes', 'lessons', 'package-lock.json', 'tools/build.mjs'],
  ...[
    'vite.shared.config.ts',
    'vite.licences.config.ts',
    'tsconfig.base.json',
    'tsconfig.json',
    'tsconfig.lib.json',
  ],
  ...Object.values(parts).map((part) => part.config),
];

const stamp = (name) => join(root, 'dist', name, '.built');

function newest(path) {
  if (!existsSync(path)) return 0;
  const stat = statSync(path);
  if (!stat.isDirectory()) return stat.mtimeMs;
  // A folder's own time tells of what was deleted in it.
  return readdirSync(path).reduce((time, name) => Math.max(time, newest(join(path, name))), stat.mtimeMs);
}

export function isStale(name) {
  if (!existsSync(stamp(name))) return true;
  return newest(stamp(name)) < Math.max(...inputs.map((input) => newest(join(root, input))));
}

async function buildPart(name) {
  const { build } = await import('vite');
  const { config, entry } = parts[name];
  if (!existsSync(join(root, entry))) {
    console.warn(`${name}: skipped, there is no ${entry}`);
    return;
  }
  const started = new Date();
  const place = join(root, 'dist', name);
  const fresh = `${place}.new-${process.pid}`;
  const old = `${place}.old-${process.pid}`;
  await build({ configFile: join(root, config), logLevel: 'warn', build: { outDir: fresh } });
  if (name === 'lib') {
    const tsc = join(dirname(fileURLToPath(import.meta.resolve('typescript/package.json'))), 'bin/tsc');
    const options = ['-p', join(root, 'tsconfig.lib.json'), '--outDir', join(fresh, 'types')];
    // Threads would each work out the types of three.js.
    const child = spawn(process.execPath, [tsc, ...options, '--singleThreaded'], { stdio: 'inherit' });
    const [code] = await once(child, 'close');
    if (code !== 0) throw new Error('lib: tsc made no type declarations; see above');
  }
  writeFileSync(join(fresh, '.built'), '');
  // Sources that changed while they were being built count as newer than the build.
  utimesSync(join(fresh, '.built'), started, started);
  if (existsSync(place)) renameSync(place, old);
  renameSync(fresh, place);
  rmSync(old, { recursive: true, force: true });
  console.log(`${name}: built into dist/${name}`);
}

export async function buildAll(names, { ifStale = false } = {}) {
  await Promise.all(names.filter((name) => !ifStale || isStale(name)).map(buildPart));
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const words = process.argv.slice(2);
  const names = words.filter((word) => word !== '--if-stale');
  const unknown = names.find((name) => !Object.hasOwn(parts, name));
  if (unknown) {
    console.error(`build: unknown part '${unknown}'; expected ${Object.keys(parts).join(', ')}`);
    process.exit(1);
  }
  await buildAll(names.length ? names : Object.keys(parts), { ifStale: words.includes('--if-stale') });
}
