/** The lines of a lesson that begin with a colon: what each is called, what follows its name, what it becomes. */
import { effectNames, effectShapes } from '../../scene/effects-schema.ts';
import { SHOWN } from '../../scene/stage-schema.ts';
import { views } from '../panels/bench/settings.ts';
import { type Rendering, renderings } from '../state.ts';
import { LessonError, type Place, shown } from './error.ts';
import type { Block, Definition, Inline, Range, Setting, Target } from './lesson.ts';
import { parseInline } from './prose.ts';
import { readValue, type Words } from './words.ts';

/** An answer belongs to the question before it. */
export type Directive =
  | { readonly block: Block }
  | { readonly setting: Setting }
  | { readonly definition: Definition }
  | { readonly answer: readonly Inline[] };

const KEY = /^[A-Za-z][A-Za-z0-9-]{0,31}$/;

const readers: Readonly<Record<string, (words: Words, place: Place) => Directive>> = {
  define: (words, place) => ({ definition: definition(words, place) }),
  do: (words, place) => ({ block: { kind: 'do', text: sentence(words), place } }),
  see: (words, place) => ({ block: { kind: 'see', text: sentence(words), place } }),
  question: (words, place) => ({
    block: { kind: 'question', question: sentence(words), answer: [], place },
  }),
  answer: (words) => ({ answer: sentence(words) }),
  slider: (words, place) => ({ block: field(words, place, true) }),
  field: (words, place) => ({ block: field(words, place, false) }),
  set: (words, place) => {
    const path = words.word('the path of a field and its value');
    const text = words.rest();
    const value = readValue(text);
    if (value === undefined)
      words.fail(`“${shown(text)}” is no value`, 'a number, true, false, a word, [r, g, b] or JSON');
    return { setting: { kind: 'set', path, value, place } };
  },
  without: (words, place) => {
    const entities = [words.word('what the step does without, such as lights.key')];
    for (let word = words.optional(); word !== null; word = words.optional()) entities.push(word);
    return { setting: { kind: 'without', entities, place } };
  },
  effect: (words, place) => {
    const name = oneOf(words, effectNames);
    if (!('enabled' in effectShapes[name]))
      words.fail(`${name} cannot be switched on and off`, `:set effects.${name}.<field> <value>`);
    const value = oneOf(words, ['on', 'off']) === 'on';
    words.nothingMore();
    return { setting: { kind: 'set', path: `effects.${name}.enabled`, value, place } };
  },
  look: (words, place) => {
    const from = vector(words, 'x y z, where the camera is');
    const at = words.optional();
    if (at !== null && at !== 'at') words.fail(`“${shown(at)}”`, 'at x y z, or the end of the line');
    const target = at === null ? null : vector(words, 'x y z, what the camera looks at');
    words.nothingMore();
    return { setting: { kind: 'look', from, at: target, place } };
  },
  term: (words, place) => {
    const name = words.word('the name of a term, such as distribution');
    const of = words.optional();
    if (of !== null && of !== 'of') words.fail(`“${shown(of)}”`, 'of <material>, or the end of the line');
    const material = of === null ? null : words.word('the id of a material');
    words.nothingMore();
    return { setting: { kind: 'term', name, material, place } };
  },
  plot: (words, place) => {
    const view = oneOf(words, views);
    const settings: Record<string, string | number | boolean> = {};
    for (const [name, text] of words.pairs()) {
      const value = readValue(text);
      if (typeof value === 'number' || typeof value === 'boolean' || typeof value === 'string')
        settings[name] = value;
      else words.fail(`${name}=${shown(text)}`, 'a number, true, false or a word');
    }
    return { setting: { kind: 'plot', view, settings, place } };
  },
  pin: (words, place) => {
    const name = words.word('a name, in "quotes" if it has spaces').replace(/"/g, '');
    const parameters = Object.fromEntries(
      [...words.pairs()].map(([parameter, text]) => [parameter, readValue(text)]),
    );
    return { setting: { kind: 'pin', name, parameters, place } };
  },
  show: (words, place) => {
    const what = oneOf(words, [...Object.keys(WORDS), ...renderings, ...SHOWN]);
    words.nothingMore();
    const rendering = WORDS[what] ?? renderings.find((name) => name === what);
    if (rendering) return { setting: { kind: 'rendering', rendering, place } };
    return { setting: { kind: 'set', path: 'view.show', value: what, place } };
  },
  select: (words, place) => {
    const entity = words.word('what to select, such as lights.key');
    words.nothingMore();
    return { setting: { kind: 'select', entity, place } };
  },
};

/** What a person calls the renderings. */
const WORDS: Readonly<Record<string, Rendering>> = { both: 'split' };

export const directiveNames: readonly string[] = Object.keys(readers);

export function readDirective(name: string, words: Words, place: Place): Directive {
  const reader = Object.hasOwn(readers, name) ? readers[name] : undefined;
  if (!reader)
    throw new LessonError(place, `there is no :${shown(name)}`, `one of :${directiveNames.join(', :')}`);
  return reader(words, place);
}

function definition(words: Words, place: Place): Definition {
  const key = words.word('a key, what it stands for, a sentence');
  if (!KEY.test(key)) words.fail(`“${shown(key)}” is no key`, 'letters and digits, a letter first');
  const target = targetOf(words.word('a term, the path of a field, or -'));
  return { key, target, text: sentence(words), place };
}

function targetOf(word: string): Target {
  if (word === '-') return { kind: 'idea' };
  return word.includes('.') ? { kind: 'field', path: word } : { kind: 'term', name: word };
}

function sentence(words: Words): Inline[] {
  const text = words.rest();
  if (text === '') words.fail('there is no text', 'a sentence');
  return parseInline(text);
}

function field(words: Words, place: Place, needsRange: boolean): Block {
  const path = words.word('the path of a field, such as lights.key.intensity');
  const min = words.optionalNumber();
  const max = words.optionalNumber();
  let range: Range | null = null;
  if (min !== null || max !== null) {
    if (min === null || max === null || !(min < max))
      words.fail('the range is not one', 'two numbers, the smaller first');
    range = [min, max];
  } else if (needsRange) words.fail('the range is missing', `:slider ${path} 0 1 Label`);
  return { kind: 'field', path, range, label: words.rest(), place };
}

function vector(words: Words, expected: string): [number, number, number] {
  return [words.number(expected), words.number(expected), words.number(expected)];
}

function oneOf<T extends string>(words: Words, choices: readonly T[]): T {
  const list = choices.join(', ');
  const word = words.word(`one of ${list}`);
  const found = choices.find((choice) => choice === word);
  return found ?? words.fail(`“${shown(word)}”`, `one of ${list}`);
}
