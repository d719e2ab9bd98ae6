/** Operations on a mesh of many triangles. */
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { wavyGlb } from '../test/e2e/glb.ts';
import {
  AREA,
  measureOperations,
  middle,
  type Operation,
  type OperationTasks,
  openAgain,
  openAnother,
  press,
  saveFile,
  type TasksRequest,
  until,
} from './operations.ts';

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
  mirror: { settled(): Promise<void> };
  store: {
    document: { name: string; objects: Record<string, { name: string }> };
    edit(label: string, recipe: (draft: Edited) => void): void;
  };
};

const operations = (model: string): readonly Operation[] => [
  [
    'import a GLB',
    async (page) => {
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
  saveFile,
  [
    'share: too large for a link',
    async (page) => {
      await page.click('.topbar >> text="File"');
      await page.click('.menu button >> text="Share as a link…"');
      await page.waitForSelector('dialog >> text=Too large for a link');
      await page.keyboard.press('Escape');
    },
  ],
  openAnother,
  openAgain,
];

/** @param triangles of the mesh */
export async function measureLargeMesh(
  triangles: number,
  request: TasksRequest,
): Promise<readonly OperationTasks[]> {
  const folder = mkdtempSync(join(tmpdir(), 'irradia-bench-'));
  try {
    const model = join(folder, 'wavy.glb');
    writeFileSync(model, wavyGlb(triangles));
    return await measureOperations(SCENE, operations(model), request);
  } finally {
    rmSync(folder, { recursive: true });
  }
}
