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

/** A browser that says which file was dropped; the file is one of the page's own. */
const withHandles = `
  const file = async () => (await navigator.storage.getDirectory()).getFileHandle('ball.json', { create: true });
  DataTransferItem.prototype.getAsFileSystemHandle = file;
  addEventListener('DOMContentLoaded', () => {
    window.showSaveFilePicker = () => Promise.reject(new Error('asked where to'));
    window.writtenFile = async () => (await (await file()).getFile()).text();
  });
`;

it('is saved into the file that was dropped', async () => {
  const files = { '/small.json': small('Small') };
  const page = await (await lab.open({ query: '?scene=/small.json', files, init: withHandles })).ready();
  await page.drop([{ name: 'ball.json', content: small('Dropped') }]);
  await page.waitForToast('Opened Dropped');
  await page.page.evaluate(
    `irradia.store.edit('Move', (draft) => { draft.objects.ball.position = [1, 2, 3]; })`,
  );
  await page.page.keyboard.press('Control+s');
  await page.waitForToast('Saved ball.json');
  const written = JSON.parse(await page.page.evaluate<string>('writtenFile()'));
  expect(written).toMatchObject({ name: 'Dropped', objects: { ball: { position: [1, 2, 3] } } });
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
