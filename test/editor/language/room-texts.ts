/** The English texts that come from the rooms below the editor, which it translates where it shows them. */
import { shippedModels } from '../../../models/index.ts';
import { loadScene } from '../../../scenes/index.ts';
import { materialLibrary } from '../../../src/analysis/library/library.ts';
import { channels } from '../../../src/analysis/plots/channel.ts';
import { substances } from '../../../src/analysis/substances/table.ts';
import { moving } from '../../../src/editor/panels/bench/settings.ts';
import { wordsOf } from '../../../src/editor/panels/inspector/field.ts';
import { shippedScenes } from '../../../src/editor/scenes.ts';
import { presetNames, presets } from '../../../src/scene/effect-presets.ts';
import { fieldInfo } from '../../../src/scene/fields.ts';
import { geometryNames } from '../../../src/scene/geometry-schema.ts';
import { lightDefaults } from '../../../src/scene/light-schema.ts';
import { patternNames } from '../../../src/scene/pattern/asset.ts';
import { shapeOf } from '../../../src/scene/pattern/pattern.ts';
import { environmentPresets } from '../../../src/scene/presets.ts';
import { arrangements } from '../../../src/scene/studio-arrangements.ts';
import { argumentsOf, calleeOf, type SyntaxNode, sourceFiles, textsOf, walk } from './source-texts.ts';

export interface RoomText {
  readonly text: string;
  /** Where it comes from, for whoever has to translate it. */
  readonly from: string;
}

/** Everything that the editor shows of the rooms below it. */
export async function roomTexts(): Promise<RoomText[]> {
  const found = [
    ...schemaTexts(),
    ...modelTexts(),
    ...(await sceneTexts()),
    ...[...substances.values()].map(({ title }) => ({ text: title, from: 'substances' })),
    ...[...materialLibrary.values()].flatMap(({ title, source }) =>
      [title, source].map((text) => ({ text, from: 'library' })),
    ),
    ...[...channels, ...moving].map((name) => ({ text: wordsOf(name), from: 'bench' })),
    ...presetNames.flatMap((name) => [
      { text: wordsOf(name), from: 'presets' },
      { text: presets[name].description, from: 'presets' },
    ]),
    ...environmentPresets.map((name) => ({ text: wordsOf(name), from: 'environments' })),
    ...Object.values(arrangements).flatMap(({ title, description }) =>
      [title, description].map((text) => ({ text, from: 'studio' })),
    ),
    ...patternNames.flatMap((name) => [
      { text: wordsOf(name), from: 'patterns' },
      ...shapeTexts(shapeOf(name), 'patterns'),
    ]),
    ...Object.values(geometryNames).map((text) => ({ text, from: 'geometries' })),
    ...Object.values(lightDefaults).map(({ name }) => ({ text: name, from: 'lights' })),
    ...RULES.flatMap(textsByRule),
  ];
  return [
    ...new Map(found.filter(({ text }) => /\p{L}{2,}/u.test(text)).map((one) => [one.text, one])).values(),
  ];
}

/** Fields and choices of the document, labelled as the inspector does. */
function schemaTexts(): RoomText[] {
  const modules = import.meta.glob<Record<string, unknown>>('../../../src/scene/*schema.ts', { eager: true });
  const found: RoomText[] = [];
  for (const [path, module] of Object.entries(modules)) {
    const from = path.replace(/^.*\//, '');
    for (const [name, value] of Object.entries(module)) {
      if (!/Shapes?$/.test(name) || typeof value !== 'object' || value === null) continue;
      const many = name.endsWith('Shapes');
      // The names of the shapes are what a choice offers, and titles of sections.
      if (many) found.push(...Object.keys(value).map((key) => ({ text: wordsOf(key), from })));
      for (const shape of many ? Object.values(value) : [value]) found.push(...shapeTexts(shape, from));
    }
  }
  return found;
}

function shapeTexts(shape: Readonly<Record<string, unknown>>, from: string): RoomText[] {
  return Object.entries(shape).flatMap(([name, schema]) => {
    const info = fieldInfo(schema as Parameters<typeof fieldInfo>[0]);
    if (!info) return [];
    const texts = [info.description, ...(info.choices ?? []).map(wordsOf), wordsOf(name)];
    return texts.map((text) => ({ text, from }));
  });
}

function modelTexts(): RoomText[] {
  return [...shippedModels.values()].flatMap(({ name, file, terms }) =>
    [
      file.title,
      ...terms.filter((term) => term !== 'BRDF'),
      ...file.parameters.flatMap((parameter) => [wordsOf(parameter.name), parameter.description]),
    ].map((text) => ({ text, from: `models/${name}.brdf` })),
  );
}

async function sceneTexts(): Promise<RoomText[]> {
  const described = await Promise.all(
    shippedScenes.map(async ({ name }) => ({
      text: (await loadScene(name)).description,
      from: `scenes/${name}`,
    })),
  );
  return [...shippedScenes.map(({ name, title }) => ({ text: title, from: `scenes/${name}` })), ...described];
}

/** Which arguments of which calls in a folder are texts that a person may read. */
interface Rule {
  readonly folder: string;
  /** The name of what is called, and which of its arguments. */
  readonly calls?: Readonly<Record<string, readonly number[]>>;
  /** Of object literals. */
  readonly properties?: readonly string[];
  readonly variables?: readonly string[];
  /** They are names, which the page writes as labels. */
  readonly areNames?: boolean;
}

const RULES: readonly Rule[] = [
  {
    folder: 'src/scene',
    calls: { '.edit': [0], report: [0, 1], whole: [1], setFlag: [4], fault: [0], ByteError: [2] },
    properties: ['message'],
    variables: ['label'],
  },
  { folder: 'src/brdf', calls: { BrdfError: [1, 2], BrdfParameterError: [2] } },
  {
    folder: 'src/glsl',
    calls: { BrdfError: [1, 2], wrong: [0], '.name': [0], '.fail': [0] },
    variables: ['bounded'],
  },
  {
    folder: 'src/io',
    calls: {
      BrdfError: [1, 2],
      ByteError: [2],
      GltfError: [1],
      ModelFileError: [2],
      fail: [0, 1],
      '.fail': [0, 1],
      '.error': [0, 1],
      fault: [0],
      '.fault': [2],
      '.add': [0],
    },
    properties: ['message'],
  },
  {
    folder: 'src/analysis/verdict',
    calls: { '.check': [2, 3], '.notApplicable': [0] },
    variables: ['sentence', 'what', 'FIGURES'],
  },
  { folder: 'src/pathtracer', calls: { PathTracerError: [0] } },
  {
    folder: 'src/editor',
    calls: { fold: [0], progress: [0], ModelFileError: [2], listener: [0] },
    properties: ['failure'],
  },
  { folder: 'src/realtime', calls: { '.mark': [0] }, areNames: true },
  { folder: 'src/editor/viewport', calls: { '.mark': [0] }, areNames: true },
];

function textsByRule({ folder, calls = {}, properties = [], variables = [], areNames }: Rule): RoomText[] {
  const shown = areNames ? wordsOf : (text: string) => text;
  return sourceFiles(folder).flatMap((file) => {
    const found: RoomText[] = [];
    for (const node of walk(file.root)) {
      const read = (part: SyntaxNode | undefined) => {
        if (part) found.push(...textsOf(part).map((text) => ({ text: shown(text), from: file.path })));
      };
      if (node.type === 'CallExpression' || node.type === 'NewExpression') {
        for (const index of calls[calleeOf(node)] ?? []) read(argumentsOf(node)[index]);
      } else if (node.type === 'Property' && properties.includes(nameOf(node.key))) {
        read(node.value as SyntaxNode);
      } else if (node.type === 'VariableDeclarator' && variables.includes(nameOf(node.id))) {
        read(node.init as SyntaxNode | undefined);
      }
    }
    return found;
  });
}

const nameOf = (node: unknown): string => {
  const { name, value } = node as { name?: string; value?: string };
  return name ?? String(value);
};

/** Texts that are put together from parts, or come from a library: no rule finds them written in one place. */
export const COMPOSED: readonly string[] = [
  'Show {name}',
  'and',
  '1 light',
  '{count} lights',
  '1 object',
  '{count} objects',
  '1 material',
  '{count} materials',
  '{count} groups',
  'expected {expected}',
  '{message} (and {count} more)',
  'line {line}',
  'the environment "{name}" did not come; without a network only what was loaded before is there',
  'byte {byte}',
  'Invalid input',
  'Invalid input: expected {type}, received {received}',
  'Invalid input: expected {value}',
  'Invalid option: expected one of {list}',
  'Too small: expected {type} to be >={min}',
  'Too small: expected {type} to be >{min}',
  'Too big: expected {type} to be <={max}',
  'Too big: expected {type} to have <={max} characters',
  'Too small: expected {type} to have >={min} characters',
  'Invalid string: must match pattern {pattern}',
  'with the light at {light} and the viewer at {viewer} from the normal',
  'with the light at {light} from the normal',
  'with the viewer at {viewer} from the normal',
  'largest albedo',
  'change when l and v swap',
  'below the surface',
  'not of length 1',
  'no light comes from there, and the sample should be given up as vec3(0)',
  'a direction is a unit vector',
  'sampleL gives directions that are {what} {where}: {note}.',
  '1 CPU thread',
  '{count} CPU threads',
  'this browser has no WebGPU',
  'WebGPU found no GPU',
  'WebGPU is only emulated here',
  'WebGPU did not start: {message}',
  'The path tracer stopped: {message}',
  'its worker could not be loaded',
  'the denoiser could not be loaded',
  'the GPU was lost: {message}',
  'its thread ended',
  'This browser makes no JPEG of {width} x {height} pixels; PNG works.',
  'it could not be fetched: no connection, or the server does not let other pages have it (CORS)',
  'the server answered {status}',
  'more than {bytes} bytes',
  'with what lies beside it, more than {bytes} bytes',
  'the image cannot be read: {message}',
  'neither a Radiance HDR nor an OpenEXR image',
  'the map of its specular colour',
  'the map of its shininess',
  'its reflection map',
  'its displacement',
  'the tint of its reflection',
  'scattering inside',
];
