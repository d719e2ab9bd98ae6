/**
 * The page without a mouse and without sight: axe-core finds nothing serious in any of its parts, in either theme, and
 * a material is made, traced and kept with the keyboard alone.
 */
import axe from 'axe-core';
import { expect, it } from 'vitest';
import { type LabPage, openLab, small as smallScene } from './lab.ts';

const lab = await openLab();
/** One of each kind, which a GPU made of software draws soon. */
const small = smallScene({
  materials: { gold: { name: 'Gold', model: 'principled' } },
  objects: { ball: { name: 'Ball', material: 'gold', geometry: { type: 'sphere' } } },
  lights: { lamp: { type: 'spot', name: 'Lamp', position: [2, 3, 2], intensity: 100 } },
});

/**
 * What axe-core calls serious or critical, each with the elements that have it. It need not load anything first: that is for
 * rules on sound and film, of which there is none, and on locked orientations, which are off unless asked for.
 */
async function findings(page: LabPage, part: string, rules?: readonly string[]): Promise<string[]> {
  const only = rules ? `runOnly: ${JSON.stringify(rules)},` : '';
  return page.page.evaluate<
    string[]
  >(`axe.run(${JSON.stringify(part)}, { ${only} preload: false, resultTypes: ['violations'] }).then(({ violations }) =>
    violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) =>
        [id, target.join(' '), failureSummary.split('\\n').slice(1, 3).join(' ')].join(': '))))`);
}

/** Each part of the page, and what opens it; dialogs, menus and popups are closed with Escape. */
const PARTS: readonly (readonly [selector: string, open: (page: LabPage) => Promise<unknown>])[] = [
  ['#app', async () => {}],
  ...(['File', 'Edit', 'Add', 'Settings'] as const).map(
    (name) =>
      [
        '.popup',
        ({ page }: LabPage) => page.getByRole('button', { name, exact: true }).first().click(),
      ] as const,
  ),
  ['.panel-right', (page) => page.select('objects', 'ball')],
  ['.panel-right', (page) => page.select('lights', 'lamp')],
  ['.panel-right', (page) => page.select('materials', 'gold')],
  [
    '.popup',
    async ({ page }) => {
      await page.locator('.panel-right .swatch').first().click();
      await page.locator('.color-square:focus').waitFor();
    },
  ],
  ['.bench', ({ page }) => page.keyboard.press('b')],
  ['.library', ({ page }) => page.keyboard.press('m')],
  ['dialog.palette', ({ page }) => page.keyboard.press('Control+k')],
  ['dialog.shortcuts', ({ page }) => page.keyboard.press('?')],
  ['dialog.documents', ({ page }) => page.keyboard.press('Control+Shift+O')],
  ['dialog.share', (page) => page.menu('File', 'Share as a link…')],
  ['dialog.export-picture', (page) => page.menu('File', 'Picture…')],
  [
    '.tour-card',
    async ({ page }) => {
      await page.locator('.settings').click();
      await page.getByText('Tour of the page').click();
    },
  ],
  ['.lesson-panel', ({ page }) => page.getByRole('button', { name: 'Learn' }).click()],
  ['.source', ({ page }) => page.keyboard.press('Control+e')],
];

it('axe-core finds nothing serious in either theme', async () => {
  const page = await (await lab.open({ ...small, init: axe.source, width: 1200, height: 640 })).ready();
  const found: string[] = [];
  for (const [part, open] of PARTS) {
    // Keys go to the page, not to what the part before has for typing.
    await page.page.evaluate('document.activeElement.blur()');
    await open(page);
    await page.page.locator(part).waitFor();
    found.push(...(await findings(page, part)));
    // The themes differ in colours alone.
    await page.page.evaluate(`document.documentElement.dataset.theme = 'light'`);
    found.push(...(await findings(page, part, ['color-contrast'])).map((finding) => `light: ${finding}`));
    await page.page.evaluate(`document.documentElement.dataset.theme = 'dark'`);
    if (/popup|dialog|card/.test(part)) await page.page.keyboard.press('Escape');
  }
  expect([...new Set(found)]).toEqual([]);
  expect(page.errors).toEqual([]);
  await page.page.close();
});

/** Presses Tab, or Shift+Tab, until an element has the focus. */
async function tabTo({ page }: LabPage, selector: string, key = 'Tab'): Promise<void> {
  const isThere = () => page.evaluate((s) => document.activeElement?.matches(s) ?? false, selector);
  for (let i = 0; i < 60 && !(await isThere()); i++) await page.keyboard.press(key);
  expect(await isThere(), selector).toBe(true);
}

it('the keyboard alone adds a sphere, changes its roughness, takes it back, and shows it path traced', async () => {
  const page = await (await lab.open(small)).ready();
  const { keyboard } = page.page;
  const focused = (property: string) => page.page.evaluate<string>(`document.activeElement.${property}`);

  // The menus: File is left by an arrow, Add is gone through by its first letter.
  await tabTo(page, '.menu-button');
  await keyboard.press('Enter');
  await page.page.waitForSelector('[role=menu]');
  await keyboard.press('ArrowRight');
  await keyboard.press('ArrowRight');
  await keyboard.press('s');
  while (!(await focused('textContent')).startsWith('Sphere')) await keyboard.press('s');
  await keyboard.press('Enter');
  expect(await focused('textContent')).toBe('Add');
  const spheres = `Object.values(irradia.store.document.objects).filter(({ geometry }) => geometry.type === 'sphere').length`;
  await page.until(`${spheres} === 2`);

  // Fields that are still to come are there for the key that goes to them, though it comes in the same task.
  const areUsable = await page.page.evaluate(`(() => {
    const [body] = document.getElementsByClassName('inspector-body');
    document.querySelector('[data-entity="objects/ball"]').click();
    const before = !body.inert;
    dispatchEvent(new KeyboardEvent('keydown', { key: 'Tab' }));
    return [before, !body.inert];
  })()`);
  expect(areUsable).toEqual([false, true]);

  // The regions: on to the outliner, whose list leads to the material.
  await keyboard.press('F6');
  expect(await page.page.evaluate(`document.activeElement.closest('.panel-left') !== null`)).toBe(true);
  await tabTo(page, '[role=tree]');
  await keyboard.press('End');
  await page.until(
    `document.querySelector('.inspector-kind').textContent.toLowerCase().includes('material')`,
  );
  while (!(await page.page.evaluate(`document.activeElement.closest('.panel-right') !== null`)))
    await keyboard.press('F6');
  // Another model is another set of fields, among which the focus stays where it is.
  const models = `[data-label="Model"] select`;
  await tabTo(page, models);
  await keyboard.press('ArrowUp');
  await page.until(`irradia.store.document.materials.sphere.model !== 'principled'`);
  await page.inspector().waitFor({ state: 'attached' });
  expect(await page.page.evaluate(`document.activeElement.matches('${models}')`)).toBe(true);
  const roughness = `[data-label="Roughness"] input[type=range]`;
  await tabTo(page, roughness);
  const before = await focused('value');
  await keyboard.press('ArrowRight');
  expect(await focused('value')).not.toBe(before);
  await keyboard.press('Control+z');
  await page.until(`document.querySelector('${roughness}').value === '${before}'`);

  // The documents: the dialog keeps the focus, and gives it back.
  await keyboard.press('Control+Shift+O');
  await page.page.locator('dialog.documents').waitFor();
  for (let i = 0; i < 8; i++) await keyboard.press('Tab');
  expect(
    await page.page.evaluate(
      `document.activeElement.closest('dialog') !== null || document.activeElement === document.body`,
    ),
  ).toBe(true);
  await keyboard.press('Escape');
  expect(await page.page.evaluate(`document.activeElement.matches('${roughness}')`)).toBe(true);

  await keyboard.press('2');
  await page.until(
    `document.querySelector('.mode-switch [aria-checked=true]').textContent === 'Path traced'`,
  );
  await keyboard.press('p');
  expect(page.errors).toEqual([]);
  await page.page.close();
});

it('keys can be found, changed, swapped and reset, and are kept', async () => {
  const page = await (await lab.open(small)).ready();
  const { keyboard } = page.page;
  await keyboard.press('?');
  await page.page.locator('dialog.shortcuts').waitFor();
  await keyboard.type('light helpers');
  await page.page.locator('[data-action="view.helpers"] .shortcut-keys').focus();
  await keyboard.press('Enter');
  await keyboard.press('b');
  expect(await page.page.locator('.shortcut-conflict').innerText()).toContain('BRDF bench');
  // The focus is on what to do about it: swap.
  await keyboard.press('Enter');
  expect(await page.page.locator('[data-action="view.helpers"] .shortcut-keys').innerText()).toBe('B');
  await keyboard.press('Escape');

  const helpers = await page.page.evaluate<boolean>('irradia.store.document.view.helpers');
  await keyboard.press('b');
  await page.until(`irradia.store.document.view.helpers === ${!helpers}`);
  await keyboard.press('h');
  await page.page.locator('.bench').waitFor();

  const again = await (await lab.open({ ...small, beside: page })).ready();
  await again.page.locator('[data-keys="view.bench"]').first().hover();
  await again.page.locator('.tooltip:has-text("(H)")').waitFor();
  await again.page.keyboard.press('F1');
  await again.page.locator('dialog.shortcuts').getByText('Reset all').click();
  await again.page.keyboard.press('Escape');
  await again.page.locator('[data-keys="view.helpers"]').hover();
  await again.page.locator('.tooltip:has-text("(H)")').waitFor();
  expect([...page.errors, ...again.errors]).toEqual([]);
  await page.page.close();
  await again.page.close();
});

/** Whether what the tour points at is the first slider of what is selected. */
const IS_SLIDER_RINGED = `(() => {
  const slider = [...document.querySelectorAll('.panel-right .row:has(.slider)')].find((row) => row.checkVisibility());
  const [ring, row] = [document.querySelector('.tour-ring'), slider].map((element) => element?.getBoundingClientRect());
  return row !== undefined && Math.abs(ring.top - row.top) < 1 && Math.abs(ring.height - row.height) < 1;
})()`;

it('the tour is offered once, points at real things, and ends with Escape', async () => {
  const init = `Object.defineProperty(navigator, 'webdriver', { get: () => false })`;
  const page = await (await lab.open({ ...small, init })).ready();
  await page.page.locator('.invitation .primary').click();
  const title = page.page.locator('.tour-card h2');
  await title.waitFor();
  const titles = [await title.innerText()];
  for (let i = 0; i < 7; i++) {
    await page.page.keyboard.press('ArrowRight');
    titles.push(await title.innerText());
    if (i === 1) await page.until(IS_SLIDER_RINGED);
  }
  expect(new Set(titles).size).toBe(8);
  await page.page.keyboard.press('Escape');
  expect(await page.page.locator('.tour-card').count()).toBe(0);
  const again = await (await lab.open({ ...small, beside: page, init })).ready();
  expect(await again.page.locator('.invitation').count()).toBe(0);
  expect([...page.errors, ...again.errors]).toEqual([]);
  await page.page.close();
  await again.page.close();
});

it('on a narrow page one panel at a time lies below the picture, and fingers find what they touch', async () => {
  const page = await (await lab.open({ ...small, width: 390, height: 844 })).ready();
  for (const [tab, panel] of [
    ['Scene', '.panel-left'],
    ['Properties', '.panel-right'],
    ['Bench', '.bench'],
    ['Figures', '.status'],
  ] as const) {
    await page.page.locator('.sheet-tab', { hasText: tab }).click();
    const box = await page.page.locator(panel).boundingBox();
    const picture = await page.page.locator('.viewport').boundingBox();
    expect(box?.y, panel).toBeGreaterThanOrEqual((picture?.y ?? 0) + (picture?.height ?? 0));
    expect(picture?.height, panel).toBeGreaterThan(150);
  }
  expect(await page.page.evaluate('document.documentElement.scrollWidth <= innerWidth')).toBe(true);
  // What is asked for takes the place of the panel that is open.
  await page.page.getByRole('button', { name: 'Learn' }).click();
  await page.page.locator('.lesson-panel').waitFor();

  // Nothing in the bar is cut, nor is what is chosen told by a background alone where the browser takes these away.
  const term = page.page.locator('.term-select select');
  expect(await term.evaluate((select) => select.scrollWidth <= select.clientWidth)).toBe(true);
  await page.page.emulateMedia({ forcedColors: 'active' });
  const background = (state: string) =>
    page.page
      .locator(`.mode-switch [aria-checked=${state}]`)
      .first()
      .evaluate((button) => getComputedStyle(button).backgroundColor);
  expect(await background('true')).not.toBe(await background('false'));
  expect(page.errors).toEqual([]);
  await page.page.close();
});
