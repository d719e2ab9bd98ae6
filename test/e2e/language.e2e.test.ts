/** The page in Spanish: no part of it says in English what the catalogue has, and the language can be changed. */
import { expect, it } from 'vitest';
import spanish from '../../src/editor/language/es/index.ts';
import { CLAY_BALL, type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();

/** What is written otherwise in Spanish. */
const english = Object.entries(spanish)
  .filter(([source, entry]) => entry !== source)
  .map(([source]) => source.replace(/\|\w+$/, ''));

/** English of the catalogue that can be read or heard on the page; names of a document are a person's own. */
async function leftInEnglish({ page }: LabPage): Promise<string[]> {
  const seen = await page.evaluate(`(() => {
    const texts = new Set();
    const nodes = document.createTreeWalker(document.body, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
    for (let node = nodes.nextNode(); node; node = nodes.nextNode()) {
      const element = node instanceof Element ? node : node.parentElement;
      if (node instanceof Text) texts.add(node.data.trim());
      else for (const name of ['aria-label', 'data-tip', 'placeholder', 'title', 'label'])
        texts.add((node.getAttribute(name) ?? '').trim());
    }
    const { name, lights, objects, materials } = irradia.store.document;
    const own = [{ name }, ...[lights, objects, materials].flatMap(Object.values)];
    for (const { name } of own) texts.delete(name);
    return [...texts];
  })()`);
  const known = new Set(english);
  return (seen as string[]).filter((text) => known.has(text));
}

interface Part {
  readonly name: string;
  open(page: LabPage): Promise<unknown>;
  /** What is there once it is open. */
  readonly shows?: string;
  readonly close?: string;
}

const press = (keys: string) => (page: LabPage) => page.page.keyboard.press(keys);
const click = (name: string) => (page: LabPage) =>
  page.page.getByRole('button', { name, exact: true }).first().click();

const PARTS: readonly Part[] = [
  { name: 'what is seen first', open: async () => {} },
  ...['Archivo', 'Edición', 'Añadir', 'Ajustes'].map(
    (name): Part => ({ name, open: click(name), shows: '.menu', close: 'Escape' }),
  ),
  { name: 'a light', open: (page) => page.select('lights', 'key') },
  { name: 'an object', open: (page) => page.select('objects', 'ball') },
  { name: 'a material', open: (page) => page.select('materials', 'clay') },
  { name: 'the bench', open: press('b'), close: 'b' },
  { name: 'the palette', open: press('Control+k'), shows: '.palette-item', close: 'Escape' },
  { name: 'the history', open: press('Control+Alt+z'), shows: '.history', close: 'Escape' },
  { name: 'the shortcuts', open: press('?'), shows: 'dialog.shortcuts', close: 'Escape' },
  { name: 'the documents', open: press('Control+Shift+O'), shows: 'dialog.documents', close: 'Escape' },
  { name: 'both pictures', open: press('3'), shows: '.tracing-progress', close: '1' },
  { name: 'the library', open: press('m'), shows: '.library-grid' },
];

it('the page of a Spanish browser is Spanish; English is chosen in the settings, and nothing is lost', async () => {
  const page = await lab.open(small(CLAY_BALL, { locale: 'es-ES' }));
  // The page's script waits for the catalogue; the browser's load event does not wait for the script then.
  await page.until(`typeof irradia === 'object'`);
  await page.ready();
  expect(await page.page.evaluate('document.documentElement.lang')).toBe('es');
  for (const { name, open, shows, close } of PARTS) {
    await open(page);
    const shown = shows ? page.page.locator(shows).first() : null;
    await shown?.waitFor();
    expect([name, await leftInEnglish(page)]).toEqual([name, []]);
    if (!close) continue;
    await page.page.keyboard.press(close);
    await shown?.waitFor({ state: 'hidden' });
  }

  // What a room below the editor says of an edit, and what Intl says of its time.
  await page.page.evaluate(`irradia.store.edit('Delete 2 lights', (draft) => { draft.name = 'Mía'; })`);
  expect(await page.page.getAttribute('[data-action=undo]', 'aria-label')).toBe('Deshacer: Eliminar 2 luces');

  await page.page.getByRole('button', { name: 'Ajustes' }).first().click();
  await Promise.all([
    page.page.waitForEvent('load'),
    page.page.locator('.menu button', { hasText: 'English' }).click(),
  ]);
  await page.ready();
  expect(await page.page.evaluate('document.documentElement.lang')).toBe('en');
  expect(await page.page.locator('.topbar .menu-button').first().textContent()).toBe('File');
  expect((await page.document()).name).toBe('Mía');
  expect(page.errors).toEqual([]);
});
