/** What a person does in the lab, one thing after another, and the tasks of the page's thread meanwhile. */
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { startStaticServer } from '../src/cli/static-server.ts';
import { pageHeaders } from '../src/page-policy.ts';
import { launchBrowser } from '../test/support/browser.ts';
import { repository } from '../vite.shared.config.ts';
import { type TaskTimes, traced } from './trace.ts';

export interface OperationTasks extends TaskTimes {
  readonly name: string;
}

export interface TasksRequest {
  /** Part of the names of the operations that are measured; what comes before them is done, but not measured. */
  readonly only: string;
  /** With what the long tasks are made of. */
  readonly profiled: boolean;
}

declare const irradia: {
  mirror: { settled(): Promise<void> };
  viewport: { nextFrame(): Promise<void> };
};

/** What is asked for has come, is drawn, and nothing follows. */
async function rest(page: Page): Promise<void> {
  await page.evaluate(async () => {
    for (let i = 0; i < 2; i++) {
      await irradia.mirror.settled();
      await irradia.viewport.nextFrame();
    }
  });
  await page.waitForTimeout(400);
}

export type Operation = readonly [name: string, run: (page: Page) => Promise<void>];

export const AREA = '.viewport canvas';

export async function middle(page: Page): Promise<{ x: number; y: number }> {
  const box = await page.locator(AREA).first().boundingBox();
  if (!box) throw new Error('the page has no viewport');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

export const press = (key: string) => async (page: Page) => {
  await page.keyboard.press(key);
};

/** Until an expression is true; asked from outside, as the page's policy wants it. */
export async function until(page: Page, expression: string): Promise<void> {
  while (!(await page.evaluate<boolean>(expression))) await page.waitForTimeout(30);
}

export const saveFile: Operation = [
  'save a file',
  async (page) => {
    const download = page.waitForEvent('download');
    await page.keyboard.press('Control+s');
    await (await download).path();
  },
];

/** Of documents whose name is Bench. */
export const openAnother: Operation = [
  'open another document',
  async (page) => {
    await page.click('.topbar >> text="File"');
    await page.click('.menu button >> text="New"');
    await until(page, 'irradia.store.document.name !== "Bench"');
  },
];

export const openAgain: Operation = [
  'open it again',
  async (page) => {
    await page.keyboard.press('Control+Shift+O');
    await page.locator('.document-card', { hasText: 'Bench' }).dblclick();
    await until(page, 'irradia.store.document.name === "Bench"');
  },
];

/** @param scene a document, which the page opens first */
export async function measureOperations(
  scene: unknown,
  operations: readonly Operation[],
  { only, profiled }: TasksRequest,
): Promise<readonly OperationTasks[]> {
  const server = await startStaticServer({
    folder: join(repository, 'dist/lab'),
    files: new Map([['/scene.json', JSON.stringify(scene)]]),
    headers: pageHeaders,
    port: 0,
  });
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage({ viewport: { width: 1200, height: 700 }, reducedMotion: 'reduce' });
    page.setDefaultTimeout(60_000);
    // The driver has no dialogs but the old ones.
    await page.addInitScript('delete window.showSaveFilePicker; delete window.showOpenFilePicker');
    await page.goto(`${server.url}?scene=/scene.json`);
    await page.evaluate('irradia.ready');
    await rest(page);
    const tasks: OperationTasks[] = [];
    const last = operations.findLastIndex(([name]) => name.includes(only));
    for (const [name, run] of operations.slice(0, last + 1)) {
      const whole = async () => {
        await run(page);
        await rest(page);
      };
      if (name.includes(only)) tasks.push({ name, ...(await traced(browser, page, profiled, whole)) });
      else await whole();
    }
    return tasks;
  } finally {
    await browser.close();
    await server.close();
  }
}
