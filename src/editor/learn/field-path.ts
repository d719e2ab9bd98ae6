/**
 * A field of a scene by the path that a lesson's text names it with: `lights.key.intensity`, `camera.position.y`,
 * `materials.ball.roughness` for a parameter of the material's model.
 */
import type { Parameter } from '../../brdf/model.ts';
import { effectShapes } from '../../scene/effects-schema.ts';
import { environmentShape } from '../../scene/environment-schema.ts';
import type { Path } from '../../scene/error.ts';
import { type FieldInfo, fieldInfo } from '../../scene/fields.ts';
import { geometryShapes } from '../../scene/geometry-schema.ts';
import { lightShapes } from '../../scene/light-schema.ts';
import { materialShape } from '../../scene/material-schema.ts';
import { findModel } from '../../scene/models.ts';
import { type Document, objectShape } from '../../scene/schema.ts';
import { cameraShape, fogShape, pathTracingShape, viewShape } from '../../scene/stage-schema.ts';
import { shown } from './error.ts';

export interface FieldPlace {
  readonly path: Path;
  /** How it is edited; null for what has no control of its own. */
  readonly info: FieldInfo | null;
  /** What it is where the document does not say, and what a double click brings back. */
  readonly otherwise: unknown;
}

/** A path that leads nowhere. */
export class PathError extends Error {
  readonly expected: string;
  constructor(what: string, expected: string) {
    super(what);
    this.expected = expected;
  }
}

const MOST_PARTS = 8;
const MOST_NAMES = 14;
const COMPONENTS: Readonly<Record<string, number>> = { x: 0, y: 1, z: 2, r: 0, g: 1, b: 2, 0: 0, 1: 1, 2: 2 };

/** Throws a PathError if there is no such field. */
export function fieldAt(document: Document, text: string): FieldPlace {
  const parts = text.split('.');
  if (parts.length > MOST_PARTS || parts.some((part) => !/^[A-Za-z0-9_-]{1,64}$/.test(part)))
    throw new PathError(
      `“${shown(text)}” is no path of a field`,
      'names with dots between, such as lights.key.color',
    );
  return parameterAt(document, parts) ?? ordinaryAt(document, parts);
}

function parameterAt(document: Document, parts: readonly string[]): FieldPlace | null {
  const [collection, id = '', name = ''] = parts;
  const material =
    collection === 'materials' && Object.hasOwn(document.materials, id) && document.materials[id];
  if (!material || (name !== 'parameters' && Object.hasOwn(materialShape, name))) return null;
  const rest = parts.slice(name === 'parameters' ? 3 : 2);
  const parameters = findModel(document, material.model)?.parameters ?? [];
  const parameter = parameters.find((one) => one.name === rest[0]);
  if (!parameter || rest.length > 1)
    throw new PathError(
      `${material.model} has no parameter “${shown(rest.join('.'))}”`,
      oneOf(parameters.map((one) => one.name)),
    );
  return {
    path: ['materials', id, 'parameters', parameter.name],
    info: infoOf(parameter),
    otherwise: parameter.default,
  };
}

function infoOf(parameter: Parameter): FieldInfo {
  const { description } = parameter;
  if (parameter.type === 'float')
    return { kind: 'number', description, slider: [parameter.min, parameter.max] };
  return { kind: parameter.type === 'bool' ? 'boolean' : 'color', description };
}

function ordinaryAt(document: Document, parts: readonly string[]): FieldPlace {
  const path: (string | number)[] = [];
  let holder: unknown = document;
  let info: FieldInfo | null = null;
  for (const part of parts) {
    const key = Array.isArray(holder) ? COMPONENTS[part] : part;
    if (typeof holder !== 'object' || holder === null || key === undefined || !Object.hasOwn(holder, key))
      throw new PathError(
        `there is no “${part}” in ${path.length === 0 ? 'the scene' : path.join('.')}`,
        Array.isArray(holder) ? 'x, y or z' : oneOf(Object.keys(holder ?? {})),
      );
    path.push(key);
    info = Array.isArray(holder) ? componentOf(info) : infoAt(document, path);
    holder = (holder as Record<string | number, unknown>)[key];
  }
  return { path, info, otherwise: undefined };
}

const componentOf = (info: FieldInfo | null): FieldInfo | null => info && { ...info, kind: 'number' };

function oneOf(names: readonly string[]): string {
  const more = names.length > MOST_NAMES ? ', …' : '';
  return names.length === 0
    ? 'an end of the path here'
    : `one of ${names.slice(0, MOST_NAMES).join(', ')}${more}`;
}

type Shape = Readonly<Record<string, unknown>>;

const SINGLES: Readonly<Record<string, Shape>> = {
  camera: cameraShape,
  fog: fogShape,
  environment: environmentShape,
  view: viewShape,
  pathTracing: pathTracingShape,
};

function infoAt(document: Document, path: Path): FieldInfo | null {
  const [room = '', id = '', name = '', inner = ''] = path.map(String);
  if (path.length === 2) return infoIn(SINGLES[room], id);
  if (path.length === 3) {
    if (room === 'effects') return infoIn(effectShapes[id as keyof typeof effectShapes], name);
    if (room === 'objects') return infoIn(objectShape, name);
    if (room === 'materials') return infoIn(materialShape, name);
    const light = room === 'lights' ? document.lights[id] : undefined;
    return light ? infoIn(lightShapes[light.type], name) : null;
  }
  const object =
    path.length === 4 && room === 'objects' && name === 'geometry' ? document.objects[id] : undefined;
  return object ? infoIn(geometryShapes[object.geometry.type], inner) : null;
}

function infoIn(shape: Shape | undefined, name: string): FieldInfo | null {
  const schema = shape?.[name];
  return schema === undefined ? null : (fieldInfo(schema as Parameters<typeof fieldInfo>[0]) ?? null);
}
