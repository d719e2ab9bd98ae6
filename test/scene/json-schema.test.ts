import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { documentJsonSchemaText } from '../../src/scene/json-schema.ts';

test('docs/document.schema.json is fresh; `node tools/document-schema.mjs` writes it', () => {
  const file = new URL('../../docs/document.schema.json', import.meta.url);
  expect(readFileSync(file, 'utf8')).toBe(documentJsonSchemaText());
});

test('every field is described', () => {
  const undescribed: string[] = [];
  const walk = (value: unknown, path: string): void => {
    if (typeof value !== 'object' || value === null) return;
    const { properties } = value as { properties?: Record<string, object> };
    for (const [name, property] of Object.entries(properties ?? {})) {
      const speaksForItself = 'const' in property || 'properties' in property || 'oneOf' in property;
      if (!speaksForItself && !('description' in property)) undescribed.push(`${path}.${name}`);
    }
    for (const [key, child] of Object.entries(value)) walk(child, `${path}.${key}`);
  };
  walk(JSON.parse(documentJsonSchemaText()), '');
  expect(undescribed).toEqual([]);
});
