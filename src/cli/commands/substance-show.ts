import { shippedModels } from '../../../models/index.ts';
import { substanceParameters } from '../../analysis/substances/parameters.ts';
import { reflectedColor, schlickColor, worstSchlickError } from '../../analysis/substances/reflectance.ts';
import { opticalConstants, type Substance } from '../../analysis/substances/substance.ts';
import { substances } from '../../analysis/substances/table.ts';
import { LIGHTS, type WhiteLight } from '../../color/light.ts';
import { CliError, type Command, UsageError } from '../command.ts';
import { rgbText } from '../rgb-text.ts';

/** Fraunhofer's lines F (blue), D (yellow) and C (red), in nm. */
const LINES = { F: 486.1, D: 589.3, C: 656.3 } as const;
const ANGLES = [0, 15, 30, 45, 60, 70, 75, 80, 85, 88, 90];

const command: Command = {
  usage: 'substance show NAME [--light D65|E|A] [--json]',
  summary: 'A substance: n and k, its reflection over the angle, and the parameters that give it.',
  details: [
    '  NAME      as `irradia substance list` has it',
    "  --light   what it is looked at under; its white is RGB 1 1 1. D65, daylight, is Rec. 709's own (the default)",
    '  --json    as JSON: {"name", "title", "kind", "source", "range", "lines", "f0", "angles", "schlick", "parameters"}',
  ],
  options: { json: { type: 'boolean' }, light: { type: 'string', default: 'D65' } },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [name = ''], options: { json, light } }) {
    const substance = substances.get(name);
    if (!substance)
      throw new CliError(`there is no substance '${name}'; there are: ${[...substances.keys()].join(', ')}`);
    const white = LIGHTS.find((known) => known === light);
    if (!white) throw new UsageError(`--light ${light}: expected ${LIGHTS.join(', ')}`);
    const description = describe(substance, white);
    console.log(json ? JSON.stringify(description, null, 2) : page(description, white));
    return 0;
  },
};

export default command;

function describe(substance: Substance, light: WhiteLight) {
  const { name, title, kind, source } = substance;
  const f0 = reflectedColor(substance, 1, light);
  const lines = Object.entries(LINES).map(([line, nm]) => {
    const [n, k] = opticalConstants(substance, nm);
    return { line, nm, n, k };
  });
  const angles = ANGLES.map((angle) => {
    const cosine = Math.max(0, Math.cos((angle * Math.PI) / 180));
    return { angle, exact: reflectedColor(substance, cosine, light), schlick: schlickColor(f0, cosine) };
  });
  const parameters = [...shippedModels].flatMap(([model, { parameters }]) => {
    const found = substanceParameters(substance, parameters);
    return found ? [{ model, ...found }] : [];
  });
  const range = substance.range ?? null;
  return {
    name,
    title,
    kind,
    source,
    range,
    lines,
    f0,
    angles,
    schlick: worstSchlickError(substance, light),
    parameters,
  };
}

function page(description: ReturnType<typeof describe>, light: WhiteLight): string {
  const { name, title, kind, source, range, lines, f0, angles, schlick, parameters } = description;
  const number = (value: unknown) => (typeof value === 'number' ? String(Number(value.toFixed(4))) : value);
  const text = (values: object) =>
    Object.entries(values)
      .map(([key, value]) => `${key} ${Array.isArray(value) ? value.map(number).join(' ') : number(value)}`)
      .join(', ');
  return [
    name,
    '',
    `${title} (${kind})`,
    source,
    ...(range ? [`The formula was made for ${range[0]} to ${range[1]} nm.`] : []),
    '',
    'Line   nm         n        k',
    ...lines.map(
      ({ line, nm, n, k }) => `${line}      ${nm}  ${n.toFixed(4).padStart(7)}  ${k.toFixed(4).padStart(7)}`,
    ),
    '',
    `F0 under ${light}, linear Rec. 709: ${rgbText(f0).trim()}`,
    '',
    'Angle  exact                    Schlick',
    ...angles.map(
      ({ angle, exact, schlick: approximate }) =>
        `${String(angle).padStart(5)}  ${rgbText(exact)}  ${rgbText(approximate)}`,
    ),
    '',
    `Schlick's worst error: ${schlick.error.toFixed(4)} at ${schlick.angle} degrees`,
    '',
    'As parameters',
    ...parameters.map(({ model, values, outside }) => {
      const cut = Object.keys(outside).length > 0 ? ` (out of range: ${text(outside)})` : '';
      return `  ${model}: ${text(values)}${cut}`;
    }),
  ].join('\n');
}
