/**
 * The rules of a complete document: its schema, and what a schema cannot say, that what is
 * named exists. What is the same object as in an already valid document is not looked at
 * again, so that an edit costs what it touched.
 */
import { z } from 'zod';
import type { Parameter } from '../brdf/model.ts';
import { type DocumentIssue, type Path, pathText, schemaIssues, shortened } from './error.ts';
import { id } from './fields.ts';
import { maxQuadsInAll, quadCount } from './geometry-schema.ts';
import { materialMaps, modelName } from './material-schema.ts';
import { findModel, modelFault, modelNames, modelOrigin } from './models.ts';
import {
  type Asset,
  type Collection,
  collectionLimits,
  collections,
  type Document,
  documentShape,
  entitySchemas,
  type Group,
  type Material,
  objectShape,
  singles,
} from './schema.ts';

/** All that is wrong with `document`, given that `valid`, if there is one, is not wrong at all. */
export function documentIssues(document: Document, valid?: Document): DocumentIssue[] {
  const shape = shapeIssues(document, valid);
  // What has the wrong shape, or a model that does not compile, cannot be asked what it refers to.
  if (shape.length > 0) return shape;
  const models = modelIssues(document, valid);
  return models.length > 0 ? models : referenceIssues(document, valid);
}

/** The ids of each collection, and their number. */
const idSchemas = Object.fromEntries(
  collections.map((name) => [
    name,
    z
      .record(name === 'models' ? modelName : id, z.null())
      .refine((record) => Object.keys(record).length <= collectionLimits[name], {
        message: `Too many ${name}: at most ${collectionLimits[name]}`,
      }),
  ]),
) as unknown as Readonly<Record<Collection, z.ZodType>>;

/** Assets that this program made: to look at each of megabytes of base64 would hold up the page. */
const trusted = new WeakSet<object>();

/** Says that an asset is as the schema wants it, because it was made that way here. */
export function trustAsset(asset: Asset): void {
  trusted.add(asset);
}

/** Entities are complete in memory: a missing field has no default here. */
function shapeIssues(document: Document, valid: Document | undefined): DocumentIssue[] {
  const issues: DocumentIssue[] = [];
  const check = (schema: z.ZodType, value: unknown, path: Path): void => {
    const result = schema.safeParse(value);
    if (!result.success) issues.push(...schemaIssues(result.error, path));
  };
  for (const key of Object.keys(document))
    if (!Object.hasOwn(documentShape, key))
      issues.push({ path: pathText([key]), message: 'there is no such field' });
  for (const name of singles)
    if (document[name] !== valid?.[name]) check(documentShape[name], document[name], [name]);
  for (const name of collections) {
    const entities: unknown = document[name];
    const before = valid?.[name];
    if (entities === before) continue;
    if (before === undefined || typeof entities !== 'object' || entities === null) {
      check(documentShape[name], entities, [name]);
      continue;
    }
    const isKnown = name === 'objects' ? knownObjects(before as Document['objects']) : () => false;
    for (const [id, entity] of Object.entries(entities)) {
      if (entity === before[id] || trusted.has(entity) || isKnown(id, entity)) continue;
      check(entitySchemas[name], entity, [name, id]);
    }
    // The entities themselves have just been seen.
    const ids = Object.keys(entities);
    if (ids.some((id) => !Object.hasOwn(before, id)))
      check(idSchemas[name], Object.fromEntries(ids.map((id) => [id, null])), [name]);
  }
  return issues;
}

const objectFields = Object.entries(objectShape);

/**
 * Of thousands of objects that an edit moves or copies, only what is not as in a valid one is looked at: a field that is the
 * object's own as before, or whose value is the very one of another object's, as a copy has it.
 *
 * @returns whether an object, which may be anything, is valid; false leaves it open
 */
function knownObjects(valid: Document['objects']): (id: string, object: unknown) => boolean {
  let others: ReadonlyMap<string, ReadonlySet<unknown>> | undefined;
  const valuesOf = (name: string): ReadonlySet<unknown> => {
    others ??= new Map(objectFields.map(([field]) => [field, new Set(fieldsOf(valid, field))]));
    return others.get(name) as ReadonlySet<unknown>;
  };
  return (id, object) => {
    if (typeof object !== 'object' || object === null) return false;
    const now = object as Readonly<Record<string, unknown>>;
    const before = Object.hasOwn(valid, id) ? (valid[id] as Readonly<Record<string, unknown>>) : undefined;
    return (
      Object.keys(now).length === objectFields.length &&
      objectFields.every(
        ([name, schema]) =>
          Object.hasOwn(now, name) &&
          ((before !== undefined && before[name] === now[name]) ||
            (before === undefined && valuesOf(name).has(now[name])) ||
            schema.safeParse(now[name]).success),
      )
    );
  };
}

function* fieldsOf(objects: Readonly<Record<string, object>>, name: string): Generator<unknown> {
  for (const object of Object.values(objects)) yield (object as Readonly<Record<string, unknown>>)[name];
}

/** Whether something that others may name has gone or is new under its old name. */
function targetsChanged(document: Document, valid: Document | undefined, names: Collection[]) {
  return names.some((name) => {
    const before = valid?.[name];
    const now = document[name];
    if (before === undefined) return true;
    if (before === now) return false;
    return Object.keys(before).some(
      (id) => !Object.hasOwn(now, id) || (name === 'models' && now[id] !== before[id]),
    );
  });
}

function changed<T>(
  now: Readonly<Record<string, T>>,
  before: Readonly<Record<string, T>> | undefined,
): [string, T][] {
  if (now === before) return [];
  return Object.entries(now).filter(([id, entity]) => entity !== before?.[id]);
}

function referenceIssues(document: Document, valid: Document | undefined): DocumentIssue[] {
  const issues: DocumentIssue[] = [];
  const need = (collection: 'assets' | 'materials' | 'groups', id: string, path: Path): void => {
    if (!Object.hasOwn(document[collection], id)) {
      const kind = collection.slice(0, -1);
      issues.push({ path: pathText(path), message: `there is no ${kind} "${shortened(id)}"` });
    }
  };
  const all = targetsChanged(document, valid, ['materials', 'assets', 'models', 'groups']);
  const before = all ? undefined : valid;

  for (const [id, object] of changed(document.objects, before?.objects)) {
    need('materials', object.material, ['objects', id, 'material']);
    if (object.geometry.type === 'gltf')
      need('assets', object.geometry.asset, ['objects', id, 'geometry', 'asset']);
  }
  if (valid === undefined && quadsOf(document) > maxQuadsInAll)
    issues.push({
      path: 'objects',
      message: `Too many segments: all shapes together may have at most ${2 * maxQuadsInAll} triangles`,
    });
  for (const name of ['objects', 'lights'] as const)
    for (const [id, { group }] of changed<{ group: string | null }>(document[name], before?.[name]))
      if (group !== null) need('groups', group, [name, id, 'group']);
  if (document.groups !== before?.groups) issues.push(...groupIssues(document));
  for (const [id, material] of changed(document.materials, before?.materials)) {
    issues.push(...materialIssues(document, id, material));
    for (const [path, asset] of assetsOf(material)) need('assets', asset, ['materials', id, ...path]);
  }
  const { source } = document.environment;
  if (source.type === 'hdr') need('assets', source.asset, ['environment', 'source', 'asset']);
  const { term } = document.view;
  if (term !== null) {
    need('materials', term.material, ['view', 'term', 'material']);
    const model = findModel(document, document.materials[term.material]?.model ?? '');
    if (model !== undefined && !model.terms.includes(term.name))
      issues.push({ path: 'view.term.name', message: `${model.name} has no term "${term.name}"` });
  }
  if (document.camera.near >= document.camera.far)
    issues.push({ path: 'camera.near', message: 'must be less than camera.far' });
  return issues;
}

/** Of all primitives, equal ones once: the page makes these once, too. */
function quadsOf({ objects }: Document): number {
  const different = new Map<string, number>();
  for (const { geometry } of Object.values(objects))
    different.set(JSON.stringify(geometry), quadCount(geometry));
  return [...different.values()].reduce((sum, count) => sum + count, 0);
}

/** Panels show groups within each other, each further in. */
const maxGroupDepth = 256;

/** Every parent exists, and no group is in itself, nor deep within others. */
function groupIssues({ groups }: Document): DocumentIssue[] {
  const issues: DocumentIssue[] = [];
  const depths = new Map<string, number>();
  for (const start of Object.keys(groups)) {
    const way = new Set<string>();
    let at: string | null = start;
    while (at !== null && !depths.has(at)) {
      const report = (message: string) =>
        issues.push({ path: pathText(['groups', start, 'parent']), message });
      if (way.has(at)) {
        report('the group would be in itself');
        break;
      }
      const group: Group | undefined = Object.hasOwn(groups, at) ? groups[at] : undefined;
      if (group === undefined) {
        report(`there is no group "${shortened(at)}"`);
        break;
      }
      way.add(at);
      at = group.parent;
    }
    let depth = at === null ? 0 : (depths.get(at) ?? 0);
    for (const id of [...way].reverse()) depths.set(id, ++depth);
    if (depth > maxGroupDepth) {
      issues.push({
        path: pathText(['groups', start, 'parent']),
        message: `more than ${maxGroupDepth} groups within each other`,
      });
      break;
    }
  }
  return issues;
}

function modelIssues(document: Document, valid: Document | undefined): DocumentIssue[] {
  const issues: DocumentIssue[] = [];
  for (const [name, entry] of Object.entries(document.models)) {
    // Measurements may have gone, or be others, though what names them has not changed.
    if (entry === valid?.models[name] && modelOrigin(document, name) === modelOrigin(valid, name)) continue;
    const message = modelFault(document, name);
    const field = 'source' in entry ? 'source' : 'measured';
    if (message !== null) issues.push({ path: pathText(['models', name, field]), message });
  }
  return issues;
}

/** Parameters and textures that the material's model does not have, or not of that type. */
function materialIssues(document: Document, id: string, material: Material): DocumentIssue[] {
  const issues: DocumentIssue[] = [];
  const report = (path: Path, message: string): void => {
    issues.push({ path: pathText(['materials', id, ...path]), message });
  };
  const model = findModel(document, material.model);
  if (model === undefined) {
    report(['model'], `there is no model "${material.model}"; there are ${modelNames(document).join(', ')}`);
    return issues;
  }
  const parameters = new Map(model.parameters.map((parameter) => [parameter.name, parameter]));
  for (const [name, value] of Object.entries(material.parameters)) {
    const parameter = parameters.get(name);
    if (parameter === undefined) report(['parameters', name], `${material.model} has no such parameter`);
    else if (!isValueOf(parameter, value)) report(['parameters', name], expectedValue[parameter.type]);
  }
  for (const name of Object.keys(material.textures))
    if (!parameters.has(name)) report(['textures', name], `${material.model} has no such parameter`);
  return issues;
}

const expectedValue = {
  float: 'expected a finite number',
  bool: 'expected true or false',
  color: 'expected three finite numbers (linear Rec. 709)',
} as const;

/** Finite is enough: a parameter's range is for its slider, values beyond it may be typed. */
function isValueOf(parameter: Parameter, value: Material['parameters'][string]): boolean {
  switch (parameter.type) {
    case 'float':
      return typeof value === 'number';
    case 'bool':
      return typeof value === 'boolean';
    case 'color':
      return Array.isArray(value);
  }
}

/** The assets that a material uses, each with the path of the field that names it. */
export function assetsOf(material: Material): [path: Path, asset: string][] {
  const found: [Path, string][] = Object.entries(material.textures).map(([name, texture]) => [
    ['textures', name, 'asset'],
    texture.asset,
  ]);
  for (const map of materialMaps) {
    const texture = material[map];
    if (texture !== null) found.push([[map, 'asset'], texture.asset]);
  }
  return found;
}
