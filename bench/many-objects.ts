/** Operations on a scene of many small objects, which share a few geometries and materials. */
import {
  AREA,
  measureOperations,
  type Operation,
  type OperationTasks,
  openAgain,
  openAnother,
  press,
  saveFile,
  type TasksRequest,
  until,
} from './operations.ts';

declare const irradia: {
  mirror: { settled(): Promise<void> };
  store: {
    document: { name: string; objects: Record<string, unknown>; groups: Record<string, unknown> };
  };
};

const SHAPES = [
  { type: 'sphere', radius: 0.3, widthSegments: 12, heightSegments: 8 },
  { type: 'box', width: 0.5, height: 0.5, depth: 0.5 },
  { type: 'cylinder', radiusTop: 0.25, radiusBottom: 0.25, height: 0.6, radialSegments: 12 },
  { type: 'torus', radius: 0.25, tube: 0.1, radialSegments: 6, tubularSegments: 12 },
];
const MATERIALS = 8;

/** In rows and columns on the ground. */
function sceneOf(objects: number): unknown {
  const columns = Math.ceil(Math.sqrt(objects));
  const place = (i: number) => [(i % columns) - columns / 2, 0.3, Math.floor(i / columns) - columns / 2];
  return {
    format: 'irradia',
    version: 1,
    name: 'Bench',
    camera: { position: [0, columns / 2, columns], target: [0, 0, 0] },
    materials: Object.fromEntries(
      Array.from({ length: MATERIALS }, (_, i) => [
        `m${i}`,
        {
          name: `Material ${i}`,
          model: 'principled',
          parameters: { roughness: i / MATERIALS },
        },
      ]),
    ),
    lights: { sun: { type: 'directional', name: 'Sun', position: [2, 4, 3], target: [0, 0, 0] } },
    objects: Object.fromEntries(
      Array.from({ length: objects }, (_, i) => [
        `o${i}`,
        {
          name: `Thing ${i}`,
          material: `m${i % MATERIALS}`,
          position: place(i),
          geometry: SHAPES[i % SHAPES.length],
        },
      ]),
    ),
    environment: { source: { type: 'sky' }, samples: 1 },
    view: { resolutionScale: 0.25 },
    pathTracing: { samples: 1 },
  };
}

const objects = (count: number) => `Object.keys(irradia.store.document.objects).length === ${count}`;

const operations = (count: number): readonly Operation[] => [
  ['click on one', async (page) => page.click('.outliner-row:has-text("Thing 3")')],
  [
    'edit one slider',
    async (page) => {
      const slider = page.locator('[data-parameter=roughness] input[type=range]');
      await slider.focus();
      for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
    },
  ],
  [
    'select all',
    async (page) => {
      await page.focus(AREA);
      await page.keyboard.press('Control+a');
    },
  ],
  [
    'move all with the keys',
    async (page) => {
      for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    },
  ],
  [
    'keep it in the browser',
    async (page) => void (await page.waitForSelector('.document-button[data-keep=kept]')),
  ],
  ['undo', press('Control+z')],
  ['redo', press('Control+Shift+z')],
  ['hide all', press('Shift+H')],
  ['show all', press('Control+Shift+H')],
  ['group all', press('Control+g')],
  ['ungroup', press('Control+Shift+G')],
  [
    'duplicate all',
    async (page) => {
      await page.keyboard.press('Control+d');
      await until(page, objects(2 * count));
    },
  ],
  ['delete them', press('Delete')],
  [
    'search in the outliner',
    async (page) => {
      await page.keyboard.press('Control+f');
      await page.keyboard.type('thing 19');
      await page.keyboard.press('Escape');
    },
  ],
  [
    'move one',
    async (page) => {
      await page.click('.outliner-row:has-text("Thing 5")');
      await page.focus(AREA);
      await page.keyboard.press('ArrowRight');
    },
  ],
  ['keep one change', async (page) => void (await page.waitForSelector('.document-button[data-keep=kept]'))],
  saveFile,
  [
    'share as a link',
    async (page) => {
      await page.click('.topbar >> text="File"');
      await page.click('.menu button >> text="Share as a link…"');
      await page.waitForSelector('dialog');
      await page.keyboard.press('Escape');
    },
  ],
  openAnother,
  openAgain,
];

export function measureManyObjects(count: number, request: TasksRequest): Promise<readonly OperationTasks[]> {
  return measureOperations(sceneOf(count), operations(count), request);
}
