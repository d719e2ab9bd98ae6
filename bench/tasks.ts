/**
 * Whether the page stays alive: for what a person does with a large mesh, the longest task of the page's thread. Times are
 * those of the thread's own clock in a trace of Chromium: what other programs take from it, and what it waits for a GPU of
 * software, which is a process of its own, is not in them.
 */
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { startStaticServer } from '../src/cli/static-server.ts';
import { pageHeaders } from '../src/page-policy.ts';
import { wavyGlb } from '../test/e2e/glb.ts';
import { launchBrowser } from '../test/support/browser.ts';
import { repository } from '../vite.shared.config.ts';

export interface OperationTasks {
  readonly name: string;
  /** Of the longest task, ms of the thread's own time. */
  readonly longest: number;
  /** How many took more than LONG. */
  readonly long: number;
  /** The longest by the clock on the wall, ms: with what else the machine does, and with waiting for the GPU. */
  readonly wall: number;
}

/** ms: what the page's thread should not spend at a stretch. */
export const LONG = 50;

/** Little work for the GPU: a sphere on a floor at a quarter of the resolution. */
const SCENE = {
  format: 'irradia',
  version: 1,
  name: 'Bench',
  camera: { position: [0, 2, 6], target: [0, 1, 0] },
  materials: { gloss: { name: 'Gloss', model: 'principled' } },
  lights: { sun: { type: 'directional', name: 'Sun', position: [2, 4, 3], target: [0, 0, 0] } },
  objects: {
    floor: {
      name: 'Floor',
      material: 'gloss',
      rotation: [-90, 0, 0],
      geometry: { type: 'plane', width: 8, height: 8 },
    },
  },
  environment: { source: { type: 'sky' }, samples: 1 },
  view: { resolutionScale: 0.25 },
  pathTracing: { samples: 1 },
};

interface Edited {
  objects: Record<string, { position: [number, number, number] }>;
  environment: { source: { turbidity: number; groundColor: [number, number, number] } };
}
declare const irradia: {
  ready: Promise<void>;
  mirror: { settled(): Promise<void> };
  viewport: { nextFrame(): Promise<void>; tracing: { state: { kind: string } } };
  store: {
    document: { name: string; objects: Record<string, { name: string }> };
    edit(label: string, recipe: (draft: Edited) => void): void;
  };
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

type Operation = readonly [name: string, run: (page: Page, model: string) => Promise<void>];

const AREA = '.viewport canvas';

async function middle(page: Page): Promise<{ x: number; y: number }> {
  const box = await page.locator(AREA).first().boundingBox();
  if (!box) throw new Error('the page has no viewport');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

const press = (key: string) => async (page: Page) => {
  await page.keyboard.press(key);
};

/** Until an expression is true; asked from outside, as the page's policy wants it. */
async function until(page: Page, expression: string): Promise<void> {
  while (!(await page.evaluate<boolean>(expression))) await page.waitForTimeout(30);
}

const OPERATIONS: readonly Operation[] = [
  [
    'import a GLB',
    async (page, model) => {
      const chooser = page.waitForEvent('filechooser');
      await page.keyboard.press('Control+o');
      await (await chooser).setFiles(model);
      await until(page, 'Object.keys(irradia.store.document.objects).length === 2');
    },
  ],
  ['select nothing', press('Escape')],
  [
    'click on it',
    async (page) => {
      const { x, y } = await middle(page);
      await page.mouse.click(x, y);
    },
  ],
  [
    'go round it',
    async (page) => {
      const { x, y } = await middle(page);
      await page.mouse.move(x + 220, y + 100);
      await page.mouse.down();
      await page.mouse.move(x + 240, y + 110, { steps: 5 });
      await page.mouse.up();
    },
  ],
  [
    'drag a material over it, drop it',
    async (page) => {
      await page.keyboard.press('m');
      await page.fill('.library input[type=search]', 'gold');
      await page.dragAndDrop('[data-material="library gold-polished"]', AREA);
      await page.keyboard.press('Escape');
    },
  ],
  [
    'select by a box, what it touches',
    async (page) => {
      const { x, y } = await middle(page);
      await page.keyboard.down('Shift');
      await page.mouse.move(x + 60, y + 60);
      await page.mouse.down();
      await page.mouse.move(x - 60, y - 60, { steps: 5 });
      await page.mouse.up();
      await page.keyboard.up('Shift');
    },
  ],
  [
    'select by a box, what is within',
    async (page) => {
      const { x, y } = await middle(page);
      await page.keyboard.press('Shift+Q');
      await page.mouse.move(x - 200, y - 200);
      await page.mouse.down();
      await page.mouse.move(x + 200, y + 200, { steps: 5 });
      await page.mouse.up();
      await page.keyboard.press('w');
    },
  ],
  ['look at it', press('f')],
  [
    'let it fall to the floor',
    async (page) => {
      await page.click('[data-entity^="objects/"]:has-text("Wavy")');
      await page.focus(AREA);
      await page.keyboard.press('End');
    },
  ],
  ['duplicate it', press('Control+d')],
  [
    'let it fall onto the other',
    async (page) => {
      await page.evaluate(() => {
        const id = Object.keys(irradia.store.document.objects).at(-1) as string;
        irradia.store.edit('Raise', (draft) => {
          (draft.objects[id] as Edited['objects'][string]).position = [0.4, 3, 0.2];
        });
      });
      await page.keyboard.press('End');
      await until(page, 'irradia.store.undoLabel?.startsWith("Drop") === true');
    },
  ],
  [
    'undo and redo',
    async (page) => {
      for (const key of ['Control+z', 'Control+z', 'Control+Shift+z', 'Control+Shift+z'])
        await page.keyboard.press(key);
    },
  ],
  [
    'haze of the sky',
    async (page) => {
      for (const turbidity of [3, 4, 5])
        await page.evaluate(async (value) => {
          irradia.store.edit('Haze', (draft) => {
            draft.environment.source.turbidity = value;
          });
          await irradia.mirror.settled();
        }, turbidity);
    },
  ],
  [
    'keep it in the browser',
    async (page) => {
      await page.waitForSelector('.document-button[data-keep=kept]');
    },
  ],
  [
    'documents, with a picture of this one',
    async (page) => {
      await page.keyboard.press('Control+Shift+O');
      await page.waitForSelector('.document-card[aria-current] img');
      await page.keyboard.press('Escape');
    },
  ],
  [
    'path trace',
    async (page) => {
      await page.keyboard.press('3');
      await until(page, 'irradia.viewport.tracing.state.kind === "picture"');
      await page.keyboard.press('1');
    },
  ],
  [
    'export a GLB',
    async (page) => {
      const download = page.waitForEvent('download');
      await page.click('.topbar >> text="File"');
      await page.click('.menu button >> text="Scene as GLB"');
      await (await download).path();
    },
  ],
  [
    'save a file',
    async (page) => {
      const download = page.waitForEvent('download');
      await page.keyboard.press('Control+s');
      await (await download).path();
    },
  ],
  [
    'share: too large for a link',
    async (page) => {
      await page.click('.topbar >> text="File"');
      await page.click('.menu button >> text="Share as a link…"');
      await page.waitForSelector('dialog >> text=Too large for a link');
      await page.keyboard.press('Escape');
    },
  ],
  [
    'open another document',
    async (page) => {
      await page.click('.topbar >> text="File"');
      await page.click('.menu button >> text="New"');
      await until(page, 'irradia.store.document.name !== "Bench"');
    },
  ],
  [
    'open it again',
    async (page) => {
      await page.keyboard.press('Control+Shift+O');
      await page.locator('.document-card', { hasText: 'Bench' }).dblclick();
      await until(page, 'irradia.store.document.name === "Bench"');
    },
  ],
];

/** @param triangles of the mesh */
export async function measureTasks(triangles: number, only?: string): Promise<readonly OperationTasks[]> {
  const folder = mkdtempSync(join(tmpdir(), 'irradia-bench-'));
  const model = join(folder, 'wavy.glb');
  writeFileSync(model, wavyGlb(triangles));
  const server = await startStaticServer({
    folder: join(repository, 'dist/lab'),
    files: new Map([['/scene.json', JSON.stringify(SCENE)]]),
    headers: pageHeaders,
    port: 0,
  });
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage({ viewport: { width: 1200, height: 700 }, reducedMotion: 'reduce' });
    page.setDefaultTimeout(120_000);
    await page.addInitScript('delete window.showSaveFilePicker');
    await page.goto(`${server.url}?scene=/scene.json`);
    await page.evaluate('irradia.ready');
    await rest(page);
    const tasks: OperationTasks[] = [];
    for (const [name, run] of OPERATIONS) {
      tasks.push({ name, ...(await traced(browser, page, () => run(page, model))) });
      if (name === only) break;
    }
    return tasks;
  } finally {
    await browser.close();
    await server.close();
    rmSync(folder, { recursive: true });
  }
}

interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  /** Microseconds by the thread's own clock. */
  readonly tdur?: number;
  /** Microseconds. */
  readonly dur?: number;
}

const MARK = 'irradia-bench';

async function traced(
  browser: Browser,
  page: Page,
  run: () => Promise<void>,
): Promise<Omit<OperationTasks, 'name'>> {
  await browser.startTracing(page, {
    categories: ['toplevel', 'blink.user_timing', 'disabled-by-default-devtools.timeline'],
  });
  await page.evaluate((mark) => void performance.mark(mark), MARK);
  await run();
  await rest(page);
  await page.evaluate((mark) => void performance.mark(mark), MARK);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString()) as {
    traceEvents: TraceEvent[];
  };
  const [first, last] = traceEvents.filter(({ name, ph }) => name === MARK && ph !== 'E');
  if (!first || !last) throw new Error('the trace lacks the marks of the page');
  const tasks = traceEvents.filter(
    ({ name, pid, tid, ts }) =>
      name === 'RunTask' && pid === first.pid && tid === first.tid && ts >= first.ts && ts <= last.ts,
  );
  const spent = tasks.map(({ tdur = 0 }) => tdur / 1000);
  return {
    longest: Math.max(0, ...spent),
    long: spent.filter((ms) => ms > LONG).length,
    wall: Math.max(0, ...tasks.map(({ dur = 0 }) => dur / 1000)),
  };
}
