import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page, Response } from 'playwright-core';
import { startStaticServer } from '../src/cli/static-server.ts';
import type { Model } from '../src/glsl/model.ts';
import type { Document } from '../src/scene/schema.ts';
import { launchBrowser } from '../test/support/browser.ts';
import { repository } from '../vite.shared.config.ts';

/** What the page offers to a console, as far as it is used here. */
interface Lab {
  ready: Promise<void>;
  store: {
    document: Document;
    edit(label: string, recipe: (draft: { materials: Record<string, EditedMaterial> }) => void): void;
  };
  mirror: { settled(): Promise<void>; materialFor(id: string): { model: Model } | undefined };
  viewport: { nextFrame(): Promise<void> };
}
interface EditedMaterial {
  parameters: Record<string, unknown>;
}
declare const irradia: Lab;
declare const compiled: { count: number };

export interface LabResult {
  /** From navigation until the default scene is complete on the screen, in ms. */
  readyMs: number;
  /** JavaScript that the page loaded by then: what it names itself, and loaders, workers and data that it asked for. */
  scripts: { name: string; gzipBytes: number; isNamedByPage: boolean }[];
  /** Shaders, programs and pipelines made because a parameter changed. */
  compiledByChange: number;
}

/** In a browser of its own, so that no cache is warm. */
export async function measureLab(): Promise<LabResult> {
  const server = await startStaticServer({ folder: join(repository, 'dist/lab'), port: 0 });
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
    await page.addInitScript(countCompilations);
    const scripts = collectScripts(page);
    await page.goto(server.url);
    const readyMs = await page.evaluate(async () => {
      await irradia.ready;
      return performance.now();
    });
    const compiledByChange = await page.evaluate(changeParameters);
    return { readyMs, scripts: await scripts(), compiledByChange };
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Runs on the page before anything else does. */
function countCompilations(): void {
  const counter = { count: 0 };
  Object.assign(window, { compiled: counter });
  const count = <T extends object>(prototype: T | undefined, names: (keyof T)[]) => {
    for (const name of names) {
      const original = prototype?.[name] as unknown as (...values: unknown[]) => unknown;
      if (!prototype || !original) continue;
      prototype[name] = function (this: unknown, ...values: unknown[]) {
        counter.count++;
        return original.apply(this, values);
      } as unknown as T[typeof name];
    }
  };
  const gpu = [
    'createShaderModule',
    'createRenderPipeline',
    'createRenderPipelineAsync',
    'createComputePipeline',
  ] as const;
  count(globalThis.GPUDevice?.prototype, [...gpu]);
  count(WebGL2RenderingContext.prototype, ['compileShader', 'linkProgram']);
}

/** Runs on the page: moves three numbers of every material, a frame each. */
async function changeParameters(): Promise<number> {
  // What came last is drawn, and so compiled, by now.
  await irradia.mirror.settled();
  await irradia.viewport.nextFrame();
  await irradia.viewport.nextFrame();
  const before = compiled.count;
  for (const id of Object.keys(irradia.store.document.materials)) {
    const parameters = irradia.mirror.materialFor(id)?.model.parameters ?? [];
    for (const parameter of parameters.filter(({ type }) => type === 'float').slice(0, 3)) {
      if (parameter.type !== 'float') continue;
      irradia.store.edit('Bench', (draft) => {
        const values = draft.materials[id]?.parameters ?? {};
        values[parameter.name] = parameter.min + 0.37 * (parameter.max - parameter.min);
      });
      await irradia.viewport.nextFrame();
    }
  }
  return compiled.count - before;
}

/** The scripts that came by the time of the call. */
function collectScripts(page: Page): () => Promise<LabResult['scripts']> {
  const responses: Response[] = [];
  page.on('response', (response) => {
    if (response.headers()['content-type']?.startsWith('text/javascript')) responses.push(response);
  });
  const html = readFileSync(join(repository, 'dist/lab/index.html'), 'utf8');
  return () =>
    Promise.all(
      responses.map(async (response) => {
        const name = new URL(response.url()).pathname;
        const gzipBytes = gzipSync(await response.body()).length;
        return { name, gzipBytes, isNamedByPage: html.includes(basename(name)) };
      }),
    );
}
