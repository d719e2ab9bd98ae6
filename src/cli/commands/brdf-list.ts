import { shippedModels } from '../../../models/index.ts';
import type { Command } from '../command.ts';

const command: Command = {
  usage: 'brdf list [--json]',
  summary: 'The models that ship.',
  details: ['  --json   as JSON: [{"name", "title"}]'],
  options: { json: { type: 'boolean' } },
  arguments: { least: 0, most: 0 },
  async run({ options }) {
    const models = [...shippedModels.values()].map(({ name, file }) => ({ name, title: file.title }));
    if (options.json) {
      console.log(JSON.stringify(models, null, 2));
    } else {
      const width = Math.max(...models.map(({ name }) => name.length));
      for (const { name, title } of models) console.log(`${name.padEnd(width)}  ${title}`);
    }
    return 0;
  },
};

export default command;
