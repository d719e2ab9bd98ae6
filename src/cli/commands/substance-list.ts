import { reflectedColor } from '../../analysis/substances/reflectance.ts';
import { substances } from '../../analysis/substances/table.ts';
import type { Command } from '../command.ts';
import { rgbText } from '../rgb-text.ts';

const command: Command = {
  usage: 'substance list [--json]',
  summary: 'Metals and dielectrics with their measured indices of refraction.',
  details: [
    'For each its colour at normal incidence, linear Rec. 709 under D65.',
    '',
    '  --json   as JSON: [{"name", "title", "kind", "f0", "source"}]',
  ],
  options: { json: { type: 'boolean' } },
  arguments: { least: 0, most: 0 },
  async run({ options }) {
    const list = [...substances.values()].map((substance) => {
      const { name, title, kind, source } = substance;
      return { name, title, kind, f0: reflectedColor(substance, 1), source };
    });
    if (options.json) {
      console.log(JSON.stringify(list, null, 2));
    } else {
      const width = Math.max(...list.map(({ name }) => name.length));
      for (const { name, title, f0 } of list) console.log(`${name.padEnd(width)}  ${rgbText(f0)}  ${title}`);
    }
    return 0;
  },
};

export default command;
