/** Finds the catalogue's entry for a text whose holes are filled already: `Delete Lamp` by `Delete {name}`. */
import type { Catalogue } from './catalogue.ts';

interface Pattern {
  readonly expression: RegExp;
  readonly holes: readonly string[];
  readonly target: string;
}

/** Holes of these names hold texts of the catalogue. Any other holds a name or a figure, and stays as it is. */
const TRANSLATED_HOLES: ReadonlySet<string> = new Set([
  'label',
  'where',
  'what',
  'expected',
  'message',
  'found',
  'note',
]);

/** What stands in these holes; in any other may stand anything. */
const HOLE_FORMS: Readonly<Record<string, string>> = {
  count: '\\d+',
  line: '\\d+',
  byte: '\\d+',
  // Two holes side by side: this one is the end of a verdict's sentence.
  where: '[Ww]ith .+ from the normal',
};

/** A pattern of fewer letters, such as `{min} to {max}`, would find itself in names, too. */
const FEWEST_LETTERS = 3;

const patternsOf = new WeakMap<Catalogue, readonly Pattern[]>();

/** The translation of the text, or the text itself where the catalogue has none. */
export function translated(catalogue: Catalogue, text: string): string {
  return entryFor(catalogue, text) ?? partsOf(catalogue, text);
}

/** The entry for the whole text, null where there is none. */
export function entryFor(catalogue: Catalogue, text: string): string | null {
  const exact = Object.hasOwn(catalogue, text) ? catalogue[text] : undefined;
  if (exact !== undefined) return typeof exact === 'string' ? exact : exact.other;
  for (const { expression, holes, target } of patterns(catalogue)) {
    const found = expression.exec(text);
    if (!found) continue;
    const values = new Map(holes.map((name, i) => [name, filling(catalogue, name, found[i + 1] ?? '')]));
    return target.replace(/\{(\w+)\}/g, (hole, name: string) => values.get(name) ?? hole);
  }
  return null;
}

/** Errors say where, what and what was expected, with signs between; names and places come first. */
function partsOf(catalogue: Catalogue, text: string): string {
  for (const separator of ['\n', '; ', ': ']) {
    const at = text.indexOf(separator);
    if (at < 0) continue;
    const [first, rest] = [text.slice(0, at), text.slice(at + separator.length)];
    const before = separator === ': ' ? placeOf(catalogue, first) : translated(catalogue, first);
    return `${before}${separator}${translated(catalogue, rest)}`;
  }
  return counted(catalogue, text);
}

/** `line 12`; a word alone may be a name that a person gave. */
const placeOf = (catalogue: Catalogue, text: string): string =>
  (/^\w+ \d+$/.test(text) ? entryFor(catalogue, text) : null) ?? text;

function filling(catalogue: Catalogue, hole: string, value: string): string {
  if (COUNTS.test(value)) return counted(catalogue, value);
  if (!TRANSLATED_HOLES.has(hole)) return value;
  const known = entryFor(catalogue, value);
  if (known !== null) return known;
  // Labels stand in lower case within a sentence, sentences' beginnings in upper case alone.
  const other = entryFor(catalogue, toggled(value));
  return other === null ? translated(catalogue, value) : toggled(other);
}

const COUNTS = /^\d+ [a-z]/;

/** `2 lights, 1 object and 3 materials`; anything else as it is. */
function counted(catalogue: Catalogue, value: string): string {
  if (!COUNTS.test(value)) return value;
  const and = entryFor(catalogue, 'and') ?? 'and';
  return value
    .split(/(, | and )/)
    .map((part) => (part === ' and ' ? ` ${and} ` : (entryFor(catalogue, part) ?? part)))
    .join('');
}

/** The first letter in the other case. */
function toggled(text: string): string {
  const first = text.charAt(0);
  const upper = first.toUpperCase();
  return (first === upper ? first.toLowerCase() : upper) + text.slice(1);
}

/** Those with the most words of their own first, for they say most exactly what the text is. */
function patterns(catalogue: Catalogue): readonly Pattern[] {
  const made = patternsOf.get(catalogue);
  if (made) return made;
  const found = Object.entries(catalogue).flatMap(([source, entry]) => {
    const words = source.split(/\{\w+\}/);
    const letters = words.join('').replace(/\P{L}/gu, '').length;
    if (words.length === 1 || letters < FEWEST_LETTERS) return [];
    const holes = [...source.matchAll(/\{(\w+)\}/g)].map((match) => match[1] ?? '');
    const forms = [...holes.map((name) => `(${HOLE_FORMS[name] ?? '.+?'})`), ''];
    const expression = new RegExp(`^${words.map((part, i) => literally(part) + forms[i]).join('')}$`, 's');
    const target = typeof entry === 'string' ? entry : entry.other;
    // Around a text of the catalogue: that one is translated for itself.
    const around = words[0] === '' && TRANSLATED_HOLES.has(holes[0] ?? '');
    return [{ around, letters, expression, holes, target }];
  });
  found.sort((a, b) => Number(b.around) - Number(a.around) || b.letters - a.letters);
  patternsOf.set(catalogue, found);
  return found;
}

function literally(words: string): string {
  return words.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
}
