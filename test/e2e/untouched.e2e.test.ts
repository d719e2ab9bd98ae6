/** A document that comes from a file: Save writes that file, and one that nobody has worked on leaves nothing behind. */
import { expect, it } from 'vitest';
import { openLab } from './lab.ts';

const lab = await openLab();

const small = (name: string) =>
  JSON.stringify({
    format: 'irradia',
    version: 1,
    name,
    view: { resolutionScale: 0.25 },
    materials: { clay: { name: 'Clay', model: 'lambert' } },
    objects: { ball: { name: 'Ball', material: 'clay', geometry: { type: 'sphere' } } },
  });

/** A browser that says which file was dropped or chosen; the files are of the page's own. */
const withHandles = `
  const file = async (name) => (await navigator.storage.getDirectory()).getFileHandle(name, { create: true });
  DataTransferItem.prototype.getAsFileSystemHandle = () => file('ball.json');
  addEventListener('DOMContentLoaded', () => {
    window.showSaveFilePicker = () => Promise.reject(new Error('asked where to'));
    window.writtenFile = async (name) => (await (await file(name)).getFile()).text();
    window.showOpenFilePicker = async ({ types: [{ accept }] }) => {
      if (!Object.values(accept).flat().includes('.json')) throw new Error('no documents');
      const chosen = await file('picked.json');
      const writer = await chosen.createWritable();
      await writer.write(${JSON.stringify(small('Picked'))});
      await writer.close();
      return [chosen];
    };
  });
`;

it('is saved into the file that was dropped or chosen', async () => {
  const files = { '/small.json': small('Small') };
  const page = await (await lab.open({ query: '?scene=/small.json', files, init: withHandles })).ready();
  await page.drop([{ name: 'ball.json', content: small('Dropped') }]);
  await page.waitForToast('Opened Dropped');
  const expectSaved = async (file: string, name: string) => {
    await page.page.evaluate(
      `irradia.store.edit('Move', (draft) => { draft.objects.ball.position = [1, 2, 3]; })`,
    );
    await page.page.keyboard.press('Control+s');
    await page.waitForToast(`Saved ${file}`);
    const written = JSON.parse(await page.page.evaluate<string>(`writtenFile('${file}')`));
    expect(written).toMatchObject({ name, objects: { ball: { position: [1, 2, 3] } } });
  };
  await expectSaved('ball.json', 'Dropped');
  await page.page.keyboard.press('Control+o');
  await page.waitForToast('Opened Picked');
  await expectSaved('picked.json', 'Picked');

  await page.page.evaluate(`
    window.showOpenFilePicker = () => {
      window.wasAsked = true;
      return Promise.reject(new DOMException('thought better of it', 'AbortError'));
    }`);
  await page.page.keyboard.press('Control+o');
  await page.until('wasAsked');
  expect((await page.document()).name).toBe('Picked');
  // Where pages may not ask so, they ask as all do. The browser opens that dialog for five seconds after a key alone.
  await page.page.evaluate(`
    window.showOpenFilePicker = () => Promise.reject(new DOMException('in a frame', 'SecurityError'));
    HTMLInputElement.prototype.click = function () {
      window.asked = [this.type, this.multiple];
    }`);
  await page.page.keyboard.press('Control+o');
  await page.until('Array.isArray(window.asked)');
  expect(await page.page.evaluate('asked')).toEqual(['file', true]);
  expect(page.errors).toEqual([]);
  await page.page.context().close();
});

it('is not kept when it is left as it came; work is', async () => {
  const files = { '/small.json': small('Small') };
  const page = await (await lab.open({ query: '?scene=/small.json', files })).ready();
  const kept = () =>
    page.page.evaluate<number>(
      `new Promise((resolve) => {
        indexedDB.open('irradia').onsuccess = ({ target: { result: database } }) => {
          database.transaction('documents').objectStore('documents').count().onsuccess = ({ target }) => {
            resolve(target.result);
            database.close();
          };
        };
      })`,
    );
  await page.menu('File', 'New');
  await page.until('irradia.store.document.name === "Untitled"');
  expect(await page.page.locator('.toast').count()).toBe(0);
  expect(await kept()).toBe(0);

  await page.drop([{ name: 'ball.json', content: small('Dropped') }]);
  await page.waitForToast('Opened Dropped');
  // What came from a file is kept for a crash, but not when it is left.
  await expect.poll(kept).toBe(1);
  await page.menu('File', 'New');
  await page.until('irradia.store.document.name === "Untitled"');
  expect(await kept()).toBe(0);

  await page.page.evaluate(`irradia.store.edit('Name', (draft) => { draft.name = 'Mine'; })`);
  await page.menu('File', 'New');
  await page.waitForToast('“Mine” is kept');
  expect(await kept()).toBe(1);
  expect(page.errors).toEqual([]);
  await page.page.context().close();
});
