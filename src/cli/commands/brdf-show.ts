import type { Parameter } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';
import type { Command } from '../command.ts';
import { modelArgument, modelFiles } from '../model-argument.ts';

const command: Command = {
  usage: 'brdf show MODEL|FILE [--json]',
  summary: 'What a model is: parameters with ranges, terms, references.',
  details: [
    '  MODEL    a model that ships; `irradia brdf list` names them',
    `  FILE     ${modelFiles}`,
    '  --json   as JSON: {"name", "title", "documentation", "references", "parameters", "terms", "sampling"}',
  ],
  options: { json: { type: 'boolean' } },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options }) {
    const model = modelArgument(word);
    console.log(options.json ? JSON.stringify(describe(model), null, 2) : manualPage(model));
    return 0;
  },
};

export default command;

function describe({ name, file, parameters, terms, hasSampling }: Model) {
  const { title, documentation } = file;
  const references = referencesOf(documentation);
  return { name, title, documentation, references, parameters, terms, sampling: hasSampling };
}

/** The paragraph of a header that is headed 'References'. */
function referencesOf(documentation: string): string {
  const paragraphs = documentation.split(/\n[ \t]*\n/);
  const found = paragraphs.find((paragraph) => /^\s*references:?\s*\n/i.test(paragraph)) ?? '';
  return found.replace(/^\s*references:?\s*\n/i, '').replace(/^[ \t]+/gm, '');
}

function manualPage({ name, file, parameters, terms, hasSampling }: Model): string {
  const heads = parameters.map(parameterHead);
  const width = Math.max(0, ...heads.map((head) => head.length));
  const table = parameters.map(({ description }, i) =>
    `  ${heads[i]?.padEnd(width)}  ${description}`.trimEnd(),
  );
  return [
    name,
    '',
    file.documentation,
    '',
    ...(table.length ? ['Parameters', ...table] : ['No parameters']),
    '',
    `Terms: ${terms.join(', ')}`,
    `Sampling: ${hasSampling ? 'its own' : 'generic'}`,
  ].join('\n');
}

function parameterHead(parameter: Parameter): string {
  const { type, name } = parameter;
  switch (type) {
    case 'float':
      return `${type.padEnd(5)} ${name} = ${parameter.default} (${parameter.min} to ${parameter.max})`;
    case 'color':
      return `${type.padEnd(5)} ${name} = [${parameter.default.join(', ')}]`;
    case 'bool':
      return `${type.padEnd(5)} ${name} = ${parameter.default}`;
  }
}
