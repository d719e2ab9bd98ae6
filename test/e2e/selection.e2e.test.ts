/** Many things at once, as a person does it: in the outliner, by keys, by the command palette, between documents. */
import { beforeAll, describe, expect, it } from 'vitest';
import type { Document } from '../../src/scene/schema.ts';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();

/** Boxes in a row, at a resolution that the software GPU draws at once. */
function boxes(count: number): string {
  const names = Array.from({ length: count }, (_, i) => `box-${i + 1}`);
  return JSON.stringify({
    format: 'irradia',
    version: 1,
    name: `${count} boxes`,
    camera: { position: [0, 2, 8], target: [0, 0, 0] },
    view: { resolutionScale: 0.25 },
    lights: { ambient: { type: 'ambient' }, key: { type: 'directional' } },
    materials: { clay: { name: 'Clay', model: 'lambert' }, gold: { name: 'Gold', model: 'lambert' } },
    objects: Object.fromEntries(
      names.map((id, i) => [
        id,
        {
          name: `Box ${i + 1}`,
          material: 'clay',
          position: [(i % 6) - 2.5, 0, -Math.floor(i / 6)],
          scale: [0.5, 0.5, 0.5],
          geometry: { type: 'box' },
        },
      ]),
    ),
  });
}

const files = { '/few.json': boxes(6) };

let page: LabPage;
let original: Document;
beforeAll(async () => {
  page = await (await lab.open({ query: '?scene=/few.json', files, height: 640 })).ready();
  original = await page.document();
});

const row = (id: string) => `[data-entity="objects/${id}"]`;
const click = (id: string, ...modifiers: ('Shift' | 'Control')[]) => page.page.click(row(id), { modifiers });
const press = (...keys: string[]) =>
  keys.reduce((before, key) => before.then(() => page.page.keyboard.press(key)), Promise.resolve());
const selected = () =>
  page.page
    .locator('.outliner-row.selected[data-entity]')
    .evaluateAll((rows) => rows.map((each) => (each as HTMLElement).dataset.entity?.replace(/.*\//, '')));
const objects = async () => Object.values((await page.document()).objects);

describe('the outliner', () => {
  it('selects ranges, more and fewer, all and the others', async () => {
    await click('box-2');
    await click('box-4', 'Shift');
    expect(await selected()).toEqual(['box-2', 'box-3', 'box-4']);
    await click('box-3', 'Control');
    await click('box-6', 'Control');
    expect(await selected()).toEqual(['box-2', 'box-4', 'box-6']);
    await press('Control+i');
    expect(await selected()).toEqual(['ambient', 'key', 'box-1', 'box-3', 'box-5']);
    await press('Control+a');
    expect(await selected()).toHaveLength(8);
    await press('Escape');
    expect(await selected()).toEqual([]);
  });

  it('goes by keys, as any tree does', async () => {
    await click('box-1');
    await press('ArrowDown', 'Shift+ArrowDown');
    expect(await selected()).toEqual(['box-2', 'box-3']);
    const tree = page.page.locator('[role=tree]');
    expect(await tree.getAttribute('aria-activedescendant')).toBe('outliner-objects/box-3');
    await press('ArrowLeft', 'ArrowLeft');
    expect(await page.page.locator(row('box-1')).count()).toBe(0);
    await press('ArrowRight', 'ArrowDown');
    expect(await selected()).toEqual(['box-1']);
    await press('End');
    expect(await selected()).toEqual(['gold']);
    await press('Home');
    expect(await page.page.locator('.scene-row.selected').count()).toBe(1);
  });

  it('groups, folds, locks, keeps what is locked, and ungroups', async () => {
    await click('box-1');
    await click('box-2', 'Shift');
    await press('Control+g');
    const [group = ''] = Object.keys((await page.document()).groups);
    expect((await objects()).filter((box) => box.group === group)).toHaveLength(2);
    await page.page.locator('[data-group]').click();
    await press('ArrowLeft');
    expect(await page.page.locator(row('box-1')).count()).toBe(0);
    await press('F2');
    await page.page.keyboard.type('Pair');
    await press('Enter', 'ArrowRight');
    expect((await page.document()).groups[group]?.name).toBe('Pair');
    await click('box-2');
    await press('Shift+L', 'Delete');
    await page.waitForToast('One is locked and stays');
    expect(await objects()).toHaveLength(6);
    await page.page.locator('[data-group]').click();
    await press('Delete');
    await page.waitForToast('One is locked and stays');
    expect((await objects()).map(({ name }) => name)).toEqual(['Box 2', 'Box 3', 'Box 4', 'Box 5', 'Box 6']);
    expect(await page.inspector().locator('.row[data-label="Position"]').getAttribute('inert')).toBe('');
    await press('Control+Shift+G');
    expect((await page.document()).groups).toEqual({});
    await press('Control+Shift+L');
    expect((await objects()).some(({ locked }) => locked)).toBe(false);
  });

  it('finds by name and kind', async () => {
    await press('Control+f');
    await page.page.keyboard.type('light direct');
    expect(await page.page.locator('.outliner-row[data-entity]').allInnerTexts()).toEqual([
      'Directional light',
    ]);
    await press('Enter');
    expect(await selected()).toEqual(['key']);
    await press('Control+f', 'Escape');
    expect(await page.page.locator('.outliner-row[data-entity]').count()).toBe(9);
  });
});

describe('the inspector', () => {
  it('shows what many have in common and sets it in one step', async () => {
    await click('box-3');
    await click('box-5', 'Shift');
    expect(await page.page.locator('.inspector-kind').textContent()).toBe('3 objects');
    const position = page.inspector().locator('.row[data-label="Position"]');
    expect(await position.getAttribute('class')).toContain('mixed');
    const before = await page.document();
    const y = position.locator('input').nth(1);
    await y.fill('1');
    await y.press('Enter');
    const heights = (await objects()).map(({ position: [, height] }) => height);
    expect(heights).toEqual([0, 1, 1, 1, 0]);
    const xs = Object.values(before.objects).map(({ position: [x] }) => x);
    expect((await objects()).map(({ position: [x] }) => x)).toEqual(xs);
    await page.page.selectOption('.inspector .row[data-label="Material"] select', 'gold');
    expect((await objects()).map(({ material }) => material)).toEqual([
      'clay',
      'gold',
      'gold',
      'gold',
      'clay',
    ]);
    await page.page.locator('.inspector-kind').click();
    await press('Control+z', 'Control+z');
    expect(await page.document()).toEqual(before);
  });
});

describe('the history', () => {
  it('has all steps by name and goes to any of them', async () => {
    await press('Control+Alt+z');
    const steps = page.page.locator('.history-step');
    await steps.first().waitFor();
    expect((await steps.allInnerTexts()).slice(0, 3)).toEqual([
      'As it was opened',
      'Group 2 objects',
      'Rename Group to Pair',
    ]);
    expect(await page.page.locator('.history-step.undone').count()).toBe(2);
    await steps.first().click();
    expect(await page.document()).toEqual(original);
    await press('End');
    expect((await objects()).map(({ material }) => material)).toContain('gold');
    await press('Home', 'Escape');
    expect(await page.document()).toEqual(original);
  });
});

describe('the clipboard', () => {
  it('takes things with their materials and groups into another document, however long', async () => {
    await click('box-2');
    await press('Control+g');
    await page.select('lights', 'key');
    await click('box-2', 'Control');
    await press('Control+c');
    const before = await page.document();
    // Hidden: it is the outliner that is looked at.
    await page.page.evaluate(`(() => {
      const { store } = irradia;
      const box = { ...store.document.objects['box-1'], visible: false };
      const names = Array.from({ length: 2000 }, (_, i) => 'many-' + (i + 1));
      const objects = Object.fromEntries(names.map((id, i) => [id, { ...box, name: 'Box ' + (i + 1) }]));
      store.open({ ...store.document, name: 'Many', groups: {}, lights: {}, objects });
    })()`);
    // Of many rows those are on the page that are near.
    expect(await page.page.locator('.outliner-row').count()).toBeLessThan(400);
    await page.page.click('[role=tree]', { position: { x: 60, y: 12 } });
    await press('End');
    expect(await page.page.locator('.outliner-row.selected').getAttribute('data-entity')).toBe(
      'materials/gold',
    );
    await press('Control+v');
    const { lights, groups, materials, ...rest } = await page.document();
    expect(Object.values(lights).map(({ name }) => name)).toEqual(['Directional light']);
    expect(Object.values(groups).map(({ name }) => name)).toEqual(['Group']);
    expect(Object.values(rest.objects).at(-1)).toMatchObject({ name: 'Box 2001', material: 'clay' });
    expect(Object.keys(materials)).toEqual(['clay', 'gold']);
    await press('Control+z');
    expect(Object.keys((await page.document()).objects)).toHaveLength(2000);
    await page.page.evaluate(([document]) => Reflect.get(window, 'irradia').store.open(document), [before]);
  });

  it('says what is not to be pasted', async () => {
    const before = await page.document();
    await page.page.evaluate(() => {
      const paste = (text: string) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', text);
        document.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
      };
      paste('a shopping list');
      paste(
        '{"format":"irradia-clipboard","version":1,"document":{"format":"irradia","version":1,"objects":7}}',
      );
    });
    await page.waitForToast('There is nothing to paste');
    await page.waitForToast('Not pasted; the scene is unchanged');
    expect(await page.document()).toEqual(before);
  });
});

describe('the command palette', () => {
  it('runs what can be done, and selects what is in the scene', async () => {
    await press('Control+k');
    const input = page.page.locator('.palette input');
    await input.fill('add cone');
    expect(await page.page.locator('.palette-item[aria-selected=true]').innerText()).toContain('Add cone');
    await press('Enter');
    expect((await objects()).at(-1)?.geometry.type).toBe('cone');
    await press('Control+Shift+P');
    await input.fill('bx4');
    expect(await input.getAttribute('aria-activedescendant')).toBe('palette-0');
    await press('Enter');
    expect(await selected()).toEqual(['box-4']);
    await press('Control+k');
    await input.fill('effects medium');
    await press('Enter');
    expect((await page.document()).effects.shadows.enabled).toBe(true);
    await press('Control+z', 'Control+k');
    await input.fill('export picture');
    await press('Enter');
    await page.page.locator('.export-picture').waitFor();
    await press('Escape');
    await press('Control+k');
    await input.fill('undo');
    expect(await page.page.locator('.palette-item').first().innerText()).toContain('Undo');
    await press('Escape');
    await input.waitFor({ state: 'detached' });
    expect(page.errors).toEqual([]);
  });
});
