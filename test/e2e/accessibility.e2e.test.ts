/**
 * The page without a mouse and without sight: axe-core finds nothing serious in any of its parts, in either theme, and
 * a material is made, traced and kept with the keyboard alone.
 */
import axe from 'axe-core';
import { expect, it } from 'vitest';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();

/** What axe-core calls serious or critical, each with the elements that have it. */
async function findings(page: LabPage, rules?: readonly string[]): Promise<string[]> {
  const only = rules ? `runOnly: ${JSON.stringify(rules)},` : '';
  return page.page.evaluate<
    string[]
  >(`axe.run(document, { ${only} resultTypes: ['violations'] }).then(({ violations }) =>
    violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) =>
        [id, target.join(' '), failureSummary.split('\\n').slice(1, 3).join(' ')].join(': '))))`);
}

/** Each part of the page: what opens it, and what closes it again. */
const PARTS: readonly (readonly [
  string,
  (page: LabPage) => Promise<unknown>,
  ((page: LabPage) => Promise<unknown>)?,
])[] = [
  ['the page as it is first seen', async () => {}],
  ...(['File', 'Edit', 'Add', 'Settings'] as const).map(
    (name) =>
      [
        `the menu ${name}`,
        ({ page }: LabPage) => page.getByRole('button', { name, exact: true }).first().click(),
        ({ page }: LabPage) => page.keyboard.press('Escape'),
      ] as const,
  ),
  ['the inspector of an object', (page) => page.select('objects', 'suzanne')],
  ['the inspector of a light', (page) => page.select('lights', 'spot')],
  ['the inspector of a material', (page) => page.select('materials', 'gold')],
  [
    'the colour picker',
    ({ page }) => page.locator('.panel-right .swatch').first().click(),
    ({ page }) => page.keyboard.press('Escape'),
  ],
  ['the bench', ({ page }) => page.keyboard.press('b')],
  [
    'the list of shortcuts',
    async ({ page }) => {
      await page.keyboard.press('?');
      await page.locator('dialog.shortcuts').waitFor();
    },
    ({ page }) => page.keyboard.press('Escape'),
  ],
  [
    'the documents',
    async ({ page }) => {
      await page.keyboard.press('Control+Shift+O');
      await page.locator('dialog.documents').waitFor();
    },
    ({ page }) => page.keyboard.press('Escape'),
  ],
  [
    'sharing',
    async (page) => {
      await page.menu('File', 'Share as a link…');
      await page.page.locator('dialog.share').waitFor();
    },
    ({ page }) => page.keyboard.press('Escape'),
  ],
  [
    'the export of a picture',
    async (page) => {
      await page.menu('File', 'Picture…');
      await page.page.locator('dialog.export-picture').waitFor();
    },
    ({ page }) => page.keyboard.press('Escape'),
  ],
];

it.each(['dark', 'light'])('axe-core finds nothing serious in the %s theme', async (theme) => {
  const init = `${axe.source}; localStorage.setItem('irradia.theme', '${theme}')`;
  const page = await (await lab.open({ init, width: 1280, height: 720 })).ready();
  const found: string[] = [];
  for (const [name, open, close] of PARTS) {
    await open(page);
    // The themes differ in colours alone.
    const all = await findings(page, theme === 'dark' ? undefined : ['color-contrast']);
    found.push(...all.map((finding) => `${name}: ${finding}`));
    await close?.(page);
  }
  expect([...new Set(found)]).toEqual([]);
  expect(page.errors).toEqual([]);
  await page.page.close();
});
