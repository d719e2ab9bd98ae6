/** What `:plot` and `:pin` make of the bench. */
import { channels } from '../../analysis/plots/channel.ts';
import { substances } from '../../analysis/substances/table.ts';
import { findModel } from '../../scene/models.ts';
import type { Document } from '../../scene/schema.ts';
import { ownModel } from '../panels/bench/series.ts';
import {
  type BenchSettings,
  type BenchView,
  freeColor,
  initialSettings,
  moving,
  type Pin,
  STEEPEST,
} from '../panels/bench/settings.ts';
import { LessonError, shown } from './error.ts';
import type { Setting } from './lesson.ts';

type Plot = Extract<Setting, { kind: 'plot' | 'pin' }>;
/** What a value has to be: between two numbers, one of these words, true or false. */
type Rule = readonly [min: number, max: number] | { readonly words: readonly string[] } | 'flag';

const theta: Rule = [0, STEEPEST];
const azimuth: Rule = [-360, 360];

const RULES: Readonly<Partial<Record<keyof BenchSettings, Rule>>> = {
  thetaV: theta,
  thetaL: theta,
  thetaH: theta,
  thetaD: theta,
  phiV: azimuth,
  phiL: azimuth,
  azimuth,
  elevation: [-90, 90],
  over: { words: moving },
  channel: { words: ['rgb', ...channels] },
  tint: { words: ['rgb', ...channels] },
  range: [0, 1e6],
  brightness: [-20, 20],
  log: 'flag',
  cosine: 'flag',
  squareRoot: 'flag',
  chroma: 'flag',
};

const MOST_PINS = 6;

export function benchOf(
  bench: Partial<BenchSettings> | null,
  plot: Plot,
  document: Document,
  materialId: string | undefined,
): Partial<BenchSettings> {
  const material = document.materials[materialId ?? ''];
  const model = material && findModel(document, material.model);
  if (!material || !model) throw new LessonError(plot.place, 'the scene has no material to plot');
  const numbers = model.parameters.filter((parameter) => parameter.type === 'float').map(({ name }) => name);
  if (plot.kind === 'plot') {
    const rules: Readonly<Record<string, Rule>> = {
      ...RULES,
      term: { words: model.terms },
      parameter: { words: numbers },
      substance: { words: [...substances.keys()] },
    };
    for (const [name, value] of Object.entries(plot.settings)) checkSetting(plot, rules, name, value);
    return {
      ...bench,
      ...plot.settings,
      panes: initialSettings.panes.with(0, plot.view as BenchView),
      active: 0,
    };
  }
  if (!bench) throw new LessonError(plot.place, 'there is no plot to pin to', ':plot before it');
  const pins = bench.pins ?? [];
  if (pins.length >= MOST_PINS) throw new LessonError(plot.place, `more than ${MOST_PINS} pins`);
  const names = model.parameters.map(({ name }) => name);
  for (const [name, value] of Object.entries(plot.parameters)) {
    const parameter = model.parameters.find((one) => one.name === name);
    if (!parameter)
      throw new LessonError(
        plot.place,
        `${model.name} has no parameter “${shown(name)}”`,
        `one of ${names.join(', ')}`,
      );
    if (parameter.type === 'float' && typeof value !== 'number')
      throw new LessonError(plot.place, `${name} is no number`, `${name}=${parameter.default}`);
    if (parameter.type === 'bool' && typeof value !== 'boolean')
      throw new LessonError(plot.place, `${name} is neither true nor false`, `${name}=${parameter.default}`);
    if (parameter.type === 'color' && !isColor(value))
      throw new LessonError(plot.place, `${name} is no colour`, `${name}=[1,0,0]`);
  }
  const pin: Pin = {
    id: `lesson-${pins.length + 1}`,
    name: plot.name.slice(0, 60),
    model: material.model,
    source: ownModel(document, material.model),
    parameters: { ...material.parameters, ...plot.parameters },
    color: freeColor(pins),
  };
  return { ...bench, pins: [...pins, pin] };
}

function checkSetting(plot: Plot, rules: Readonly<Record<string, Rule>>, name: string, value: unknown): void {
  const rule = Object.hasOwn(rules, name) ? rules[name] : undefined;
  if (!rule)
    throw new LessonError(
      plot.place,
      `a plot has no ${shown(name)}`,
      `one of ${Object.keys(rules).join(', ')}`,
    );
  const expected =
    rule === 'flag'
      ? 'true or false'
      : 'words' in rule
        ? `one of ${rule.words.join(', ')}`
        : `${rule[0]} to ${rule[1]}`;
  const fits =
    rule === 'flag'
      ? typeof value === 'boolean'
      : 'words' in rule
        ? typeof value === 'string' && rule.words.includes(value)
        : typeof value === 'number' && value >= rule[0] && value <= rule[1];
  if (!fits) throw new LessonError(plot.place, `${name}=${shown(String(value))}`, expected);
}

const isColor = (value: unknown): boolean =>
  Array.isArray(value) && value.length === 3 && value.every((part) => typeof part === 'number');
