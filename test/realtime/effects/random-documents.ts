/** Documents of chance: every effect and every number within its bounds, in small scenes. The same for the same seeds. */
import { shippedModels } from '../../../models/index.ts';
import { createRandom } from '../../../src/analysis/random.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { effectNames, effectShapes } from '../../../src/scene/effects-schema.ts';
import {
  environmentSourceShapes,
  softBoxShape,
  sunPositionShapes,
} from '../../../src/scene/environment-schema.ts';
import { fieldInfo } from '../../../src/scene/fields.ts';
import { groundShape } from '../../../src/scene/ground-schema.ts';
import { lightShapes, lightTypes } from '../../../src/scene/light-schema.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { cameraShape, fogShape } from '../../../src/scene/stage-schema.ts';

type Shape = Readonly<Record<string, unknown>>;
type Random = () => number;

/** Bounds of what would only take longer. */
const MOST: Readonly<Record<string, number>> = {
  resolution: 256,
  cascades: 3,
  samples: 32,
  rays: 6,
  steps: 24,
  directions: 6,
};
/** Numbers that decide what is compiled. */
const STRUCTURAL = new Set(['resolution', 'cascades']);

const GEOMETRIES = ['plane', 'box', 'sphere', 'cone', 'torus'] as const;
const MODELS = ['lambert', 'principled', 'cook-torrance'];

const pick = <T>(from: readonly T[], random: Random): T => from[Math.floor(random() * from.length)] as T;
const between = ([least, most]: readonly [number, number], random: Random) =>
  least + (most - least) * random();

/** Mostly what a slider gives; sometimes any number within the bounds, or one of the bounds. */
function number(
  {
    min = 0,
    max = 1,
    slider = [min, max],
  }: { min?: number; max?: number; slider?: readonly [number, number] },
  random: Random,
): number {
  const kind = random();
  if (kind < 0.8) return between(slider, random);
  return kind < 0.9 ? between([min, max], random) : pick([min, max], random);
}

/** @param structure for what has to be compiled anew @param numbers for what has not */
function fields(shape: Shape, structure: Random, numbers: Random): Record<string, unknown> {
  const values: Record<string, unknown> = {};
  for (const [name, schema] of Object.entries(shape)) {
    const info = fieldInfo(schema as Parameters<typeof fieldInfo>[0]);
    // No pixel depends on it.
    if (!info || name === 'locked') continue;
    const random = STRUCTURAL.has(name) ? structure : numbers;
    const most = MOST[name];
    const bounded =
      most === undefined ? info : { ...info, max: most, slider: [info.min ?? 0, most] as const };
    if (info.kind === 'boolean') values[name] = structure() < 0.5;
    else if (info.kind === 'choice') values[name] = pick(info.choices ?? [], structure);
    else if (info.kind === 'number') values[name] = info.nullable ? null : number(bounded, random);
    else if (info.kind === 'integer') values[name] = Math.round(number(bounded, random));
    else if (info.kind === 'color') values[name] = [numbers(), numbers(), numbers()];
    else if (info.kind === 'vector3') values[name] = [0, 0, 0].map(() => between([-3, 3], numbers));
  }
  return values;
}

function material(structure: Random, numbers: Random): object {
  const model = pick(MODELS, structure);
  const values = (shippedModels.get(model)?.parameters ?? []).map((parameter) => {
    const value =
      parameter.type === 'float'
        ? pick([parameter.min, parameter.max, between([parameter.min, parameter.max], numbers)], numbers)
        : parameter.type === 'bool'
          ? structure() < 0.5
          : [numbers(), numbers(), numbers()];
    return [parameter.name, value];
  });
  return {
    name: model,
    model,
    parameters: Object.fromEntries(values),
    emissive: structure() < 0.2 ? [numbers(), numbers(), numbers()] : [0, 0, 0],
    emissiveIntensity: number({ min: 0, max: 1e9, slider: [0, 10] }, numbers),
    doubleSided: structure() < 0.5,
  };
}

/** @param kind 0..1, which there is */
function surroundings(kind: number, numbers: Random): object {
  const source = (type: 'sky' | 'studio', more: object) => ({
    ...fields(environmentSourceShapes[type], numbers, numbers),
    type,
    ...more,
  });
  if (kind < 0.4)
    return { environment: { source: { type: 'constant', color: [numbers(), numbers(), numbers()] } } };
  if (kind < 0.55) {
    const sun = { ...fields(sunPositionShapes.direction, numbers, numbers), type: 'direction' };
    return {
      environment: { source: source('sky', { sun }), rotation: between([-180, 180], numbers) },
      background: { type: 'environment', blur: 0 },
    };
  }
  if (kind < 0.7) {
    const boxes = [0, 1].map(() => ({ ...fields(softBoxShape, numbers, numbers) }));
    return {
      environment: { source: source('studio', { boxes }) },
      background: { type: 'transparent' },
    };
  }
  return {};
}

/** @param structureSeed what there is @param numbersSeed all of its numbers: another of them compiles nothing */
export function randomDocument(structureSeed: number, numbersSeed: number): Document {
  const structure = createRandom(structureSeed);
  const numbers = createRandom(numbersSeed);
  const some = <T>(most: number, make: (i: number) => T) =>
    Object.fromEntries(
      Array.from({ length: 1 + Math.floor(structure() * most) }, (_, i) => [`e${i}`, make(i)]),
    );
  const materials = some(2, () => material(structure, numbers));
  const object = () => {
    const type = pick(GEOMETRIES, structure);
    const scale = pick([0.01, 1, 1, 1, 30], numbers);
    return {
      name: type,
      material: pick(Object.keys(materials), structure),
      position: [0, 0, 0].map(() => between([-1.5, 1.5], numbers)),
      rotation: [0, 0, 0].map(() => between([-180, 180], numbers)),
      scale: [scale, scale, pick([scale, 0.001, -scale], numbers)],
      geometry: { type },
    };
  };
  const light = () => {
    const type = pick(lightTypes, structure);
    return { ...fields(lightShapes[type], structure, numbers), type, name: type, visible: true };
  };
  const camera = fields(cameraShape, structure, numbers);
  const parts = {
    format: 'irradia',
    version: 1,
    name: `random ${structureSeed} ${numbersSeed}`,
    materials,
    objects: some(4, object),
    lights: some(3, light),
    camera: { ...camera, near: 0.05, far: 100 },
    fog: structure() < 0.3 ? fields(fogShape, structure, numbers) : {},
    ...surroundings(structure(), numbers),
    effects: Object.fromEntries(
      effectNames.map((name) => [name, fields(effectShapes[name], structure, numbers)]),
    ),
    ground: fields(groundShape, structure, numbers),
  };
  return parseDocument(parts, parts.name);
}
