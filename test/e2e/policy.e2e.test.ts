/** Nothing that a stranger sends becomes script: the page's Content-Security-Policy, tried from within. */
import { expect, it } from 'vitest';
import { contentSecurityPolicy, pageHeaders } from '../../src/page-policy.ts';
import { createDocument } from '../../src/scene/document.ts';
import { openLab } from './lab.ts';

const hostile = `<img src=x onerror="window.ran = 'name'"><script>window.ran = 'script'</script>`;
const document = {
  ...createDocument(hostile),
  description: hostile,
  materials: { m: { name: hostile, model: 'lambert' } },
  objects: { o: { name: hostile, material: 'm', geometry: { type: 'sphere' } } },
  lights: { l: { type: 'point', name: hostile } },
};
const lab = await openLab();

it('lets nothing become script, style or frame but what the page brings, and models alone come from elsewhere', () => {
  const directives = new Map(
    contentSecurityPolicy.split('; ').map((directive): [string, string[]] => {
      const [name = '', ...sources] = directive.split(' ');
      return [name, sources];
    }),
  );
  expect(Object.fromEntries(directives)).toEqual({
    // Frames, plug-ins, media and what is yet to be invented.
    'default-src': ["'none'"],
    // WebAssembly, unlike eval, cannot reach the page.
    'script-src': ["'self'", "'wasm-unsafe-eval'"],
    'style-src': ["'self'"],
    'font-src': ["'self'"],
    'img-src': ["'self'", 'data:', 'blob:'],
    'connect-src': ["'self'", 'data:', 'blob:', 'https:'],
    // KTX2 images are transcoded by one that three.js makes of a text.
    'worker-src': ["'self'", 'blob:'],
    'manifest-src': ["'self'"],
    'base-uri': ["'none'"],
    'form-action': ["'none'"],
  });
  expect(pageHeaders['Content-Security-Policy']).toBe(`${contentSecurityPolicy}; frame-ancestors 'none'`);
});

it('a hostile document is shown as the text that it is, and script in the page is refused', async () => {
  const files = { '/scene.json': JSON.stringify(document) };
  const page = await (await lab.open({ query: '?scene=/scene.json', files })).ready();
  const meta = page.page.locator('meta[http-equiv=Content-Security-Policy]');
  expect(await meta.getAttribute('content')).toBe(contentSecurityPolicy);
  await page.select('materials', 'm');
  await page.page.keyboard.press('b');
  await page.page.waitForSelector('.bench');
  expect(await page.page.locator('.scene-name').innerText()).toBe(hostile);
  expect(await page.page.locator('img[src=x]').count()).toBe(0);
  expect(page.errors).toEqual([]);

  const refused = await page.page.evaluate<string[]>(`(async () => {
    const violations = [];
    const areBothSaid = new Promise((resolve) => addEventListener('securitypolicyviolation', (event) => {
      violations.push(event.effectiveDirective);
      if (new Set(violations).size === 2) resolve();
    }));
    const script = document.createElement('script');
    script.textContent = 'window.ran = "inline"';
    document.head.append(script);
    const elsewhere = document.createElement('script');
    elsewhere.src = 'https://example.com/script.js';
    document.head.append(elsewhere);
    const image = document.createElement('img');
    image.setAttribute('onerror', 'window.ran = "attribute"');
    image.src = 'data:,';
    document.body.append(image);
    const frame = document.createElement('iframe');
    frame.srcdoc = '<script>parent.ran = "frame"</' + 'script>';
    const isFramed = new Promise((resolve) => frame.addEventListener('load', resolve));
    document.body.append(frame);
    const link = document.createElement('a');
    link.href = 'javascript:window.ran = "address"';
    link.click();
    await Promise.all([areBothSaid, isFramed]);
    return violations;
  })()`);
  expect(await page.page.evaluate('window.ran')).toBeUndefined();
  expect(new Set(refused)).toEqual(new Set(['script-src-elem', 'script-src-attr']));
  await page.page.close();
});
