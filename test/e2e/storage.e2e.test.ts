/** Nothing is lost: what was edited is there again after a crash, in versions, in links, without a network. */
import { randomBytes } from 'node:crypto';
import { expect, it } from 'vitest';
import { parseDocument } from '../../src/scene/document.ts';
import { type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();
const scene = small();
const { query = '', files = {} } = scene;

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
  const first = await (await lab.open({ ...scene, init: COUNT_WRITES })).ready();
  const megabyte = randomBytes(1 << 20).toString('base64');
  const isWarned = `!dispatchEvent(new Event('beforeunload', { cancelable: true }))`;
  // New bytes are still to be hashed and written, which takes longer than a page has to end.
  const isWarnedAtOnce = await first.page.evaluate(`(() => {
    irradia.store.edit('Edit', (draft) => {
      draft.assets.noise = { name: 'noise.bin', mediaType: 'application/octet-stream', data: '${megabyte}' };
      draft.name = 'With noise';
    });
    return ${isWarned};
  })()`);
  expect(isWarnedAtOnce).toBe(true);
  await kept(first);
  await first.until('written.versions > 0');
  expect(await first.page.evaluate(isWarned)).toBe(false);
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
  const scenes = { thesis: JSON.parse(files['/small.json'] ?? '') };
  const second = await lab.open({ beside: first, scenes });
  // The offer goes after a while, which a page that starts on a busy machine may take.
  await second.waitForToast('Recovered “With noise”');
  expect(await second.document()).toEqual(document);
  await second.takeOffer('Discard');
  await second.ready();
  await second.waitForToast('Deleted “With noise”');
  expect((await second.document()).name).not.toBe('With noise');
  await second.takeOffer('Undo');
  await second.until('irradia.store.document.name === "With noise"');
  expect(await second.document()).toEqual(document);

  // A page that is left in the middle of an edit, and one whose GPU goes.
  await edit(second, 'draft.view.exposure = 2;');
  await second.page.reload();
  await second.ready();
  expect((await second.document()).view.exposure).toBe(2);
  await edit(second, 'draft.view.exposure = 3;');
  await Promise.all([
    second.page.waitForEvent('load'),
    second.page.evaluate('irradia.renderer.three.onDeviceLost({ message: "gone" })'),
  ]);
  await second.ready();
  expect((await second.document()).view.exposure).toBe(3);
  expect(second.errors).toEqual([]);
  await second.page.context().close();
});

it('versions, copies and names of documents are in a dialog', async () => {
  const page = await (await lab.open({ ...scene, width: 1100, height: 700 })).ready();
  await edit(page, 'draft.view.exposure = 2;');
  await kept(page);
  // Who begins to write before the last part of the dialog has come goes on writing there.
  await page.page.evaluate(`
    window.answers = [];
    navigator.storage.persisted = () => new Promise((resolve) => answers.push(() => resolve(false)));
  `);
  await page.page.keyboard.press('Control+Shift+O');
  await page.page.waitForSelector('.document-card[aria-current] img');
  await page.until('answers.length > 0');
  await page.page.focus('.version-form input');
  await page.page.evaluate('delete navigator.storage.persisted; for (const answer of answers) answer();');
  expect(await page.page.evaluate(`document.activeElement.matches('.version-form input')`)).toBe(true);
  await page.page.evaluate(`document.querySelector('.document-card').id = 'same'`);
  await page.page.fill('.version-form input', 'Bright');
  await page.page.click('text=Keep version');
  await page.page.waitForSelector('.version-list >> text=Bright');
  // What is as it was stays on the page: a click on it may be under way.
  expect(await page.page.locator('#same').count()).toBe(1);
  const versions = page.page.locator('.version-list li');
  expect(await versions.locator('strong').allInnerTexts()).toEqual(['Bright', 'As it was opened']);

  await page.page.getByRole('button', { name: 'Delete “Bright”' }).click();
  await page.waitForToast('Deleted “Bright”');
  expect(await versions.count()).toBe(1);
  await page.takeOffer('Undo');
  await page.page.waitForSelector('.version-list >> text=Bright');

  await versions.nth(1).locator('text=Restore').click();
  await page.waitForToast('Restored');
  expect((await page.document()).view.exposure).toBe(0);
  await page.takeOffer('Undo');
  expect((await page.document()).view.exposure).toBe(2);

  await page.page.keyboard.press('Control+Shift+O');
  await page.page.click('.document-actions >> text=Duplicate');
  const copy = page.page.locator('.document-card', { hasText: 'Small copy' });
  await copy.dblclick();
  await page.until('irradia.store.document.name === "Small copy"');
  expect((await page.document()).view.exposure).toBe(2);
  await page.waitForToast('“Small” is kept');

  await page.page.click('.document-button');
  const title = page.page.locator('.document-title');
  await page.page.locator('.document-card', { hasText: 'open' }).waitFor();
  await title.fill('Renamed');
  await title.press('Enter');
  await page.page.locator('.document-card', { hasText: 'Renamed' }).waitFor();
  expect((await page.document()).name).toBe('Renamed');
  await page.page.locator('.document-card').nth(1).click();
  await page.until('document.querySelector(".document-title").value === "Small"');
  await page.page.click('.document-actions >> text=Delete');
  await page.until('document.querySelectorAll(".document-card").length === 1');
  await page.takeOffer('Undo');
  await page.until('document.querySelectorAll(".document-card").length === 2');
  expect(page.errors).toEqual([]);
  await page.page.context().close();
});

it('a link opens in another browser as the same document, and takes nobody’s work away', async () => {
  const page = await (await lab.open(scene)).ready();
  await edit(
    page,
    `draft.name = 'Shared <img src=x onerror="window.ran = true">'; draft.view.exposure = -1;`,
  );
  await page.menu('File', 'Share as a link…');
  const address = await page.page.inputValue('.share-link input');
  const shared = await page.document();
  const link = new URL(address).hash;

  const other = await (await lab.open(scene)).ready();
  await edit(other, 'draft.name = "Their own";');
  await other.page.evaluate(`location.hash = ${JSON.stringify(link)}`);
  await other.waitForToast('“Their own” is kept');
  expect(await other.document()).toEqual(shared);
  await other.takeOffer('Back to it');
  await other.until('irradia.store.document.name === "Their own"');
  await other.page.evaluate('location.hash = "#document=broken"');
  await other.waitForToast('The link was not opened');
  expect(await other.page.evaluate('window.ran')).toBeUndefined();

  const fresh = await (await lab.open({ query: link, files })).ready();
  expect(await fresh.document()).toEqual(shared);
  expect([...page.errors, ...other.errors, ...fresh.errors]).toEqual([]);
  for (const { page: each } of [page, other, fresh]) await each.context().close();
});

it('what does not fit says so: into the browser, into a link', async () => {
  const page = await (await lab.open(scene)).ready();
  const browser = await page.page.context().newCDPSession(page.page);
  const origin = new URL(page.url).origin;
  await browser.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 30_000 });
  const noise = randomBytes(60_000).toString('base64');
  await edit(
    page,
    `draft.assets.noise = { name: 'noise.bin', mediaType: 'application/octet-stream', data: '${noise}' };`,
  );
  await page.waitForToast('storage is full');
  await page.page.click('.toast .icon-button');
  await browser.send('Storage.overrideQuotaForOrigin', { origin });
  await edit(page, 'draft.view.exposure = 1;');
  await kept(page);

  await page.menu('File', 'Share as a link…');
  const text = await page.page.locator('.share').innerText();
  expect(text).toMatch(/would have \d\d,\d{3} characters.*so it is \d\d,\d{3} too long/);
  expect(text).toContain('noise.bin');
  const download = page.page.waitForEvent('download');
  await page.page.click('text=Save as a file');
  expect((await download).suggestedFilename()).toBe('Small.json');
  await page.page.context().close();
});

it('what was cleared while it was open is kept again, and what is damaged is as it was before', async () => {
  const page = await (await lab.open({ ...scene, init: COUNT_WRITES })).ready();
  await edit(page, 'draft.name = "Cleared"; draft.view.exposure = 1;');
  await kept(page);
  await page.until('written.versions > 0');
  const { texts } = await page.page.evaluate<{ texts: number }>('({ ...written })');
  const browser = await page.page.context().newCDPSession(page.page);
  const { origin } = new URL(page.url);
  await browser.send('Storage.clearDataForOrigin', { origin, storageTypes: 'indexeddb' });
  await page.until(`written.texts > ${texts}`);
  await edit(page, 'draft.view.exposure = 2;');
  await kept(page);
  await page.page.reload();
  await page.ready();
  expect((await page.document()).view.exposure).toBe(2);

  await page.page.evaluate(`new Promise((resolve) => {
    const request = indexedDB.open('irradia');
    request.onsuccess = () => {
      const transaction = request.result.transaction('changes', 'readwrite');
      const cursor = transaction.objectStore('changes').openCursor();
      cursor.onsuccess = () => cursor.result?.update('{"singles":');
      transaction.oncomplete = () => resolve(request.result.close());
    };
  })`);
  // Whoever reads it is told.
  await page.page.keyboard.press('Control+Shift+O');
  await page.page.click('.document-actions >> text=Duplicate');
  await page.waitForToast('“Cleared” is not as you left it');
  await page.page.reload();
  await page.ready();
  await page.waitForToast('“Cleared” is not as you left it');
  expect((await page.document()).view.exposure).toBe(1);
  // From now on it is whole again.
  await edit(page, 'draft.view.exposure = 3;');
  await kept(page);
  await page.page.reload();
  await page.ready();
  expect((await page.document()).view.exposure).toBe(3);
  expect(page.errors).toEqual([]);
  await page.page.context().close();
});

it('where the browser keeps nothing, that is said, and work is not thrown away unasked', async () => {
  const init = `indexedDB.open = () => { throw new DOMException('not here', 'SecurityError'); };`;
  const page = await (await lab.open({ ...scene, init })).ready();
  await edit(page, 'draft.name = "Only here";');
  await page.waitForToast('This document is not being kept');
  await page.page.click('.toast .icon-button');
  await page.menu('File', 'New');
  await page.page.click('.confirm >> text=Cancel');
  expect((await page.document()).name).toBe('Only here');
  await page.menu('File', 'New');
  await page.page.click('.confirm >> text=Discard changes');
  await page.until('irradia.store.document.name === "Untitled"');
  expect(page.errors).toEqual([]);
  await page.page.context().close();
});

it('Save writes the same file again where the browser lets a page write files', async () => {
  const page = await (await lab.open(scene)).ready();
  // A file of the browser's own stands for the one that a person would choose.
  await page.page.evaluate(`
    window.asked = 0;
    window.showSaveFilePicker = async ({ suggestedName }) => {
      window.asked += 1;
      return (await navigator.storage.getDirectory()).getFileHandle(suggestedName, { create: true });
    }`);
  const text = () =>
    page.page.evaluate<string>(
      `navigator.storage.getDirectory().then((d) => d.getFileHandle('Small.json')).then((f) => f.getFile()).then((f) => f.text())`,
    );
  await page.page.keyboard.press('Control+s');
  await page.waitForToast('Saved Small.json');
  await edit(page, 'draft.view.exposure = 3;');
  await page.page.keyboard.press('Control+s');
  await page.waitForToast('Saved Small.json');
  expect(await page.page.evaluate('window.asked')).toBe(1);
  expect(parseDocument(await text(), 'Small.json')).toEqual(await page.document());
  await page.page.context().close();
});

it('works without a network after the first visit, alone with itself as before', async () => {
  // In the place of a scene that ships, which is the browser's then.
  const scenes = { 'thesis-demo02': { format: 'irradia', version: 1, name: 'Shipped' } };
  const page = await (await lab.open({ ...scene, scenes, serviceWorkers: 'allow' })).ready();
  await page.page.evaluate('navigator.serviceWorker.ready.then(() => true)');
  // What a tab with the build before still asks for.
  const old = './assets/part-of-before.js';
  await page.page.evaluate(
    `caches.open('irradia-before').then((cache) => cache.put('${old}', new Response('before')))`,
  );
  await page.endServer();
  await page.page.goto(`${page.url}?scene=thesis-demo02`);
  await page.ready();
  expect((await page.document()).name).toBe('Shipped');
  expect(await page.page.evaluate('crossOriginIsolated')).toBe(true);
  expect(await page.page.evaluate(`fetch('${old}').then((response) => response.text())`)).toBe('before');
  await page.page.context().close();
});

it('tells when a newer build is ready, and loads it with what is open', async () => {
  // Stands for the service worker of the next build, which does not have this page's script.
  const next = `addEventListener('message', ({ data, ports }) => {
    if (data === 'take over') skipWaiting();
    else ports[0].postMessage(false);
  });`;
  const withNext = { ...files, '/next.js': next };
  const page = await (await lab.open({ query, files: withNext, serviceWorkers: 'allow' })).ready();
  await page.page.evaluate('navigator.serviceWorker.ready.then(() => true)');
  await page.until('navigator.serviceWorker.controller !== null');
  await edit(page, 'draft.view.exposure = 2;');
  await page.page.evaluate(`navigator.serviceWorker.register('./next.js').then(() => true)`);
  await page.waitForToast('A new version of Irradia is ready');
  await Promise.all([page.page.waitForEvent('load'), page.takeOffer('Reload')]);
  await page.ready();
  expect((await page.document()).view.exposure).toBe(2);
  await page.page.context().close();
});
