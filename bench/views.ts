/** The bench of BRDFs in the built lab: how often its views are drawn while a slider moves, beside the plain viewport. */
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { startStaticServer } from '../src/cli/static-server.ts';
import { type BenchView, initialSettings, views } from '../src/editor/panels/bench/settings.ts';
import { launchBrowser } from '../test/support/browser.ts';
import { repository } from '../vite.shared.config.ts';

export interface ViewRates {
  /** Frames of the viewport per second without the bench, just before and just after. */
  readonly plain: number;
  /** One view in the dock, or the six of a full page. */
  readonly views: readonly BenchView[];
  /** Frames of the viewport per second; on the full page, which covers it, 0. */
  readonly viewport: number;
  /** Of the page's main thread for one step of the slider, ms of processor time: what else the machine does is not in it. */
  readonly busy: number;
  /** Drawings per second with something new in them, of each view. */
  readonly plots: readonly number[];
}

/**
 * Little work for the GPU, so that the viewport is as fast as can be: what a view may take is then least. One sphere
 * and one light, at a quarter of the resolution.
 */
const SCENE = {
  format: 'irradia',
  version: 1,
  materials: { gloss: { name: 'Gloss', model: 'principled', parameters: { roughness: 0.5 } } },
  lights: { sun: { type: 'directional', name: 'Sun', position: [2, 4, 3], target: [0, 0, 0] } },
  objects: { ball: { name: 'Ball', material: 'gloss', geometry: { type: 'sphere' } } },
  view: { resolutionScale: 0.25 },
};

/** Between the end of one drag and the next: workers come to rest. */
const REST_MS = 500;
const DRAWN = views.filter((view) => view !== 'verdict');
const PAGES: readonly (readonly BenchView[])[] = [
  initialSettings.panes,
  DRAWN.filter((view) => !initialSettings.panes.includes(view) && view !== 'fresnel').slice(0, 6),
];

/** Runs on the page before anything else does: counts what is drawn. */
function countDrawings(): void {
  const drawn = { viewport: 0, plots: new Map<Element, number>() };
  Object.assign(window, { drawn });
  // A plot begins with a fresh canvas.
  const width = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, 'width');
  Object.defineProperty(HTMLCanvasElement.prototype, 'width', {
    ...width,
    set(this: HTMLCanvasElement, value: number) {
      if (this.matches('.bench-plot')) drawn.plots.set(this, (drawn.plots.get(this) ?? 0) + 1);
      width?.set?.call(this, value);
    },
  });
}

interface Drawn {
  viewport: number;
  plots: Map<Element, number>;
}
declare const drawn: Drawn;
declare const irradia: {
  ready: Promise<void>;
  mirror: { settled(): Promise<void> };
  renderer: { render(...values: unknown[]): void };
};

/** Runs on the page: moves the slider to and fro, once in every animation frame. */
async function drag(milliseconds: number): Promise<{ steps: number; viewport: number; plots: number[] }> {
  const range = document.querySelector<HTMLInputElement>('[data-parameter=roughness] input[type=range]');
  if (!range) throw new Error('no slider for roughness');
  const nextFrame = () => new Promise(requestAnimationFrame);
  const step = (i: number) => {
    // 0.2 to 0.8 and back, in 240 frames.
    range.value = String(Math.round(500 + 300 * Math.sin((2 * Math.PI * i) / 240)));
    range.dispatchEvent(new Event('input'));
  };
  // What the first frames make, such as another size of the picture, is no part of a drag.
  for (let i = 0; i < 10; i++) {
    step(i);
    await nextFrame();
  }
  drawn.viewport = 0;
  drawn.plots.clear();
  const begin = performance.now();
  let steps = 0;
  for (; performance.now() < begin + milliseconds; steps++) {
    step(10 + steps);
    await nextFrame();
  }
  const perSecond = 1000 / (performance.now() - begin);
  const plots = [...document.querySelectorAll('.bench-plot')].map((canvas) => drawn.plots.get(canvas) ?? 0);
  return { steps, viewport: drawn.viewport * perSecond, plots: plots.map((count) => count * perSecond) };
}

async function openPage(page: Page, url: string): Promise<void> {
  await page.addInitScript(countDrawings);
  await page.goto(url);
  await page.evaluate(async () => {
    await irradia.ready;
    await irradia.mirror.settled();
    const { render } = irradia.renderer;
    irradia.renderer.render = (...values) => {
      drawn.viewport++;
      render.apply(irradia.renderer, values);
    };
  });
}

/** Seconds that the page's main thread has worked so far. */
async function processorTimeOf(page: Page): Promise<() => Promise<number>> {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return metrics.find(({ name }) => name === 'TaskDuration')?.value ?? 0;
  };
}

/** @param milliseconds of each drag */
export async function measureViews(milliseconds: number): Promise<readonly ViewRates[]> {
  const server = await startStaticServer({
    folder: join(repository, 'dist/lab'),
    files: new Map([['/scene.json', JSON.stringify(SCENE)]]),
    port: 0,
  });
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    await openPage(page, `${server.url}?scene=/scene.json`);
    await page.locator('[data-entity^="materials/"]').first().click();
    const processorTime = await processorTimeOf(page);
    const measure = async () => {
      await page.waitForTimeout(REST_MS);
      const begin = await processorTime();
      const { steps, ...rates } = await page.evaluate(drag, milliseconds);
      return { ...rates, busy: (1000 * ((await processorTime()) - begin)) / steps };
    };
    const rates: ViewRates[] = [];
    let before = (await measure()).viewport;
    /** With the bench as the keys show it. */
    const between = async (views: readonly BenchView[], key: string, choose: () => Promise<void>) => {
      await page.keyboard.press(key);
      await choose();
      const rate = await measure();
      await page.keyboard.press('b');
      const after = (await measure()).viewport;
      rates.push({ views, plain: (before + after) / 2, ...rate });
      before = after;
    };
    for (const view of DRAWN) await between([view], 'b', () => page.click(`[data-view=${view}]`));
    for (const panes of PAGES) {
      await between(panes, 'Shift+B', async () => {
        for (const [i, view] of panes.entries()) {
          await page.selectOption(`[aria-label="View ${i + 1}"]`, view);
        }
      });
    }
    return rates;
  } finally {
    await browser.close();
    await server.close();
  }
}
