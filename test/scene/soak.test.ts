/** A long day at the page: a thousand commands of chance, undone and redone at every turn. */
import { expect, test } from 'vitest';
import { loadScene } from '../../scenes/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { parseDocument, serializeDocument } from '../../src/scene/document.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { act, commands, wrongCommands } from './every-command.ts';

const COMMANDS = 1000;
const named = Object.entries(commands).flatMap(([name, own]) =>
  own.map((command) => [name, command] as const),
);
/** What has changed the document, in all of the runs. */
const worked = new Set<string>();

const sources = import.meta.glob<string>('../../src/scene/*.ts', {
  query: '?raw',
  import: 'default',
  eager: true,
});
/** Looks at the store and changes nothing. */
const QUESTIONS = ['modelNameFor'];

test('every command of src/scene is among those of chance', () => {
  const declared = Object.values(sources)
    .flatMap((text) => [...text.matchAll(/^export function (\w+)\(\s*store: DocumentStore\b/gm)])
    .map(([, name = '']) => name);
  expect(declared.length).toBeGreaterThan(35);
  expect(Object.keys(commands).sort()).toEqual(declared.filter((name) => !QUESTIONS.includes(name)).sort());
});

/** The store keeps 500 steps; within a round none is forgotten. */
const ROUND = 250;

test.each([1, 2])(
  'a thousand commands, right and wrong, undone and redone, leave the document as it was: %i',
  async (seed) => {
    const random = createRandom(seed);
    const below = (n: number) => Math.floor(random() * n);
    const scene = await loadScene('thesis');
    const store = new DocumentStore(scene);
    const text = serializeDocument(scene);
    for (let done = 0; done < COMMANDS; done += ROUND) {
      /** Every state, by its place in the history. */
      let states: Document[] = [scene];
      for (let i = 0; i < ROUND; i += 1) {
        const kind = random();
        const before = store.document;
        const at = store.historyIndex;
        if (kind < 0.1) {
          const wrong = wrongCommands[below(wrongCommands.length)];
          expect(act(store, wrong, [])).not.toBeNull();
          expect(store.document).toBe(before);
          expect(store.historyIndex).toBe(at);
        } else if (kind < 0.2) store.undo();
        else if (kind < 0.3) store.redo();
        else if (kind < 0.33) store.goTo(below(states.length));
        else {
          const numbers = Array.from({ length: 4 }, () => below(1e6));
          const [name, command] = named[below(named.length)]!;
          if (act(store, command, numbers) !== null) expect(store.document).toBe(before);
          if (store.document !== before) {
            worked.add(name);
            expect(store.historyIndex).toBe(at + 1);
            states = [...states.slice(0, at + 1), store.document];
          }
        }
        expect(store.document).toBe(states[store.historyIndex]);
        expect(store.history).toHaveLength(states.length - 1);
      }
      const last = serializeDocument(store.document);
      expect(serializeDocument(parseDocument(last, 'again.json'))).toBe(last);
      const end = store.historyIndex;
      while (store.canUndo) store.undo();
      expect(store.document).toBe(scene);
      store.goTo(end);
      expect(serializeDocument(store.document)).toBe(last);
      store.goTo(0);
      store.open(scene);
    }
    expect(serializeDocument(store.document)).toBe(text);
  },
);

test('each of them has changed the document at least once', () => {
  expect(Object.keys(commands).filter((name) => !worked.has(name))).toEqual([]);
});
