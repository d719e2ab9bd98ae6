/** The colours of both themes: text can be read on every surface, and greys have no hue. */
import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { repository } from '../../vite.shared.config.ts';

const folder = `${repository}src/editor/style/`;
const css = readFileSync(`${folder}tokens.css`, 'utf8');

type Rgb = readonly [number, number, number];

function rgb(hex: string): Rgb {
  const digits = hex.length < 6 ? [...hex.slice(1)].map((d) => d + d).join('') : hex.slice(1);
  return [0, 2, 4].map((i) => Number.parseInt(digits.slice(i, i + 2), 16)) as unknown as Rgb;
}

const tokens = new Map(
  [...css.matchAll(/--([\w-]+): light-dark\((#\w+), (#\w+)\)/g)].map(([, name, light, dark]) => [
    name as string,
    { light: rgb(light as string), dark: rgb(dark as string) },
  ]),
);

/** WCAG 2.2, relative luminance. */
function luminance(color: Rgb): number {
  const [r, g, b] = color.map((c) => {
    const v = c / 255;
    return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** WCAG 2.2, contrast ratio. */
function contrast(a: Rgb, b: Rgb): number {
  const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y) as [number, number];
  return (light + 0.05) / (dark + 0.05);
}

const surfaces = ['bg-panel', 'bg-raised', 'bg-field', 'bg-hover', 'bg-selected', 'bg-deep'];
/** Of accents on a selected row and on the page's ground there are none that are only text. */
const plain = ['bg-panel', 'bg-raised', 'bg-field', 'bg-hover'];
const texts: [text: string, surfaces: readonly string[], ratio: number][] = [
  ['text', surfaces, 4.5],
  ['text-dim', surfaces, 4.5],
  ['text-faint', plain, 4.5],
  ['accent', [...plain, 'bg-selected'], 4.5],
  ['error', plain, 4.5],
  ['good', plain, 4.5],
  ['on-accent', ['accent'], 4.5],
  ['plot-text', ['plot-background'], 4.5],
  ['plot-faint', ['plot-background'], 4.5],
  ['plot-guide', ['plot-background'], 4.5],
  ['plot-light', ['plot-background'], 4.5],
  ['code-keyword', ['bg-field', 'code-selection'], 4.5],
  ['code-type', ['bg-field', 'code-selection'], 4.5],
  ['axis-y', ['bg-field'], 4.5],
  ['axis-z', ['bg-field'], 4.5],
  // WCAG 1.4.11: what is not text.
  ...Array.from({ length: 8 }, (_, i): [string, string[], number] => [`series-${i}`, ['plot-background'], 3]),
  ['plot-exact', ['plot-background'], 3],
  ['plot-schlick', ['plot-background'], 3],
  ['plot-bar', ['bg-panel'], 3],
  ['thumb', ['bg-panel', 'track'], 3],
  ['accent', ['bg-panel', 'bg-raised', 'bg-deep'], 3],
];

it.each(['light', 'dark'] as const)('can be read in the %s theme', (theme) => {
  const of = (name: string) => tokens.get(name)?.[theme] ?? expect.fail(`no colour ${name}`);
  const low = texts.flatMap(([text, on, ratio]) =>
    on
      .map((surface) => ({ text, surface, ratio: contrast(of(text), of(surface)) }))
      .filter((pair) => pair.ratio < ratio),
  );
  expect(low).toEqual([]);
});

it('has surroundings without a hue', () => {
  const grey = [...tokens].filter(([name]) => /^(bg-(?!selected)|text|line|edge|track|thumb)/.test(name));
  expect(grey.length).toBeGreaterThan(12);
  const tinted = grey.filter(([, { light, dark }]) => [light, dark].some(([r, g, b]) => r !== g || g !== b));
  expect(tinted.map(([name]) => name)).toEqual([]);
});

it('is the only place with colours, but for those that are the same in both themes', () => {
  /** The mark of the page, the picker's own colours, and what stands on a picture. */
  const same =
    /brand-mark|color-square|color-hue|\.handle|split-line|axes-gizmo|axis-end|studio-picture|environment-picture|material-drop|transparent/;
  const found = readdirSync(folder)
    .filter((name) => name !== 'tokens.css')
    .flatMap((name) =>
      [...readFileSync(`${folder}${name}`, 'utf8').matchAll(/([^{}]+)\{([^{}]*)\}/g)]
        .filter(
          ([, selector, rules]) =>
            /#[0-9a-f]{3,8}\b|rgba?\(/i.test(rules ?? '') && !same.test(selector ?? ''),
        )
        .map(([, selector]) => `${name}: ${selector?.trim()}`),
    );
  expect(found).toEqual([]);
});
