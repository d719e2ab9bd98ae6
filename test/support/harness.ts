import { fileURLToPath } from 'node:url';
import type { Browser, Page } from 'playwright-core';
import { type Alias, build } from 'vite';
import { startStaticServer } from '../../src/cli/static-server.ts';
import { alias, packageAlias, repository, target } from '../../vite.shared.config.ts';
import { launchBrowser } from './browser.ts';

/**
 * Runs a TypeScript file in a real browser. The file's default export is an async function of one JSON value
 * that returns a JSON value. Each run gets a fresh page. An error on the page, and anything it logs as an
 * error, fails the run.
 */
export interface PageHarness {
  run<Result>(argument?: unknown): Promise<Result>;
  close(): Promise<void>;
}

/** @param shared a browser to run in, which stays open; one of its own if not given */
export async function openHarness(entry: URL, shared?: Browser): Promise<PageHarness> {
  const files = new Map<string, Uint8Array | string>(await bundle(fileURLToPath(entry)));
  files.set(
    '/index.html',
    '<!doctype html><html lang="en"><script type="module" src="main.js"></script></html>',
  );
  const server = await startStaticServer({ files, port: 0 });
  const browser = shared ?? (await launchBrowser());
  return {
    run: <Result>(argument?: unknown) => runPage<Result>(browser, server.url, argument),
    async close() {
      if (!shared) await browser.close();
      await server.close();
    },
  };
}

async function runPage<Result>(browser: Browser, url: string, argument: unknown): Promise<Result> {
  const page = await browser.newPage({ viewport: { width: 640, height: 360 } });
  try {
    const errors = watchErrors(page);
    // Only catches a hang: the first page of a browser may wait for others that are being started.
    await page.goto(url, { timeout: 120_000 });
    // A string, because Vitest rewrites the import() of a function. The result comes as one, too: Playwright looks at each
    // number of a picture several times on its way.
    const call = `import('./main.js')
      .then((m) => m.default(${JSON.stringify(argument) ?? ''}))
      .then((result) => JSON.stringify(result, (_, value) =>
        typeof value === 'number' && !Number.isFinite(value) ? { ${NOT_FINITE}: String(value) } : value))`;
    const text = await page.evaluate<string | undefined>(call);
    if (errors.length) throw new Error(`the page reported:\n${errors.join('\n')}`);
    return (text === undefined ? undefined : parse(text)) as Result;
  } finally {
    await page.close();
  }
}

/** JSON has no such numbers; a test is to see them. */
const NOT_FINITE = 'numberThatIsNotFinite';

function parse(text: string): unknown {
  if (!text.includes(NOT_FINITE)) return JSON.parse(text);
  return JSON.parse(text, (_, value) =>
    value?.[NOT_FINITE] === undefined ? value : Number(value[NOT_FINITE]),
  );
}

/** Collects what the page says went wrong, from now on. */
export function watchErrors(page: Page): string[] {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  page.on('console', (message) => {
    // Browsers ask for this one by themselves.
    if (message.type() === 'error' && !message.location().url.endsWith('/favicon.ico'))
      errors.push(message.text());
  });
  return errors;
}

async function bundle(entry: string): Promise<[string, Uint8Array | string][]> {
  const result = await build({
    configFile: false,
    root: repository,
    publicDir: false,
    logLevel: 'warn',
    resolve: { alias: [...(alias as Alias[]), packageAlias] },
    build: {
      target,
      write: false,
      minify: false,
      chunkSizeWarningLimit: 10_000,
      rolldownOptions: {
        input: { main: entry },
        preserveEntrySignatures: 'strict',
        output: { entryFileNames: '[name].js' },
      },
    },
  });
  const { output } = result as {
    output: { fileName: string; code?: string; source?: Uint8Array | string }[];
  };
  return output.map((file) => [`/${file.fileName}`, file.code ?? file.source ?? '']);
}
