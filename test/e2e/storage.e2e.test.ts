/** Nothing is lost: what was edited is there again after a crash, in versions, in links, without a network. */
import { randomBytes } from 'node:crypto';
import { expect, it } from 'vitest';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();
const small = '?scene=/scene.json';
const files = { '/scene.json': serializeDocument(createDocument('Small')) };

/** Counts what is written to the database, by store: the lengths of texts, the sizes of blobs. */
const COUNT_WRITES = `
  window.written = {};
  const put = IDBObjectStore.prototype.put;
  const size = (value) => value instanceof Blob ? value.size
    : typeof value === 'string' ? value.length : JSON.stringify(value).length;
  IDBObjectStore.prototype.put = function (value, ...rest) {
    window.written[this.name] = (window.written[this.name] ?? 0) + size(value);
    return put.call(this, value, ...rest);
  };`;

const kept = (page: LabPage) => page.page.waitForSelector('.document-button[data-keep=kept]');

const edit = (page: LabPage, recipe: string) =>
  page.page.evaluate(`irradia.store.edit('Edit', (draft) => { ${recipe} })`);

/** As when the process dies: no event tells the page. */
async function crash(page: LabPage): Promise<void> {
  const session = await page.page.context().newCDPSession(page.page);
  const crashed = new Promise((resolve) => page.page.once('crash', resolve));
  void session.send('Page.crash').catch(() => {});
  await crashed;
}

it('a document with assets is there again after a crash, and an edit writes only what it touched', async () => {
  const first = await (await lab.open({ query: small, files, init: COUNT_WRITES })).ready();
  const megabyte = randomBytes(1 << 20).toString('base64');
  await edit(
    first,
    `draft.assets.noise = { name: 'noise.bin', mediaType: 'application/octet-stream', data: '${megabyte}' };
     draft.name = 'With noise';`,
  );
  await kept(first);
  await first.page.waitForFunction('written.versions > 0');
  const written = () => first.page.evaluate<Record<string, number>>('({ ...written })');
  const before = await written();
  expect(before.assets).toBe(1 << 20);

  await edit(first, 'draft.view.exposure = 1.5;');
  await kept(first);
  const after = await written();
  expect(after.assets).toBe(before.assets);
  expect(after.texts).toBe(before.texts);
  expect((after.changes ?? 0) - (before.changes ?? 0)).toBeLessThan(200);
  expect((after.documents ?? 0) - (before.documents ?? 0)).toBeLessThan(400);

  const document = await first.document();
  await crash(first);
  const second = await (await lab.open({ beside: first })).ready();
  await second.waitForToast('Recovered “With noise”');
  expect(await second.document()).toEqual(document);

  await second.page.click('.toast >> text=Discard');
  await second.waitForToast('Deleted “With noise”');
  expect((await second.document()).name).not.toBe('With noise');
  await second.page.click('.toast >> text=Undo');
  await second.page.waitForFunction('irradia.store.document.name === "With noise"');
  expect(await second.document()).toEqual(document);
  expect(second.errors).toEqual([]);
  await second.page.context().close();
});
