/** Files come to the page: good ones, broken ones, and those that the server hands over. */
import { describe, expect, it } from 'vitest';
import { encodeExr } from '../../src/io/exr.ts';
import { createDocument, serializeDocument } from '../../src/scene/document.ts';
import { quadGlb } from './glb.ts';
import { CLAY_BALL, type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();
const page: LabPage = await (await lab.open(small(CLAY_BALL))).ready();

const RED = `analytic
# A red that glows a little at the edge.
::begin parameters
float edge 0 4 1 # how much
color tint .8 .1 .1 # linear
::end parameters
::begin shader
vec3 rim(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return edge * tint * pow(1 - dot(N, V), 3); }
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return tint / 3.14159265 + rim(L, V, N, X, Y); }
::end shader
`;

describe('a dropped .brdf', () => {
  it('becomes the model of the selected material, with its sliders and terms', async () => {
    const [id = ''] = Object.keys((await page.document()).materials);
    await page.select('materials', id);
    const before = await page.picture();
    await page.drop([{ name: 'my red.brdf', content: RED }]);
    await page.waitForToast('is now my red');
    const document = await page.document();
    expect(document.materials[id]?.model).toBe('my red');
    expect(document.models['my red']).toEqual({ source: RED });
    expect((await page.picture()).hash).not.toBe(before.hash);
    await page.page.waitForSelector('[data-parameter=edge]');
    expect(await page.page.locator('[data-parameter=edge] .row-label').getAttribute('data-tip')).toContain(
      'how much',
    );
    const terms = await page.page.locator('.term-select option').allInnerTexts();
    expect(terms).toContain('rim');

    await page.page.selectOption('.term-select select', { label: 'rim' });
    const term = (await page.document()).view.term;
    expect(term).toEqual({ material: id, name: 'rim' });
    await page.page.selectOption('.term-select select', '');
    for (let i = 0; i < 4; i++) await page.page.keyboard.press('Control+z');
    expect((await page.picture()).hash).toBe(before.hash);
    expect(page.errors).toEqual([]);
  });

  it('that is broken says file and line, and changes nothing', async () => {
    const before = await page.document();
    await page.drop([{ name: 'broken.brdf', content: RED.replace('dot(N, V)', 'dot(N V)') }]);
    await page.waitForToast('broken.brdf');
    expect((await page.toasts()).join()).toMatch(/unchanged\s+broken\.brdf:8/);
    expect(await page.document()).toEqual(before);
    await page.page.click('.toast .icon-button');
  });
});

describe('a dropped GLB', () => {
  it('adds its objects and materials, in one undo step', async () => {
    const before = await page.document();
    const picture = await page.picture();
    await page.drop([{ name: 'quad.glb', content: quadGlb() }]);
    await page.waitForToast('quad.glb');
    const document = await page.document();
    const added = Object.keys(document.objects).filter((id) => !(id in before.objects));
    expect(added).toHaveLength(1);
    const material = document.materials[document.objects[added[0] ?? '']?.material ?? ''];
    expect(material?.model).toBe('principled');
    expect((await page.picture()).hash).not.toBe(picture.hash);
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);
    expect((await page.picture()).hash).toBe(picture.hash);
    expect(page.errors).toEqual([]);
  });

  it.each([
    ['truncated.glb', quadGlb().slice(0, 60)],
    ['text.glb', 'this is not a model'],
    ['broken.json', '{"format": "irradia", "version": 1, "lights": {"a": {"type": "lamp"}}}'],
    ['newer.json', '{"format": "irradia", "version": 999}'],
    ['half.json', '{"format": "irr'],
    ['notes.txt', 'hello'],
  ])('%s gives a readable message and changes nothing', async (name, content) => {
    const before = await page.document();
    await page.drop([{ name, content }]);
    await page.waitForToast(name);
    expect(await page.page.locator('.toast.error').count()).toBeGreaterThan(0);
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
    await page.page.click('.toast.error .icon-button');
  });
});

describe('an environment', () => {
  it('that ships lights the scene once it has come', async () => {
    const before = await page.picture();
    await page.page.keyboard.press('Escape');
    await page.page.selectOption('select[aria-label=Environment]', 'preset:studio');
    expect((await page.document()).environment.source).toEqual({ type: 'preset', name: 'studio' });
    expect((await page.picture()).hash).not.toBe(before.hash);
    await page.page.keyboard.press('Control+z');
    expect((await page.picture()).hash).toBe(before.hash);
    expect(page.errors).toEqual([]);
  });

  it('of the person’s own comes by drop, and a broken one changes nothing', async () => {
    const before = await page.document();
    const pixels = new Float32Array(8 * 4).fill(0.7);
    const channels = ['R', 'G', 'B'].map((name) => ({ name, type: 'half' as const, pixels }));
    await page.drop([{ name: 'grey.exr', content: encodeExr({ width: 8, height: 4, channels }) }]);
    await page.waitForToast('grey.exr lights the scene');
    expect((await page.document()).environment.source.type).toBe('hdr');
    await page.picture();
    await page.page.keyboard.press('Control+z');
    await page.drop([{ name: 'broken.hdr', content: '#?RADIANCE\nthis is not an image' }]);
    await page.waitForToast('broken.hdr');
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
    await page.page.click('.toast.error .icon-button');
  });
});

describe('the address', () => {
  it('opens the document that the server hands over', async () => {
    const other = await lab.open(small({ name: 'Handed over' }));
    await other.ready();
    expect((await other.document()).name).toBe('Handed over');
    expect(other.errors).toEqual([]);
  });

  it('names the scenes that ship when it asks for one that does not', async () => {
    const other = await lab.open({ query: '?scene=nowhere' });
    await other.waitForToast('There is no scene "nowhere"');
    await other.ready();
    expect((await other.toasts()).join()).toContain('thesis');
  });
});

describe('a browser without WebGPU and WebGL 2', () => {
  it('is told what to do, and still opens documents', async () => {
    const init = `
      Object.defineProperty(navigator, 'gpu', { value: undefined });
      HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
        apply: (target, self, args) => (args[0] === '2d' ? Reflect.apply(target, self, args) : null),
      });`;
    const other = await lab.open({ init });
    await other.page.waitForSelector('.failure');
    expect(await other.page.locator('.failure').textContent()).toMatch(/WebGPU or WebGL 2/);
    await other.drop([{ name: 'empty.json', content: serializeDocument(createDocument('Empty')) }]);
    await other.waitForToast('Opened Empty');
  });
});
