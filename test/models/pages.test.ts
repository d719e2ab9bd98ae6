import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { PROPERTIES } from '../../src/analysis/verdict/types.ts';
import { COMPUTED, filePart } from '../../tools/model-page.ts';

const folder = new URL('../../docs/models/', import.meta.url);
const read = (name: string) => readFileSync(new URL(name, folder), 'utf8');

test.each([...shippedModels])('docs/models/%s.md is fresh; `npm run docs` writes it', (name, model) => {
  const page = read(`${name}.md`);
  expect(page.slice(0, page.indexOf(COMPUTED))).toBe(
    filePart(model).slice(0, filePart(model).indexOf(COMPUTED)),
  );
  for (const property of PROPERTIES) expect(page).toContain(`| ${property} | `);
  for (const [, picture = ''] of page.matchAll(/!\[[^\]]*\]\(([^)]+)\)/g))
    expect(existsSync(new URL(picture, folder)), picture).toBe(true);
});

test('the index names every model', () => {
  const index = read('README.md');
  for (const name of shippedModels.keys()) expect(index).toContain(`[${name}](${name}.md)`);
});
