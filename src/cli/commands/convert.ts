import { extname } from 'node:path';
import { serializeDocument } from '../../scene/document.ts';
import { CliError, type Command, UsageError } from '../command.ts';
import { checkOutput, writeOutput } from '../files.ts';
import { modelFileKinds } from '../model-file-kinds.ts';
import { say } from '../render/messages.ts';
import { sceneArgument } from '../scene-argument.ts';

const FORMATS = ['.json', '.glb'];

const command: Command = {
  usage: 'convert SCENE|FILE -o FILE.json|.glb',
  summary: 'A model or a scene of another format as a document, or any of them as a GLB.',
  details: [
    '  SCENE  a scene that ships',
    `  FILE   a document, ${modelFileKinds}`,
    '  -o     a .json is a document, with all that it needs inside; a .glb has objects, materials (KHR extensions),',
    '         punctual lights and the camera',
    '',
    'What could not be kept is told.',
  ],
  options: { output: { type: 'string', short: 'o' } },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options }) {
    const output = options.output as string | undefined;
    if (!output) throw new UsageError('convert: expected -o FILE.json or -o FILE.glb');
    const format = extname(output).toLowerCase();
    if (!FORMATS.includes(format)) throw new UsageError(`-o ${output}: expected a .json or a .glb`);
    checkOutput(output, `-o ${output}`);
    const { document, notes } = await sceneArgument(word);
    tell(notes);
    if (format === '.json') {
      writeOutput(output, `-o ${output}`, new TextEncoder().encode(serializeDocument(document)));
      return 0;
    }
    const [{ exportGltf }, { AssetLoader }, { nodeAssets }] = await Promise.all([
      import('../../io/gltf-export.ts'),
      import('../../scene/assets.ts'),
      import('../node-assets.ts'),
    ]);
    if (Object.keys(document.objects).length === 0) throw new CliError(`${word}: there are no objects in it`);
    const exported = await exportGltf(document, new AssetLoader(nodeAssets));
    tell(exported.notes);
    writeOutput(output, `-o ${output}`, exported.bytes);
    return 0;
  },
};

export default command;

function tell(notes: readonly string[]): void {
  for (const note of notes) say(`note: ${note}`);
}
