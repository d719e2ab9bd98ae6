/** Rows of the outliner put into another order, by the mouse and by keys. */
import { beforeAll, beforeEach, expect, it } from 'vitest';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();

const COUNT = 60;
const scene = JSON.stringify({
  format: 'irradia',
  version: 1,
  name: 'Many boxes',
  camera: { position: [0, 2, 8], target: [0, 0, 0] },
  view: { resolutionScale: 0.25 },
  materials: { clay: { name: 'Clay', model: 'lambert' } },
  groups: { pair: { name: 'Pair' } },
  objects: Object.fromEntries(
    Array.from({ length: COUNT }, (_, i) => [
      `b${i + 1}`,
      {
        name: `Box ${i + 1}`,
        material: 'clay',
        position: [i % 9, 0, -Math.floor(i / 9)],
        group: i < 2 ? 'pair' : null,
        geometry: { type: 'box' },
      },
    ]),
  ),
});

let page: LabPage;
beforeAll(async () => {
  page = await (await lab.open({ query: '?scene=/order.json', files: { '/order.json': scene } })).ready();
});
beforeEach(async () => {
  await page.page.evaluate('irradia.store.goTo(0)');
  await page.page.locator('.outliner-scroll').evaluate((element) => element.scrollTo(0, 0));
  await page.page.locator('.scene-row').click();
});

const row = (id: string) => page.page.locator(`[data-entity="objects/${id}"]`);
const order = async (count = 6) =>
  Object.keys((await page.document()).objects)
    .slice(0, count)
    .join(' ');
const press = (keys: string) => page.page.keyboard.press(keys);

/** Takes a row to a part of another one's height, and holds it there. */
async function drag(from: string, to: string, part: number): Promise<void> {
  const { mouse } = page.page;
  await row(from).hover();
  await mouse.down();
  const box = (await page.page.locator(to).boundingBox())!;
  await mouse.move(box.x + 60, box.y + part * box.height, { steps: 4 });
  await page.page.locator('.drop-line:not([hidden]), .drop-into').first().waitFor();
}

it('lets a row land between others, where the line is, and undoes it', async () => {
  await drag('b5', '[data-entity="objects/b3"]', 0.1);
  const [line, target] = [page.page.locator('.drop-line'), await row('b3').boundingBox()];
  await expect.poll(async () => (await line.boundingBox())?.y).toBeCloseTo(target!.y - 1, 0);
  await page.page.mouse.up();
  expect(await order()).toBe('b1 b2 b5 b3 b4 b6');
  await line.waitFor({ state: 'hidden' });
  await press('Control+z');
  expect(await order()).toBe('b1 b2 b3 b4 b5 b6');
});

it('takes all that is selected into a group and keeps it selected', async () => {
  await row('b4').click();
  await row('b6').click({ modifiers: ['Control'] });
  await drag('b4', '[data-group=pair]', 0.5);
  await page.page.locator('[data-group=pair].drop-into').waitFor();
  await page.page.mouse.up();
  const { objects } = await page.document();
  expect(Object.keys(objects).filter((id) => objects[id]?.group === 'pair')).toEqual([
    'b1',
    'b2',
    'b4',
    'b6',
  ]);
  expect(await page.page.locator('.outliner-row.selected[data-entity]').count()).toBe(2);
});

it('takes what is in a group out of it when one of its rows is dragged, and with the last the group goes', async () => {
  await page.page.locator('[data-group=pair]').click();
  await drag('b1', '[data-entity="objects/b4"]', 0.1);
  await page.page.mouse.up();
  expect(await order()).toBe('b3 b1 b2 b4 b5 b6');
  expect((await page.document()).groups).toEqual({});
});

it('scrolls while a row is held at the edge', async () => {
  const view = page.page.locator('.outliner-scroll');
  const box = (await view.boundingBox())!;
  await row('b3').hover();
  await page.page.mouse.down();
  for (const up of [40, 12, 6, 4]) await page.page.mouse.move(box.x + 60, box.y + box.height - up);
  await page.until('document.querySelector(".outliner-scroll").scrollTop > 300');
  const middle = box.y + box.height / 2;
  await page.page.mouse.move(box.x + 60, middle, { steps: 3 });
  const line = page.page.locator('.drop-line:not([hidden])');
  await expect.poll(async () => Math.abs(((await line.boundingBox())?.y ?? 0) - middle)).toBeLessThan(30);
  await page.page.mouse.up();
  await expect
    .poll(async () => Object.keys((await page.document()).objects).indexOf('b3'))
    .toBeGreaterThan(12);
});

it('by a finger that rests on it and then moves; one that only rests asks for the menu', async () => {
  const touch = await page.page.context().newCDPSession(page.page);
  const at = async (id: string, part: number) => {
    const box = (await row(id).boundingBox())!;
    return { x: box.x + 60, y: box.y + part * box.height };
  };
  const hold = async (id: string) => {
    await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [await at(id, 0.5)] });
    await page.page.locator('.outliner-row.held').waitFor();
  };
  const lift = () => touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await hold('b5');
  for (const part of [0.9, 0.1])
    await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [await at('b3', part)] });
  await page.page.locator('.drop-line:not([hidden])').waitFor();
  await lift();
  expect(await order()).toBe('b1 b2 b5 b3 b4 b6');
  await hold('b4');
  await lift();
  await page.page.getByRole('menu', { name: 'Box 4' }).waitFor();
  await press('Escape');
  await touch.detach();
});

it('goes by keys, and Escape gives a drag up', async () => {
  await row('b5').click();
  await press('Alt+ArrowUp');
  await press('Alt+ArrowUp');
  expect(await order()).toBe('b1 b2 b5 b3 b4 b6');
  await press('Alt+ArrowDown');
  expect(await order()).toBe('b1 b2 b3 b5 b4 b6');
  expect(await page.page.locator('.outliner-row.selected').getAttribute('data-entity')).toBe('objects/b5');
  await drag('b6', '[data-entity="objects/b3"]', 0.1);
  await press('Escape');
  await page.page.mouse.up();
  expect(await order()).toBe('b1 b2 b3 b5 b4 b6');
  await page.page.locator('.drop-line').waitFor({ state: 'hidden' });
  expect(page.errors).toEqual([]);
});
