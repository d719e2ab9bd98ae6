/** A long day at the page: a thousand commands of chance, undone and redone at every turn. */
import { expect, test } from 'vitest';
import { loadScene } from '../../scenes/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { DocumentError } from '../../src/scene/error.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { act, everyCommand, wrongCommands } from './every-command.ts';

const COMMANDS = 1000;
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
          expect(() => act(store, wrong, [])).toThrow(DocumentError);
          expect(store.document).toBe(before);
          expect(store.historyIndex).toBe(at);
        } else if (kind < 0.2) store.undo();
        else if (kind < 0.3) store.redo();
        else if (kind < 0.33) store.goTo(below(states.length));
        else {
          // Beyond what the scene can hold, or what is locked: refused, which is right, too.
          try {
            act(store, everyCommand[below(everyCommand.length)], [below(1000), below(1000), below(1000)]);
          } catch (error) {
            if (!(error instanceof DocumentError)) throw error;
            expect(store.document).toBe(before);
          }
          if (store.document !== before) {
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
