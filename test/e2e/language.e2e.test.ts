/** The page in Spanish: no part of it says in English what the catalogue has, and the language can be changed. */
import { expect, it } from 'vitest';
import spanish from '../../src/editor/language/es/index.ts';
import { type LabPage, openLab } from './lab.ts';

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

/** What opens each part of the page, and what closes it again. */
const PARTS: readonly (readonly [string, (page: LabPage) => Promise<unknown>, string?])[] = [
  ['what is seen first', async () => {}],
  ...['Archivo', 'Edición', 'Añadir', 'Ajustes'].map(
    (name) =>
      [
        name,
        ({ page }: LabPage) => page.getByRole('button', { name, exact: true }).first().click(),
        'Escape',
      ] as const,
  ),
  ['a light', (page) => page.select('lights', 'red')],
  ['an object', (page) => page.select('objects', 'sphere')],
  ['a material', (page) => page.select('materials', 'cone')],
  ['the bench', ({ page }) => page.keyboard.press('b'), 'b'],
  ['the palette', ({ page }) => page.keyboard.press('Control+k'), 'Escape'],
  ['the history', ({ page }) => page.keyboard.press('Control+Alt+z'), 'Escape'],
  ['the library', ({ page }) => page.keyboard.press('m'), 'm'],
  ['both pictures', ({ page }) => page.keyboard.press('3'), '1'],
  ['the shortcuts', ({ page }) => page.keyboard.press('?'), 'Escape'],
  ['the documents', ({ page }) => page.keyboard.press('Control+Shift+O'), 'Escape'],
];

it('the page of a Spanish browser is Spanish; English is chosen in the settings, and nothing is lost', async () => {
  // A scene of little, which a GPU made of software draws at once.
  const page = await lab.open({ locale: 'es-ES', query: '?scene=thesis-demo02' });
  await page.ready();
  expect(await page.page.evaluate('document.documentElement.lang')).toBe('es');
  for (const [part, open, close] of PARTS) {
    await open(page);
    await page.page.waitForTimeout(100);
    expect([part, await leftInEnglish(page)]).toEqual([part, []]);
    if (close) await page.page.keyboard.press(close);
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
