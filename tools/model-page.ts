/** The reference page of a model, from its file and its verdict: docs/models/NAME.md. */
import type { Check, Verdict } from '../src/analysis/verdict/types.ts';
import type { Parameter } from '../src/brdf/model.ts';
import type { Model } from '../src/glsl/model.ts';

/** What stands before this line follows from the file alone, and a test compares it; the rest takes a minute to compute. */
export const COMPUTED = '<!-- Below: computed by `npm run docs`. -->';

export function filePart({ name, file, parameters, terms, hasSampling }: Model): string {
  return [
    `<!-- Written by \`npm run docs\` from models/${name}.brdf. Do not edit. -->`,
    `# ${name}`,
    '',
    `![A sphere with the default parameters](${name}.png)`,
    '',
    ...file.documentation.split(/\n[ \t]*\n/).flatMap((paragraph) => [...paragraphOf(paragraph), '']),
    '## Parameters',
    '',
    ...parameterTable(parameters),
    '',
    `Terms: ${terms.map((term) => `\`${term}\``).join(', ')}.`,
    `Sampling: ${hasSampling ? 'its own' : 'generic'}.`,
    '',
    COMPUTED,
    '',
  ].join('\n');
}

/** What a header indents keeps its lines; a line before it is a heading. */
function paragraphOf(paragraph: string): string[] {
  const lines = paragraph.split('\n');
  const isIndented = (line: string) => /^\s/.test(line);
  const fenced = (inner: readonly string[]) => [
    '```text',
    ...inner.map((line) => line.replace(/^ {2}/, '')),
    '```',
  ];
  if (lines.every(isIndented)) return fenced(lines);
  const [first = '', ...rest] = lines;
  if (rest.length > 0 && rest.every(isIndented)) return [`### ${first}`, '', ...fenced(rest)];
  return lines;
}

function parameterTable(parameters: readonly Parameter[]): string[] {
  if (parameters.length === 0) return ['None.'];
  const rows = parameters.map((parameter) => {
    const range = parameter.type === 'float' ? `${parameter.min} to ${parameter.max}` : '';
    const value = Array.isArray(parameter.default) ? parameter.default.join(' ') : String(parameter.default);
    return `| \`${parameter.name}\` | ${parameter.type} | ${range} | ${value} | ${escaped(parameter.description)} |`;
  });
  return ['| Name | Type | Range | Default | What it does |', '| --- | --- | --- | --- | --- |', ...rows];
}

/** The verdict as a table; `map` is the file of its heat map, if it has one. */
export function verdictPart(
  { checks, sound }: Verdict,
  parameters: readonly Parameter[],
  map: string | null,
): string {
  const given = checks.filter(({ outcome }) => outcome === 'given up').map(({ property }) => property);
  const waived = given.length ? `; given up on purpose: ${given.join(', ')}` : '';
  return [
    '## Verdict',
    '',
    `${sound ? 'Sound' : 'Broken'}${waived}. [What each law means](../verdict.md).`,
    '',
    '| Law | Outcome | Figure | What it means |',
    '| --- | --- | --- | --- |',
    ...checks.map((check) => checkRow(check, parameters)),
    '',
    ...(map ? [`![The largest albedo over two parameters](${map})`, ''] : []),
  ].join('\n');
}

function checkRow(
  { property, outcome, figureText, sentence, worst }: Check,
  parameters: readonly Parameter[],
): string {
  const place = worst && outcome !== 'pass' ? ` Worst: ${changedText(worst.parameters, parameters)}.` : '';
  const mark = outcome === 'not applicable' ? 'n/a' : outcome;
  return `| ${property} | ${mark} | ${escaped(figureText)} | ${escaped(sentence + place)} |`;
}

function changedText(values: Readonly<Record<string, unknown>>, parameters: readonly Parameter[]): string {
  const digits = (x: unknown) => (typeof x === 'number' ? String(+x.toPrecision(3)) : String(x));
  const changed = parameters.flatMap(({ name, default: usual }) => {
    const value = values[name];
    if (value === undefined || JSON.stringify(value) === JSON.stringify(usual)) return [];
    return [`${name} ${Array.isArray(value) ? value.map(digits).join(' ') : digits(value)}`];
  });
  return changed.join(', ') || 'the default parameters';
}

const escaped = (text: string) => text.replaceAll('|', '\\|');
