/**
 * The words of the page. English is in the code and is the key of every other language's catalogue
 * (docs/decisions/languages.md), so an English page loads none. This module waits for the catalogue, and so does
 * every module that has words: a constant made with `t` at the top of a module is in the right language, too.
 */
import type { Catalogue } from './catalogue.ts';
import { chosenLanguage, type Language } from './choice.ts';
import { translated } from './patterns.ts';

/** What stands in for `{name}` in a text. */
export type TextValues = Readonly<Record<string, string | number>>;

const catalogues: Readonly<Record<Exclude<Language, 'en'>, () => Promise<{ default: Catalogue }>>> = {
  es: () => import('./es/index.ts'),
};

/** A worker has no document; what it says is translated by the page that shows it. */
const wanted: Language = typeof document === 'undefined' ? 'en' : chosenLanguage();
// A catalogue that does not come must not keep anybody from working.
const catalogue: Catalogue | null = wanted === 'en' ? null : await load(wanted);

/** The language that the page speaks. */
export const language: Language = catalogue ? wanted : 'en';
if (typeof document !== 'undefined') document.documentElement.lang = language;

const pluralRules = new Intl.PluralRules(language);

/**
 * The text in the page's language; `{name}` is replaced by that value. The source is the English text; one that has
 * two meanings has a word behind a bar that tells them apart and is not shown: `Light|theme`.
 */
export function t(source: string, values: TextValues = {}): string {
  const entry = catalogue?.[source];
  return fill(typeof entry === 'string' ? entry : source.replace(/\|\w+$/, ''), values);
}

/** The text for so many, `{count}` in it; the key of the catalogue is the `other` form. */
export function plural(count: number, one: string, other: string, values: TextValues = {}): string {
  const form = pluralRules.select(count);
  const entry = catalogue?.[other];
  const text = typeof entry === 'object' ? (entry[form] ?? entry.other) : form === 'one' ? one : other;
  return fill(text, { count, ...values });
}

/**
 * A text that a room below the editor wrote in English: the label of a field, the name of an edit, an error's message.
 * Never for names that a person gave.
 */
export function translate(text: string): string {
  return catalogue ? translated(catalogue, text) : text;
}

function fill(text: string, values: TextValues): string {
  return text.replace(/\{(\w+)\}/g, (hole, name: string) => String(values[name] ?? hole));
}

async function load(name: Exclude<Language, 'en'>): Promise<Catalogue | null> {
  try {
    return (await catalogues[name]()).default;
  } catch (error) {
    console.warn(`The catalogue of ${name} did not come; the page stays English.`, error);
    return null;
  }
}
