/** What leaves the page: pictures of any size, the scene as GLB, a material as a file and as code. */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { decodeExr } from '../../src/io/exr.ts';
import { readGlb } from '../../src/io/gltf/glb.ts';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();
const page: LabPage = await (
  await lab.open({ query: '?scene=thesis-demo02', width: 880, height: 380 })
).ready();

async function downloaded(act: () => Promise<void>): Promise<{ name: string; bytes: Buffer }> {
  const [file] = await Promise.all([page.page.waitForEvent('download'), act()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

describe('export', () => {
  it('of a picture larger than the viewport, as PNG and as EXR', async () => {
    await page.menu('File', 'Picture…');
    const dialog = page.page.locator('.export-picture');
    const fill = async (label: string, value: number) => {
      const input = dialog.locator(`input[aria-label=${label}]`);
      await input.fill(String(value));
      await input.press('Tab');
    };
    await fill('Width', 1100);
    await fill('Height', 60);
    const png = await downloaded(() => dialog.locator('text="Export"').click());
    expect(png.name).toMatch(/-1100x60\.png$/);
    expect([png.bytes.readUInt32BE(16), png.bytes.readUInt32BE(20)]).toEqual([1100, 60]);
    expect(png.bytes.length).toBeGreaterThan(3000);
    await dialog.waitFor({ state: 'detached' });
    expect(await page.page.locator('.still').count()).toBe(0);
    expect((await page.picture()).colors).toBeGreaterThan(50);

    await page.menu('File', 'Picture…');
    await fill('Width', 60);
    await fill('Height', 40);
    await dialog.locator('select[aria-label=Format]').selectOption('exr');
    const exr = await downloaded(() => dialog.locator('text="Export"').click());
    const { width, height, channels } = decodeExr(exr.bytes, exr.name);
    expect([width, height, channels.length]).toEqual([60, 40, 3]);
    expect(Math.max(...channels.flatMap(({ pixels }) => [...pixels]))).toBeGreaterThan(0.1);
    await dialog.waitFor({ state: 'detached' });
    expect(page.errors).toEqual([]);
  });

  it('of a path traced picture, which can be given up', async () => {
    await page.menu('File', 'Picture…');
    const dialog = page.page.locator('.export-picture');
    await dialog.locator('select[aria-label=Picture]').selectOption('traced');
    await dialog.locator('select[aria-label=Format]').selectOption('jpg');
    await dialog.locator('input[aria-label=Width]').fill('64');
    await dialog.locator('input[aria-label=Width]').press('Tab');
    await dialog.locator('input[aria-label=Height]').fill('40');
    await dialog.locator('input[aria-label=Height]').press('Tab');
    await dialog.locator('input[aria-label=Samples]').fill('2');
    await dialog.locator('input[aria-label=Samples]').press('Tab');
    const jpg = await downloaded(() => dialog.locator('text="Export"').click());
    expect(jpg.name).toMatch(/-64x40\.jpg$/);
    expect([...jpg.bytes.subarray(0, 3)]).toEqual([0xff, 0xd8, 0xff]);
    await page.menu('File', 'Picture…');
    await dialog.locator('select[aria-label=Picture]').selectOption('traced');
    await dialog.locator('text="Export"').click();
    await dialog.locator('text="Cancel"').click();
    await dialog.waitFor({ state: 'detached' });
    expect((await page.toasts()).join()).not.toContain('was not exported');
    expect(page.errors).toEqual([]);
  });

  it('of the scene as GLB, which comes back by drop', async () => {
    const document = await page.document();
    const { name, bytes } = await downloaded(() => page.menu('File', 'Scene as GLB'));
    expect(name).toMatch(/\.glb$/);
    const json = JSON.parse(new TextDecoder().decode(readGlb(bytes, name).json));
    expect(json.meshes.length).toBeGreaterThan(0);
    await page.drop([{ name, content: bytes }]);
    await page.waitForToast(`Imported ${name}`);
    const objects = Object.keys((await page.document()).objects).length;
    expect(objects).toBe(2 * Object.keys(document.objects).length);
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(document);
    expect(page.errors).toEqual([]);
  });

  it('of a material as JSON, which comes back by drop, and as code', async () => {
    const [id = ''] = Object.keys((await page.document()).materials);
    await page.select('materials', id);
    const { name } = (await page.document()).materials[id]!;
    const file = await downloaded(() => page.menu('File', `Material ${name} as JSON`));
    expect(file.name).toMatch(/\.material\.json$/);
    const before = await page.document();
    await page.drop([{ name: file.name, content: file.bytes }]);
    await page.waitForToast('Added the material');
    const added = Object.entries((await page.document()).materials).filter(
      ([key]) => !(key in before.materials),
    );
    expect(added).toHaveLength(1);
    expect({ ...added[0]![1], name }).toEqual(before.materials[id]);
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);

    await page.select('materials', id);
    await page.page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.menu('File', `Copy material ${name} as code`);
    await page.waitForToast('The code is in the clipboard');
    expect(await page.page.evaluate('navigator.clipboard.readText()')).toMatch(
      /import \{ \w+ \} from 'irradia'/,
    );
    expect(page.errors).toEqual([]);
  });
});
