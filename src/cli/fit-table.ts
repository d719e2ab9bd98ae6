import { valueText } from '../analysis/fit/code-sample.ts';
import type { Fit, FittedNumber } from '../analysis/fit/types.ts';
import type { Parameter } from '../brdf/model.ts';

/** A fit for a person at a terminal. */
export function fitTable(fit: Fit, target: string, parameters: readonly Parameter[]): string[] {
  return [
    `${fit.model} as ${target}`,
    '',
    ...columns([
      ['parameter', 'value', 'unseen within', ''],
      ...parameters.flatMap((parameter) => parameterRows(parameter, fit)),
    ]),
    '',
    ...columns([
      ['', 'cube root', 'of the target', 'look'],
      ['this fit', ...errorCells(fit.errors.cubeRoot, fit.size, fit.errors.look)],
      ['defaults', ...errorCells(fit.defaults.cubeRoot, fit.size, fit.defaults.look)],
      ...fit.candidates.map(({ metric, cubeRoot, look }) => [
        `by ${metric}${metric === fit.metric ? ' *' : ''}`,
        ...errorCells(cubeRoot, fit.size, look),
      ]),
    ]),
    ...(fit.loose.length ? ['', 'Not determined by the target:'] : []),
    ...fit.loose.map((names) =>
      names.length === 1 ? `  ${names[0]}: no visible effect here` : `  ${names.join(', ')}: only together`,
    ),
  ];
}

function parameterRows({ name, type }: Parameter, { parameters, numbers }: Fit): string[][] {
  const value = parameters[name] ?? 0;
  const own = numbers.filter((number) => number.name === name || number.name.startsWith(`${name}.`));
  if (own.length === 0) return [[name, valueText(value), '', type === 'bool' ? 'tried both' : 'fixed']];
  return own.map((number) => [number.name, valueText(number.value), playText(number), boundText(number)]);
}

function playText({ play }: FittedNumber): string {
  return `± ${play.toPrecision(2)}`;
}

function boundText({ bound }: FittedNumber): string {
  if (bound === null) return '';
  return bound === 'min' ? 'at its minimum' : 'at its maximum';
}

function errorCells(cubeRoot: number, size: number, look: number): string[] {
  return [cubeRoot.toPrecision(3), `${((100 * cubeRoot) / size).toPrecision(2)} %`, look.toPrecision(3)];
}

function columns(rows: readonly (readonly string[])[]): string[] {
  const widths = (rows[0] ?? []).map((_, i) => Math.max(...rows.map((row) => (row[i] ?? '').length)));
  return rows.map((row) =>
    row
      .map((cell, i) => cell.padEnd(widths[i] ?? 0))
      .join('  ')
      .trimEnd(),
  );
}
