/** Nothing that a person reads on the page lacks its Spanish, and nothing in the catalogue is for nothing. */
import { expect, test } from 'vitest';
import spanish from '../../../src/editor/language/es/index.ts';
import { entryFor } from '../../../src/editor/language/patterns.ts';
import { editorFiles, pageTexts } from './page-texts.ts';
import { COMPOSED, roomTexts } from './room-texts.ts';
import { isWritten, untranslated } from './untranslated.ts';
import { workerImports } from './worker-imports.ts';

const files = editorFiles();
const page = pageTexts(files);
const rooms = await roomTexts();

/** The same text with nothing said of what fills its holes. */
const form = (text: string): string => text.replace(/\{\w+\}/g, '{}');
const holesOf = (text: string): string[] => [...new Set(text.match(/\{\w+\}/g))].toSorted();

test('every text of the page is in the catalogue, in its forms where it counts', () => {
  const missing = page.filter(({ text, counts }) => typeof spanish[text] !== (counts ? 'object' : 'string'));
  expect(missing.map(({ text, place }) => `${place} ${text}`)).toEqual([]);
});

test('every text that the editor shows of the rooms below it is in the catalogue', () => {
  const known = new Set(Object.keys(spanish).map(form));
  const isKnown = (text: string) =>
    known.has(form(text)) || (!text.includes('{') && entryFor(spanish, text) !== null);
  const missing = rooms.filter(({ text }) => !isKnown(text));
  expect(missing.map(({ text, from }) => `${from} ${text}`)).toEqual([]);
});

test('a translation has the holes of its source', () => {
  const different = Object.entries(spanish).flatMap(([source, entry]) =>
    (typeof entry === 'string' ? [entry] : [entry.other])
      .filter((text) => holesOf(text).join() !== holesOf(source).join())
      .map((text) => `${source} -> ${text}`),
  );
  expect(different).toEqual([]);
});

test('every entry of the catalogue is for a text that there is', () => {
  const used = new Set([...page, ...rooms].map(({ text }) => form(text)));
  for (const text of COMPOSED) used.add(form(text));
  // Such as where the values of a material come from: many sources in a few sentences.
  const fits = (source: string) => {
    const parts = source.split(/\{\w+\}/).map((part) => part.replace(/[^\p{L}\d ]/gu, '\\$&'));
    const pattern = new RegExp(`^${parts.join('.+?')}$`, 's');
    return parts.length > 1 && rooms.some(({ text }) => pattern.test(text));
  };
  expect(Object.keys(spanish).filter((source) => !used.has(form(source)) && !fits(source))).toEqual([]);
});

test('a text with its holes filled finds its entry', () => {
  const lost = rooms
    .filter(({ text }) => text.replace(/\{\w+\}|\P{L}/gu, '').length >= 3)
    .map(({ text }) =>
      text.replaceAll('{where}', 'with the light at 7° from the normal').replace(/\{\w+\}/g, '7'),
    )
    .filter((text) => entryFor(spanish, text) === null);
  expect(lost).toEqual([]);
});

test('what a person reads goes through t()', () => {
  expect(files.flatMap(untranslated).filter((found) => !isWritten(found))).toEqual([]);
});

test('no worker has the words of the page: the page translates what a worker says', () => {
  expect(workerImports(files).filter((path) => path.startsWith('src/editor/language/'))).toEqual([]);
});
