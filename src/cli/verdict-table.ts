import type { Check, Property, Verdict, WorstCase } from '../analysis/verdict/verdict.ts';
import type { Parameter, ParameterValue } from '../brdf/model.ts';

/** A verdict for a person at a terminal. */

const TITLES: Readonly<Record<Property, string>> = {
  finiteness: 'finite everywhere',
  positivity: 'never negative',
  reciprocity: 'reciprocity',
  energy: 'energy',
  furnace: 'white furnace',
  distribution: 'facet distribution',
  'weak furnace': 'weak white furnace',
  lobes: 'lobes add up',
  continuity: 'continuity',
  density: 'sampling density',
  sampler: 'sampler',
  gpu: 'GPU = float64',
};

const WIDTH = 100;

export function verdictTable(
  { model, checks, sound }: Verdict,
  parameters: readonly Parameter[],
): readonly string[] {
  const columns = checks.map((check) => [TITLES[check.property], mark(check), check.figureText] as const);
  const widths = [0, 1].map((i) => Math.max(...columns.map((column) => (column[i] as string).length)));
  const lines = checks.flatMap((check, i) => {
    const [title = '', outcome = '', figure = ''] = columns[i] ?? [];
    const head = `${title.padEnd(widths[0] ?? 0)}  ${outcome.padEnd(widths[1] ?? 0)}  ${figure}`.trimEnd();
    const place =
      check.worst && check.outcome !== 'pass' ? wrapped(`Worst: ${placeText(check.worst, parameters)}`) : [];
    return [head, ...wrapped(check.sentence), ...place];
  });
  return [model, '', ...lines, '', summary(checks, sound)];
}

function mark({ outcome }: Check): string {
  return outcome === 'fail' ? 'FAIL' : outcome === 'not applicable' ? 'n/a' : outcome;
}

function summary(checks: readonly Check[], sound: boolean): string {
  const named = (outcome: Check['outcome']) =>
    checks.filter((check) => check.outcome === outcome).map(({ property }) => TITLES[property]);
  const given = named('given up');
  const waived = given.length ? `; given up, as its header says: ${given.join(', ')}` : '';
  return sound ? `Sound${waived}.` : `Broken: ${named('fail').join(', ')}${waived}.`;
}

/** As `brdf eval` reads it, so that a person can look at the case. */
function placeText({ term, parameters, l, v }: WorstCase, all: readonly Parameter[]): string {
  const changed = all.flatMap((parameter) => {
    const value = parameters[parameter.name];
    const same = value === undefined || JSON.stringify(value) === JSON.stringify(parameter.default);
    return same ? [] : [`${parameter.name} ${text(value)}`];
  });
  const parts = [
    ...(term === 'BRDF' ? [] : [term]),
    changed.length ? changed.join(', ') : 'the default parameters',
    ...(l ? [`l ${text(l)}`] : []),
    ...(v ? [`v ${text(v)}`] : []),
  ];
  return parts.join('; ');
}

function text(value: ParameterValue): string {
  const digits = (x: number) => String(+x.toPrecision(5));
  if (typeof value === 'boolean') return String(value);
  return typeof value === 'number' ? digits(value) : `[${value.map(digits).join(', ')}]`;
}

function wrapped(words: string): string[] {
  const lines: string[] = [];
  let line = '   ';
  for (const word of words.split(' ')) {
    if (line.length + 1 + word.length > WIDTH) {
      lines.push(line);
      line = '   ';
    }
    line += ` ${word}`;
  }
  return [...lines, line];
}
