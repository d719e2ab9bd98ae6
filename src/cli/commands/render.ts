import { existsSync } from 'node:fs';
import { extname } from 'node:path';
import { modelSources, shippedModels } from '../../../models/index.ts';
import { sceneNames } from '../../../scenes/index.ts';
import { isMeasuredFile, measuredAsset } from '../../scene/measured.ts';
import type { Document } from '../../scene/schema.ts';
import { CliError, type Command, UsageError } from '../command.ts';
import { checkOutput, readInput, writeOutput } from '../files.ts';
import type { DeviceChoice } from '../gpu.ts';
import { modelArgument, modelFiles } from '../model-argument.ts';
import { packageVersion } from '../package-root.ts';
import { previewDocument } from '../preview.ts';
import { sceneArgument } from '../scene-argument.ts';

const DEFAULT_SIZE = '1280x720';
const DEVICES: readonly DeviceChoice[] = ['auto', 'gpu', 'software'];

const command: Command = {
  usage: 'render SCENE|MODEL|FILE -o FILE.png|.exr [--size WxH] [--device auto|gpu|software]',
  summary: 'A picture of a scene, or of a sphere of a model, by the interactive renderer.',
  details: [
    '  SCENE      a scene that ships',
    '  MODEL      a model that ships; `irradia brdf list` names them',
    `  FILE       a document, ${modelFiles}`,
    '  -o         a .png is what the lab shows; an .exr has the linear radiance, before exposure and tone mapping',
    `  --size     width and height in pixels; otherwise ${DEFAULT_SIZE}`,
    '  --device   auto: a GPU if there is one, else the software GPU (the default)',
  ],
  options: {
    output: { type: 'string', short: 'o' },
    size: { type: 'string', default: DEFAULT_SIZE },
    device: { type: 'string', default: 'auto' },
  },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options }) {
    const { output, size, device } = options as Record<string, string>;
    if (!output) throw new UsageError('render: expected -o FILE.png or -o FILE.exr');
    const format = extname(output).slice(1).toLowerCase();
    if (format !== 'png' && format !== 'exr')
      throw new UsageError(`-o ${output}: expected a .png or an .exr`);
    if (!DEVICES.includes(device as DeviceChoice)) {
      throw new UsageError(`--device ${device}: expected ${DEVICES.join(', ')}`);
    }
    checkOutput(output, `-o ${output}`);
    const { width, height } = parseSize(size as string);
    const document = await documentFor(word);

    // three.js is loaded only now that the call is known to be right.
    const { renderFrame } = await import('../frame.ts');
    const software = `Irradia ${packageVersion()}`;
    const file = await renderFrame(document, {
      width,
      height,
      format,
      device: device as DeviceChoice,
      software,
    });
    writeOutput(output, `-o ${output}`, file);
    return 0;
  },
};

export default command;

function parseSize(text: string): { width: number; height: number } {
  const [, width, height] = /^(\d{1,5})x(\d{1,5})$/i.exec(text)?.map(Number) ?? [];
  if (!width || !height)
    throw new UsageError(`--size ${text}: expected WIDTHxHEIGHT, such as ${DEFAULT_SIZE}`);
  return { width, height };
}

/** A scene comes before a model of the same name; a file's ending tells which of the two it is. */
async function documentFor(word: string): Promise<Document> {
  if (sceneNames.includes(word)) return (await sceneArgument(word)).document;
  if (shippedModels.has(word))
    return previewDocument(word, { source: modelSources.get(`${word}.brdf`) as string }, word);
  if (word.endsWith('.brdf')) {
    const { name } = modelArgument(word);
    return previewDocument(name, { source: readInput(word).toString('utf8') }, word);
  }
  if (isMeasuredFile(word) && existsSync(word)) {
    const measurements = measuredAsset(readInput(word), word);
    return previewDocument(measurements.name, { measurements }, word);
  }
  if (existsSync(word)) return (await sceneArgument(word)).document;
  const scenes = sceneNames.join(', ');
  const models = [...shippedModels.keys()].join(', ');
  throw new CliError(
    `there is no scene, model or file '${word}'; scenes that ship: ${scenes}; models: ${models}`,
  );
}
