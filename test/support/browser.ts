import { spawnSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, chromium } from 'playwright-core';
import { loadSharedLibrary } from '../../src/cli/shared-library.ts';
import { chromiumPackage, readBrotli, unpackOnce, unpackTar } from '../../src/cli/unpack.ts';

/**
 * A headless browser for tests and benchmarks: an installed Chrome or Chromium (the one CHROME_PATH names
 * first), otherwise the one inside the npm package @sparticuz/chromium, which needs Linux on x64.
 */
export async function launchBrowser(): Promise<Browser> {
  const { executablePath, env } = installedBrowser() ?? packagedBrowser();
  return chromium.launch({
    executablePath,
    env: { ...process.env, ...env } as Record<string, string>,
    args: process.env.IRRADIA_TEST_DEVICE === 'gpu' ? GPU_FLAGS : SOFTWARE_FLAGS,
  });
}

const GPU_FLAGS = ['--no-sandbox', '--enable-unsafe-webgpu', '--enable-features=Vulkan'];

/**
 * The software GPU, for WebGL and WebGPU alike. Without the last two a WebGPU canvas loses its device.
 * What the page draws beside them (text, menus, plots) goes past it: shaders that a processor runs are a slow way to fill a
 * rectangle, and took half of the time of the tests.
 */
const SOFTWARE_FLAGS = [
  '--no-sandbox',
  '--disable-gpu-rasterization',
  '--disable-accelerated-2d-canvas',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
];

interface Executable {
  executablePath: string;
  env: Record<string, string>;
}

function installedBrowser(): Executable | null {
  const named = process.env.CHROME_PATH;
  if (named) return { executablePath: named, env: {} };
  const apps = [
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
  ];
  const commands = ['google-chrome', 'google-chrome-stable', 'chromium', 'chromium-browser'];
  const found =
    apps.find((path) => existsSync(path)) ??
    commands.map((name) => spawnSync('which', [name], { encoding: 'utf8' }).stdout?.trim()).find(Boolean);
  return found ? { executablePath: found, env: {} } : null;
}

function packagedBrowser(): Executable {
  if (process.platform !== 'linux' || process.arch !== 'x64') {
    throw new Error('no Chrome or Chromium was found; install one, or name it in CHROME_PATH');
  }
  const { archives, version } = chromiumPackage();
  const folder = unpackOnce(`chromium-${version}`, (fresh) => {
    writeFileSync(join(fresh, 'chromium'), readBrotli(join(archives, 'chromium.br')), { mode: 0o755 });
    for (const name of ['swiftshader', 'al2023', 'fonts']) {
      unpackTar(readBrotli(join(archives, `${name}.tar.br`)), fresh);
    }
  });
  const env: Record<string, string> = {};
  // The package carries NSS and fonts too, for bare systems that have none.
  if (!loadSharedLibrary('libnss3.so')) env.LD_LIBRARY_PATH = join(folder, 'lib');
  if (!existsSync('/etc/fonts/fonts.conf')) {
    env.FONTCONFIG_PATH = folder;
    const directories = `<dir>${join(folder, 'fonts')}</dir><cachedir>${join(folder, 'font-cache')}</cachedir>`;
    writeFileSync(join(folder, 'fonts.conf'), `<?xml version="1.0"?><fontconfig>${directories}</fontconfig>`);
  }
  return { executablePath: join(folder, 'chromium'), env };
}
