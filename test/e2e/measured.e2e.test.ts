/** Measured BRDFs and saved parameters come to the page. */
import { describe, expect, it } from 'vitest';
import { writeCsail } from '../io/csail-writer.ts';
import { writeMerl } from '../io/merl-writer.ts';
import { writeRgl } from '../io/rgl-writer.ts';
import { CLAY_BALL, type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();
const page: LabPage = await (await lab.open(small(CLAY_BALL))).ready();
/** Without the measurements: they are megabytes. */
const models = () => page.page.evaluate('irradia.store.document.models');
const materialModel = (id: string) => page.page.evaluate(`irradia.store.document.materials['${id}'].model`);
const firstMaterial = async () => Object.keys((await page.document()).materials)[0] as string;

const bparam = (model: string, rows: string) =>
  `bparam ./brdfs/${model}.brdf\n\n::begin parameters\n${rows}\n::end parameters\n`;

describe('a dropped .bparam', () => {
  it('sets the model and its parameters, and says what the model does not have', async () => {
    const id = await firstMaterial();
    await page.select('materials', id);
    const rows = 'float roughness 0 1 0.125\nfloat shine 0 1 1\ncolor baseColor 0.1 0.2 0.3';
    await page.drop([{ name: 'my.bparam', content: bparam('principled', rows) }]);
    await page.waitForToast('has the values of my.bparam');
    await page.waitForToast('no such parameters: shine');
    expect((await page.document()).materials[id]).toMatchObject({
      model: 'principled',
      parameters: { roughness: 0.125, baseColor: [0.1, 0.2, 0.3] },
    });
    expect(page.errors).toEqual([]);
  });

  it('without its model says which file to add, and works with that file', async () => {
    const before = await page.document();
    const saved = { name: 'flat.bparam', content: bparam('flat', 'float level 0 2 1.5') };
    await page.drop([saved]);
    await page.waitForToast('flat.bparam was not opened');
    expect((await page.toasts()).join()).toContain('Add flat.brdf first');
    expect(await page.document()).toEqual(before);
    await page.page.click('.toast.error .icon-button');
    const flat = `analytic
::begin parameters
float level 0 2 1
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(level / 3.14159265); }
::end shader
`;
    await page.drop([saved, { name: 'flat.brdf', content: flat }]);
    await page.waitForToast('has the values of flat.bparam');
    const id = await firstMaterial();
    expect((await page.document()).materials[id]).toMatchObject({
      model: 'flat',
      parameters: { level: 1.5 },
    });
    expect(page.errors).toEqual([]);
  });
});

describe('a dropped MERL file', () => {
  const bytes = writeMerl((L, V) => [0.3 * L[2] * V[2], 0.05, 0.1]);

  it('becomes the model of the selected material, and undo takes it back', async () => {
    const id = await firstMaterial();
    const before = [await models(), await materialModel(id), await page.picture()];
    await page.drop([{ name: 'red paint.binary', content: bytes }]);
    await page.waitForToast('is now red paint');
    expect(await materialModel(id)).toBe('red paint');
    expect(await models()).toMatchObject({ 'red paint': { measured: 'red-paint' } });
    const picture = await page.picture();
    expect(picture.hash).not.toBe((before[2] as typeof picture).hash);
    await page.page.keyboard.press('Control+z');
    await page.page.keyboard.press('Control+z');
    expect([await models(), await materialModel(id), await page.picture()]).toEqual(before);
    expect(page.errors).toEqual([]);
  });

  it('that is cut or no such file says so, and changes nothing', async () => {
    const before = await page.document();
    await page.drop([{ name: 'cut.binary', content: bytes.subarray(0, 4000) }]);
    await page.waitForToast('cut.binary was not opened');
    expect((await page.toasts()).join()).toMatch(/unchanged\s+cut\.binary: byte 4000: the file ends here/);
    await page.drop([{ name: 'text.binary', content: 'this is no BRDF' }]);
    await page.waitForToast('text.binary was not opened');
    expect((await page.toasts()).join()).toContain('not a MERL BRDF');
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
  });
});

describe.each([
  [
    'foil.bsdf',
    () => writeRgl((L, V) => [0.3 * L[2] * V[2], 0.05, 0.1], { thetas: 4, resolution: 8 }),
    'not a tensor file',
  ],
  [
    'satin.dat',
    () => writeCsail((L, V) => [0.05, 0.3 * L[2] * V[2], 0.1], { bins: [6, 6, 12, 8] }),
    'not a CSAIL BRDF',
  ],
] as const)('a dropped %s', (name, write, fault) => {
  it('becomes the model of the selected material and shows', async () => {
    const id = await firstMaterial();
    const before = await page.picture();
    await page.drop([{ name, content: write() }]);
    await page.waitForToast(`is now ${name.split('.')[0]}`);
    expect(await materialModel(id)).toBe(name.split('.')[0]);
    expect((await page.picture()).hash).not.toBe(before.hash);
    await page.page.keyboard.press('Control+z');
    await page.page.keyboard.press('Control+z');
    expect(await page.picture()).toEqual(before);
    expect(page.errors).toEqual([]);
  });

  it('that is no such file says so, and changes nothing', async () => {
    const before = await page.document();
    await page.drop([{ name: `text.${name.split('.')[1]}`, content: 'this is no BRDF' }]);
    await page.waitForToast(`text.${name.split('.')[1]} was not opened`);
    expect((await page.toasts()).join()).toContain(fault);
    expect(await page.document()).toEqual(before);
  });
});

describe('a substance in the inspector', () => {
  it('sets what the model needs in one step, and shows which one it is', async () => {
    const id = await firstMaterial();
    await page.select('materials', id);
    await page.page.selectOption('select[aria-label="Model"]', 'principled');
    const choice = page.page.locator('select[aria-label="Substance"]');
    const before = (await page.document()).materials[id];
    await choice.selectOption('gold');
    expect((await page.document()).materials[id]?.parameters).toMatchObject({ metallic: 1 });
    expect(await choice.inputValue()).toBe('gold');
    await page.page.keyboard.press('Control+z');
    expect((await page.document()).materials[id]).toEqual(before);
    expect(await choice.inputValue()).toBe('');
    expect(page.errors).toEqual([]);
  });
});
