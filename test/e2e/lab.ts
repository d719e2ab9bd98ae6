/** The built lab in a real browser, for tests that use it as a person does. */
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { BrowserContext, Locator, Page } from 'playwright-core';
import { afterAll, expect, vi } from 'vitest';
import { startStaticServer } from '../../src/cli/static-server.ts';
import { pageHeaders } from '../../src/page-policy.ts';
import type { Document } from '../../src/scene/schema.ts';
import { buildAll } from '../../tools/build.mjs';
import { testBrowser, watchErrors } from '../support/page.ts';

export interface LabOptions {
  /** What follows the address: `?scene=thesis`. */
  query?: string;
  /** Beside the lab's own files, by path. */
  files?: Readonly<Record<string, string>>;
  /** Documents in the place of scenes that ship, by name: those take long to draw in software. */
  scenes?: Readonly<Record<string, object>>;
  /** Runs before the page's own scripts. */
  init?: string;
  width?: number;
  height?: number;
  /** Another page of the same browser profile: what was kept there is kept here. */
  beside?: LabPage;
  /** Whether the page may install itself for use without a network. */
  serviceWorkers?: 'allow' | 'block';
  /** The browser's language, `en-US` without it. */
  locale?: string;
}

/** What is in a document; the rest are its defaults. */
type Content = Readonly<Record<string, unknown>> & { view?: object; environment?: object };

/**
 * What opens a document that a GPU made of software draws at once: a test that looks at something other than the scenes that
 * ship opens one of its own, with no more in it than it needs.
 */
export function small(content: Content = {}, { files, ...options }: LabOptions = {}): LabOptions {
  const document = {
    ...{ format: 'irradia', version: 1, name: 'Small', ...content },
    view: { resolutionScale: 0.25, ...content.view },
    environment: { samples: 2, ...content.environment },
  };
  return {
    query: '?scene=/small.json',
    files: { '/small.json': JSON.stringify(document), ...files },
    ...options,
  };
}

/** For small(): a matt ball in the sun. */
export const CLAY_BALL = {
  camera: { position: [0, 1, 4], target: [0, 0, 0] },
  lights: { key: { type: 'directional', position: [2, 4, 5] } },
  materials: { clay: { name: 'Clay', model: 'lambert' } },
  objects: { ball: { name: 'Ball', material: 'clay', geometry: { type: 'sphere' } } },
};

export interface Lab {
  open(options?: LabOptions): Promise<LabPage>;
}

/** Small, because the GPU is made of software. */
const SIZE = { width: 900, height: 520 };

let building: ReturnType<typeof buildLab> | undefined;

export async function openLab(): Promise<Lab> {
  // Once for all files that share this process.
  building ??= buildLab();
  const built = await building;
  const browser = await testBrowser();
  const contexts: BrowserContext[] = [];
  const servers: { close(): Promise<void> }[] = [];
  afterAll(async () => {
    for (const context of contexts) await context.close();
    for (const server of servers) await server.close();
  });
  return {
    async open({ query = '', files = {}, init, width = SIZE.width, height = SIZE.height, ...options } = {}) {
      const { beside, scenes = {}, serviceWorkers = 'block', locale = 'en-US' } = options;
      let { url, endServer, served } = beside ?? {};
      if (url === undefined || endServer === undefined || served === undefined) {
        served = new Map([...built, ...Object.entries(files)]);
        const server = await startStaticServer({ files: served, headers: pageHeaders, port: 0 });
        servers.push(server);
        url = server.url;
        endServer = () => server.close();
      }
      for (const [name, document] of Object.entries(scenes)) {
        const path = [...built.keys()].find((path) =>
          new RegExp(`^/assets/${name}-[\\w-]{8}\\.js$`).test(path),
        );
        if (path === undefined) throw new Error(`no scene that ships is called ${name}`);
        served.set(path, `export default ${JSON.stringify(document)}`);
      }
      const viewport = { width, height };
      const context =
        beside?.page.context() ??
        (await browser.newContext({
          viewport,
          acceptDownloads: true,
          serviceWorkers,
          locale,
          reducedMotion: 'reduce',
        }));
      if (!beside) contexts.push(context);
      // Only catches a hang: pages next to it keep both cores busy.
      context.setDefaultTimeout(120_000);
      const page = await context.newPage();
      const errors = watchErrors(page);
      // Nobody is there to answer the browser's own dialogs; without them, opening is an input and saving a download.
      await page.addInitScript('delete window.showSaveFilePicker; delete window.showOpenFilePicker');
      await page.addInitScript(NOTE_TOASTS);
      if (init) await page.addInitScript(init);
      await page.goto(`${url}${query}`);
      return new LabPage(page, errors, url, endServer, served);
    },
  };
}

/** Notes what messages say: most go after some seconds, which on a busy machine may be before a test looks. */
const NOTE_TOASTS = `
  window.toastsSaid = [];
  new MutationObserver((records) => {
    for (const { addedNodes } of records)
      for (const node of addedNodes)
        if (node instanceof Element && node.matches('.toast:not(.progress)')) toastsSaid.push(node.textContent);
  }).observe(document, { subtree: true, childList: true });`;

export interface Picture {
  /** Of every pixel. */
  hash: string;
  /** How many colours it has. */
  colors: number;
}

export class LabPage {
  constructor(
    readonly page: Page,
    /** What the page reported as an error so far. */
    readonly errors: string[],
    readonly url: string,
    /** From then on there is no network. */
    readonly endServer: () => Promise<void>,
    /** What its server has, by path. */
    readonly served: Map<string, Uint8Array | string>,
  ) {}

  async ready(): Promise<this> {
    // A page in another language waits for its words, which the load event does not.
    await this.until(`typeof irradia === 'object'`);
    await this.page.evaluate('irradia.ready');
    return this;
  }

  document(): Promise<Document> {
    return this.page.evaluate('irradia.store.document');
  }

  /** The picture of the present document, once everything in it is there and compiled: a frame alone waits two seconds for that. */
  picture(): Promise<Picture> {
    return this.page.evaluate(`(async () => {
      const { mirror, viewport, renderer, store } = irradia;
      await mirror.settled();
      await viewport.whole();
      await viewport.nextFrame();
      const pixels = await renderer.readImage(store.document.view);
      const digest = await crypto.subtle.digest('SHA-256', pixels);
      return {
        hash: [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join(''),
        colors: new Set(new Uint32Array(pixels.buffer, pixels.byteOffset, pixels.length / 4)).size,
      };
    })()`);
  }

  /** Waits until an expression is true. Asked from outside: the page's policy lets no text become script in it. */
  async until(expression: string): Promise<void> {
    await vi.waitFor(async () => expect(await this.page.evaluate(expression)).toBe(true), {
      timeout: 120_000,
      interval: 30,
    });
  }

  /** Lets files fall on the page, or on one element of it. */
  async drop(
    files: readonly { name: string; content: Uint8Array | string }[],
    selector = '.viewport',
  ): Promise<void> {
    // The page fetches them: a measurement of 35 MB is slow to send as text.
    const list = files.map(({ name, content }, i) => {
      const path = `/dropped-${i}`;
      this.served.set(path, content);
      return { name, path };
    });
    const transfer = await this.page.evaluateHandle(async (list) => {
      const dataTransfer = new DataTransfer();
      for (const { name, path } of list) {
        const response = await fetch(path, { cache: 'no-store' });
        if (!response.ok) throw new Error(`${path}: ${response.status}`);
        dataTransfer.items.add(new File([await response.arrayBuffer()], name));
      }
      return dataTransfer;
    }, list);
    for (const type of ['dragover', 'drop']) {
      await this.page.dispatchEvent(selector, type, { dataTransfer: transfer });
    }
  }

  async menu(name: 'File' | 'Edit' | 'Add', item: string): Promise<void> {
    await this.page.click(`.topbar >> text="${name}"`);
    await this.page.click(`.menu button >> text="${item}"`);
  }

  /** Selects it in the outliner, and waits for its fields: the inspector makes them in a task of their own. */
  async select(kind: 'lights' | 'objects' | 'materials', id: string): Promise<void> {
    await this.page.click(`[data-entity="${kind}/${id}"]`);
    await this.inspector().waitFor({ state: 'attached' });
  }

  /** What the inspector shows of what is selected now; those fields that go with what was selected before cannot be used. */
  inspector(): Locator {
    return this.page.locator('.inspector-body:not([inert])');
  }

  /** The messages on the screen. */
  toasts(): Promise<string[]> {
    return this.page.locator('.toast:not(.progress)').allInnerTexts();
  }

  /** Waits for a message in which this stands, though it may have gone again; each is found once. */
  waitForToast(text: string): Promise<void> {
    return vi.waitFor(
      async () => {
        const isSaid = await this.page.evaluate(`(() => {
          const at = toastsSaid.findIndex((said) => said.includes(${JSON.stringify(text)}));
          return at >= 0 && toastsSaid.splice(at, 1).length === 1;
        })()`);
        if (!isSaid) throw new Error(`no message said “${text}”`);
      },
      { timeout: 120_000, interval: 30 },
    );
  }

  /** Takes what a message offers, before it goes. */
  takeOffer(label: string): Promise<void> {
    return this.until(`(() => {
      const offers = [...document.querySelectorAll('.toast .text-button')];
      const offer = offers.find(({ textContent }) => textContent === ${JSON.stringify(label)});
      offer?.click();
      return offer !== undefined;
    })()`);
  }

  /** Drags a slider with the mouse to a part of its track, in several steps. */
  async dragSlider(selector: string, to: number): Promise<void> {
    const range = this.page.locator(`${selector} input[type=range]`);
    await range.scrollIntoViewIfNeeded();
    const box = await range.boundingBox();
    if (!box) throw new Error(`no slider at ${selector}`);
    const y = box.y + box.height / 2;
    await this.page.mouse.move(box.x + box.width / 2, y);
    await this.page.mouse.down();
    await this.page.mouse.move(box.x + box.width * (0.5 + (to - 0.5) / 2), y);
    await this.page.mouse.move(box.x + box.width * to, y);
    await this.page.mouse.up();
  }
}

/** The lab as it ships, built anew only if it is older than its sources. */
async function buildLab(): Promise<Map<string, Uint8Array | string>> {
  await buildAll(['lab'], { ifStale: true });
  const folder = fileURLToPath(new URL('../../dist/lab/', import.meta.url));
  const names = readdirSync(folder, { recursive: true, encoding: 'utf8' });
  const files = names.filter((name) => !name.endsWith('.map') && statSync(join(folder, name)).isFile());
  return new Map(files.map((name) => [`/${name.replaceAll('\\', '/')}`, readFileSync(join(folder, name))]));
}
