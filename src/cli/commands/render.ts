import { existsSync } from 'node:fs';
import { modelSources, shippedModels } from '../../../models/index.ts';
import { sceneNames } from '../../../scenes/index.ts';
import { presetNames, withPreset } from '../../scene/effect-presets.ts';
import { isMeasuredFile, measuredAsset } from '../../scene/measured.ts';
import type { Document } from '../../scene/schema.ts';
import { pathTracingDefaults } from '../../scene/stage-schema.ts';
import { CliError, type Command } from '../command.ts';
import { readInput } from '../files.ts';
import { modelArgument, modelFiles } from '../model-argument.ts';
import { modelFileKinds } from '../model-file-kinds.ts';
import { PREVIEW_SAMPLES, previewDocument } from '../preview.ts';
import { say } from '../render/messages.ts';
import {
  AOVS,
  completed,
  DEFAULTS,
  parseRenderOptions,
  type RenderOptions,
  renderOptions,
} from '../render/options.ts';
import { checkWritable } from '../render/save.ts';
import { sceneArgument } from '../scene-argument.ts';

const command: Command = {
  usage: 'render SCENE|MODEL|FILE -o FILE.exr|.png [options]',
  summary: 'A picture of a scene, or of a sphere of a model: path traced, or by the interactive renderer.',
  details: [
    '  SCENE      a scene that ships',
    '  MODEL      a model that ships; `irradia brdf list` names them',
    `  FILE       a document, ${modelFileKinds};`,
    `             ${modelFiles}`,
    '  -o         a .png is what the lab shows; an .exr has the linear radiance, before exposure and tone mapping,',
    '             and in its header what was rendered: `irradia merge` adds such files up',
    `  --size     WxH: width and height in pixels; otherwise ${DEFAULTS.size}`,
    '  --renderer pathtracer (the default) or realtime, which draws as the lab does while the camera moves',
    '  --device   auto: a GPU if there is one, else the CPU (the default); gpu; software: the CPU. The realtime',
    '             renderer has a software GPU for the CPU',
    `  --preset   of the realtime renderer's effects: ${presetNames.join(', ')}; otherwise the document's own`,
    '',
    'The path tracer ends by one of these; Ctrl+C ends it before, and what there is is written. Without one of them',
    "each pixel gets the document's pathTracing.samples, of which a new scene has " +
      `${pathTracingDefaults.samples} and the picture of a model ${PREVIEW_SAMPLES}.`,
    '  --spp N        samples of each pixel',
    '  --time S       seconds of rendering',
    "  --error E      until the standard deviation of the pixels' means is E times the picture's mean, such as 0.02,",
    '                 in every part of it: dark parts may have less, and parts that are good enough get no more',
    `                 samples. --spp N beside it is the most that a pixel gets; otherwise ${DEFAULTS.mostSamples}`,
    '  --samples A:B  samples A to B - 1 of each pixel: a part of a rendering, for `irradia merge`',
    '',
    "These, too, are otherwise the document's (pathTracing.maxDepth, .seed, .clamp):",
    '  --max-depth N  the most surfaces and scatterings of a path',
    '  --seed N       another one gives other noise; the same one the same picture',
    '  --clamp X      bounds the radiance of a sample of indirect light: less noise, and a darker picture; 0: does not',
    '',
    '  --denoise      takes the noise out; an .exr keeps it in the layer "noisy", which `irradia merge` reads',
    `  --aov LIST     layers of an .exr, some of ${AOVS.join(',')}: of what a pixel sees first; depth in metres;`,
    '                 variance is that of the mean',
    '',
    'An animation turns the camera about its target (documents have no animations yet). Frames that are there',
    'already are not rendered again.',
    '  --frames A:B   frames A to B - 1 into FILE.0001.png and so on',
    `  --fps N        frames per second; otherwise ${DEFAULTS.fps}`,
    `  --turntable D  degrees per second; otherwise ${DEFAULTS.turntable}`,
  ],
  options: renderOptions,
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options: words }) {
    const request = parseRenderOptions(words);
    checkWritable(request.output, `-o ${request.output}`);
    const document = await documentFor(word);
    const options = completed(request, document.pathTracing);
    // three.js is loaded only now that the call is known to be right.
    return options.renderer === 'pathtracer'
      ? (await import('../render/path-traced.ts')).pathTraced(document, options)
      : (await import('../render/realtime.ts')).realtime(withOptions(document, options), options);
  },
};

export default command;

const withOptions = (document: Document, { preset }: RenderOptions): Document =>
  preset === null ? document : { ...document, effects: withPreset(document.effects, preset) };

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
  if (existsSync(word)) {
    const { document, notes } = await sceneArgument(word);
    for (const note of notes) say(`note: ${note}`);
    return document;
  }
  const scenes = sceneNames.join(', ');
  const models = [...shippedModels.keys()].join(', ');
  throw new CliError(
    `there is no scene, model or file '${word}'; scenes that ship: ${scenes}; models: ${models}`,
  );
}
