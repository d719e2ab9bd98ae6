/** A model's source, edited in the page while its picture follows. */
import { beforeAll, describe, expect, it } from 'vitest';
import { type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();
let page: LabPage;

const scene = small(
  {
    materials: { matte: { name: 'Matte', model: 'lambert', parameters: { albedo: [0.8, 0.1, 0.1] } } },
    objects: { ball: { name: 'Ball', material: 'matte', geometry: { type: 'sphere' } } },
    lights: { sun: { type: 'directional', name: 'Sun', position: [2, 3, 2], target: [0, 0, 0] } },
  },
  { width: 1300 },
);

beforeAll(async () => {
  page = await (await lab.open(scene)).ready();
  await page.select('materials', 'matte');
});

const said = (text: string) =>
  page.page.locator(`.source-message:has-text(${JSON.stringify(text)})`).waitFor();
const source = async () => Object.entries((await page.document()).models);

/** The first Escape may close what is offered to somebody who types slowly. */
async function leave(): Promise<void> {
  const focused = async () => {
    await page.page.keyboard.press('Escape');
    return page.page.evaluate(`document.activeElement.getAttribute('aria-label')`);
  };
  await expect.poll(focused).toBe('Close the source');
}

/** Puts the caret behind the last line that begins the function BRDF. */
async function intoBrdf(): Promise<void> {
  await page.page.click('.cm-content');
  await page.page.keyboard.press('Control+End');
  for (let i = 0; i < 60; i++) {
    const line = await page.page.locator('.cm-activeLine').innerText();
    if (/^vec3 BRDF\(/.test(line)) break;
    await page.page.keyboard.press('ArrowUp');
  }
  await page.page.keyboard.press('End');
}

describe('the source of a model', () => {
  it('opens by its key; one that ships is copied into the scene', async () => {
    await page.page.keyboard.press('Control+e');
    await said('Compiles');
    const [[name, entry] = []] = await source();
    expect(name).toBe('lambert 2');
    expect((await page.document()).materials.matte?.model).toBe('lambert 2');
    expect(await page.page.locator('.cm-content').innerText()).toContain('analytic');
    expect(entry).toHaveProperty('source', expect.stringContaining('::begin shader'));
  });

  it('says at its line what does not compile, and leaves picture and document as they are', async () => {
    const before = await page.picture();
    const [entry] = await source();
    await intoBrdf();
    // Nothing on the way compiles, however slowly it is typed: a new line alone would.
    await page.page.keyboard.type('?\nreturn vec3(0.0, albedo, 0.3);');
    for (const key of ['ArrowUp', 'End', 'Backspace', 'ArrowDown', 'End'])
      await page.page.keyboard.press(key);
    await said('Line');
    expect(await page.page.locator('.cm-lint-marker-error').count()).toBe(1);
    expect(await page.page.textContent('.source-message')).toMatch(/^Line \d+: .*last version/);
    expect(await source()).toEqual([entry]);
    expect((await page.picture()).hash).toBe(before.hash);
  });

  it('offers parameters, functions of the library and of GLSL', async () => {
    await page.page.keyboard.press('Enter');
    for (const [typed, label] of [
      ['alb', 'albedo'],
      ['smooths', 'smoothstep'],
      ['F_Schl', 'F_Schlick'],
    ] as const) {
      await page.page.keyboard.type(typed);
      await page.page.locator(`.cm-tooltip-autocomplete li:has-text("${label}")`).first().waitFor();
      await page.page.keyboard.press('Escape');
      for (let i = 0; i < typed.length; i++) await page.page.keyboard.press('Backspace');
    }
    await page.page.keyboard.press('Shift+Home');
    await page.page.keyboard.press('Backspace');
    await page.page.keyboard.press('Backspace');
  });

  it('puts what compiles into the scene: the picture follows, and undo brings the old one back', async () => {
    const before = await page.picture();
    const [entry] = await source();
    await page.page.keyboard.press('Shift+Home');
    await page.page.keyboard.type('return vec3(0.0, albedo.x, 0.3);');
    await said('Compiles');
    const after = await page.picture();
    expect(after.hash).not.toBe(before.hash);
    expect(await page.page.locator('.cm-lint-marker-error').count()).toBe(0);
    await page.page.keyboard.type(' // more');
    await said('Compiles');
    await leave();
    await page.page.keyboard.press('Control+z');
    expect(await source()).toEqual([entry]);
    expect((await page.picture()).hash).toBe(before.hash);
    expect(await page.page.locator('.cm-content').innerText()).not.toContain('albedo.x');
    await page.page.keyboard.press('Control+y');
    expect((await page.picture()).hash).toBe(after.hash);
  });

  it('gives the inspector the parameters that are written', async () => {
    await page.page.click('.cm-content');
    await page.page.keyboard.press('Control+Home');
    for (let i = 0; i < 60; i++) {
      if (/^::begin parameters/.test(await page.page.locator('.cm-activeLine').innerText())) break;
      await page.page.keyboard.press('ArrowDown');
    }
    await page.page.keyboard.press('End');
    await page.page.keyboard.type('\nfloat gain 0 4 1  # As it says.');
    await page.page.waitForSelector('[data-parameter=gain]');
    expect((await page.document()).materials.matte?.parameters).toEqual({ albedo: [0.8, 0.1, 0.1] });
  });

  it('closes with its model when the copy is undone, and reported no error', async () => {
    await leave();
    for (let i = 0; i < 3; i++) await page.page.keyboard.press('Control+z');
    expect(await source()).toEqual([]);
    expect(await page.page.locator('.source').isVisible()).toBe(false);
    expect(page.errors).toEqual([]);
    expect(await page.toasts()).toEqual([]);
  });
});
