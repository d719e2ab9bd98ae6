/** Every lesson that ships, in every language: it can be read, and its scene has all that it names. */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { shippedLessons } from '../../../lessons/index.ts';
import { directiveNames } from '../../../src/editor/learn/directives.ts';
import type { Lesson } from '../../../src/editor/learn/lesson.ts';
import { parseLesson } from '../../../src/editor/learn/parse.ts';
import { prepareLesson } from '../../../src/editor/learn/prepare.ts';
import { parseDocument } from '../../../src/scene/document.ts';

const lessons = shippedLessons.map(({ name, texts, scene }) => {
  const read = (language: string) => parseLesson(texts.get(language) ?? '', `${name}/lesson.${language}.md`);
  return { name, en: read('en'), es: read('es'), scene: parseDocument(scene, `${name}/scene.json`) };
});

/** What a translation has in common with the original: everything but words. */
const skeleton = ({ order, minutes, material, definitions, steps }: Lesson) => ({
  order,
  minutes,
  material,
  definitions: [...definitions.values()].map(({ key, target }) => ({ key, target })),
  steps: steps.map(({ blocks, settings }) => ({
    settings: settings.map(({ place, ...setting }) =>
      'name' in setting ? { ...setting, name: '' } : setting,
    ),
    blocks: blocks.map((block) => {
      if (block.kind === 'field') return [block.kind, block.path, block.range];
      return block.kind === 'formula' ? [block.kind, [...block.terms.keys()]] : [block.kind];
    }),
  })),
});

it('there are at least eight, each with a place of its own in the course', () => {
  expect(lessons.length).toBeGreaterThanOrEqual(8);
  const orders = lessons.map(({ en }) => en.order);
  expect(new Set(orders).size).toBe(orders.length);
});

describe.each(lessons)('$name', ({ en, es, scene }) => {
  it('is a lesson of its scene in English and in Spanish', () => {
    for (const lesson of [en, es]) {
      const { steps } = prepareLesson(lesson, scene);
      expect(steps.length).toBeGreaterThanOrEqual(5);
      for (const { title, blocks } of steps) {
        const kinds = new Set(blocks.map(({ kind }) => kind));
        // Each step has something to see or to do.
        expect(kinds.has('do') || kinds.has('see') || kinds.has('question'), title).toBe(true);
        const clickable = blocks.some((block) => block.kind === 'formula' && block.terms.size > 0);
        expect(clickable, `${title}: a formula whose terms can be clicked`).toBe(true);
      }
    }
  });

  it('says the same in both languages', () => {
    expect(skeleton(es)).toEqual(skeleton(en));
    expect(es.summary).not.toBe(en.summary);
  });
});

it('the example of docs/lessons.md is a lesson', () => {
  const docs = readFileSync(new URL('../../../docs/lessons.md', import.meta.url), 'utf8');
  const example = /```markdown\n([\s\S]*?)```/.exec(docs)?.[1] ?? '';
  const scene = parseDocument(
    {
      format: 'irradia',
      version: 1,
      materials: { ball: { name: 'Ball', model: 'cook-torrance' } },
      objects: { ball: { material: 'ball', geometry: { type: 'sphere' } } },
    },
    'scene.json',
  );
  expect(prepareLesson(parseLesson(example, 'lesson.en.md'), scene).steps).toHaveLength(2);
});

it('docs/lessons.md names every directive', () => {
  const docs = readFileSync(new URL('../../../docs/lessons.md', import.meta.url), 'utf8');
  for (const name of directiveNames) expect(docs).toContain(`:${name} `);
});
