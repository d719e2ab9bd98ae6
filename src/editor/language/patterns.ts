/** Finds the catalogue's entry for a text whose holes are filled already: `Delete Lamp` by `Delete {name}`. */
import type { Catalogue } from './catalogue.ts';

interface Pattern {
  readonly expression: RegExp;
  readonly holes: readonly string[];
  readonly target: string;
}

/**
 * Holes of these names hold texts of the catalogue themselves; any other holds a name or a number, which stays as it is.
 */
const TRANSLATED_HOLES: ReadonlySet<string> = new Set(['label', 'reason', 'thing']);

const patternsOf = new WeakMap<Catalogue, readonly Pattern[]>();

/** The translation of the text, or the text itself where the catalogue has none. */
export function matchPatterns(catalogue: Catalogue, text: string): string {
  return entryFor(catalogue, text) ?? partsOf(catalogue, text);
}

/** What is wrong, after the place where it is; one sentence or several. */
function partsOf(catalogue: Catalogue, text: string): string {
  for (const separator of ['\n', '; ', ': ']) {
    const at = text.indexOf(separator);
    if (at < 0) continue;
    const [first, rest] = [text.slice(0, at), text.slice(at + separator.length)];
    return `${entryFor(catalogue, first) ?? first}${separator}${matchPatterns(catalogue, rest)}`;
  }
  return text;
}

function entryFor(catalogue: Catalogue, text: string): string | null {
  const exact = catalogue[text];
  if (typeof exact === 'string') return exact;
  for (const { expression, holes, target } of patterns(catalogue)) {
    const found = expression.exec(text);
    if (!found) continue;
    const values = new Map(holes.map((name, i) => [name, found[i + 1] ?? '']));
    return target.replace(/\{(\w+)\}/g, (hole, name: string) => {
      const value = values.get(name);
      if (value === undefined) return hole;
      return TRANSLATED_HOLES.has(name) ? matchPatterns(catalogue, value) : value;
    });
  }
  return null;
}

/** Those with the most words of their own first: they say most exactly what the text is. */
function patterns(catalogue: Catalogue): readonly Pattern[] {
  const made = patternsOf.get(catalogue);
  if (made) return made;
  const found = Object.entries(catalogue).flatMap(([source, entry]) => {
    const words = source.split(/\{\w+\}/);
    const own = words.join('').length;
    if (words.length === 1) return [];
    const expression = new RegExp(`^${words.map(literally).join('(.+?)')}$`, 's');
    const holes = [...source.matchAll(/\{(\w+)\}/g)].map((match) => match[1] ?? '');
    return [{ own, expression, holes, target: typeof entry === 'string' ? entry : entry.other }];
  });
  found.sort((a, b) => b.own - a.own);
  patternsOf.set(catalogue, found);
  return found;
}

function literally(words: string): string {
  return words.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
}
