/**
 * The document: the one definition of what a scene is, and the only state of the lab. This
 * file puts the document together; its parts are in the *-schema.ts files beside it, each
 * with the fields' bounds, units and descriptions and the table of defaults.
 *
 * There are two schemas. `documentSchema` is the complete document, as it is in memory, and
 * the types come from it. `documentFileSchema` is what a file may hold: fields that have a
 * default may be left out; parsing fills them in.
 *
 * What no schema can say (references to other parts, parameters of a model) is in validate.ts.
 */
import { z } from 'zod';
import { effectsDefaults, effectsFileSchema, effectsSchema } from './effects-schema.ts';
import {
  backgroundDefault,
  backgroundSchema,
  environmentDefaults,
  environmentFileSchema,
  environmentSchema,
} from './environment-schema.ts';
import { boolean, group, id, reference, vector3, withDefaults } from './fields.ts';
import { geometryDefaults, geometryFileSchema, geometrySchema } from './geometry-schema.ts';
import { groundDefaults, groundFileSchema, groundSchema } from './ground-schema.ts';
import { groupFileSchema, groupSchema, memberDefaults, memberShape } from './group-schema.ts';
import { lightFileSchema, lightSchema, nameField } from './light-schema.ts';
import { materialFileSchema, materialSchema, modelName } from './material-schema.ts';
import {
  cameraDefaults,
  cameraFileSchema,
  cameraSchema,
  fogDefaults,
  fogFileSchema,
  fogSchema,
  pathTracingDefaults,
  pathTracingFileSchema,
  pathTracingSchema,
  viewDefaults,
  viewFileSchema,
  viewSchema,
} from './stage-schema.ts';

// A page may forbid code made from strings; zod's generated parsers would need it.
z.config({ jitless: true });

export const documentVersion = 1;

/** How many entries each collection may have. */
export const collectionLimits = {
  lights: 256,
  objects: 20_000,
  groups: 4096,
  materials: 4096,
  models: 64,
  assets: 1024,
} as const;

const collectionDescriptions = {
  lights: 'The lights, by id',
  objects: 'The objects, by id',
  groups: 'Named sets of objects and lights, by id',
  materials: 'The materials, by id; objects name theirs',
  models: 'BRDF files and measured BRDFs that do not ship with Irradia, by name',
  assets: 'Images, environments, glTF files and measurements, by id',
} as const;

/** Bytes of one asset, before base64. */
export const maxAssetBytes = 128 * 1024 * 1024;
export const maxModelLength = 1024 * 1024;

export const objectShape = {
  name: nameField,
  visible: boolean('Whether the object is shown'),
  ...memberShape,
  position: vector3('Where the object is', { range: [-1e6, 1e6], unit: 'm', step: 0.01 }),
  rotation: vector3('Rotation about x, then y, then z, each the object’s own', {
    range: [-1e4, 1e4],
    unit: '°',
    slider: [-180, 180],
    step: 1,
  }),
  scale: vector3('Scale along the object’s own axes', {
    range: [-1e5, 1e5],
    unit: '×',
    slider: [0.01, 10],
    step: 0.01,
  }),
  material: reference('What the surface is made of', 'materials'),
  geometry: geometrySchema,
} as const;

export const objectSchema = z.strictObject(objectShape);
export type SceneObject = z.output<typeof objectSchema>;

/** What an object is when it has just been added; its material has to be given. */
export const objectDefaults: Readonly<Omit<SceneObject, 'material'>> = {
  name: 'Object',
  visible: true,
  ...memberDefaults,
  position: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [1, 1, 1],
  geometry: geometryDefaults.sphere,
};

const objectFileSchema = withDefaults(
  { ...objectShape, geometry: geometryFileSchema },
  { ...objectDefaults, geometry: undefined },
);

/** What a document's own model is made from. */
export const modelSourceSchema = z.union(
  [
    z.strictObject({ source: group(z.string().max(maxModelLength), 'The text of a .brdf file') }),
    z.strictObject({
      measured: reference('A measured BRDF, as in its file or packed by Irradia', 'assets'),
    }),
  ],
  { error: 'expected { source } or { measured }' },
);
export type ModelSource = z.output<typeof modelSourceSchema>;

/** A linear test: a pattern with groups could run out of stack on megabytes. */
function isBase64(data: string): boolean {
  const end = data.endsWith('==') ? data.length - 2 : data.length - (data.endsWith('=') ? 1 : 0);
  return data.length % 4 === 0 && !/[^A-Za-z0-9+/]/.test(data.slice(0, end));
}

export const assetSchema = z.strictObject({
  name: nameField,
  mediaType: z
    .string()
    .regex(/^[a-z]+\/[A-Za-z0-9.+-]{1,80}$/)
    .describe('Media type of the data, such as image/png or model/gltf-binary'),
  data: z
    .string()
    .max(Math.ceil(maxAssetBytes / 3) * 4)
    .refine(isBase64, 'Not base64')
    .describe('The bytes of the file, as base64'),
});
export type Asset = z.output<typeof assetSchema>;

const collection = <S extends z.ZodType, K extends keyof typeof collectionLimits>(
  name: K,
  key: z.ZodString,
  schema: S,
) =>
  z
    .record(key, schema)
    .refine((record) => Object.keys(record).length <= collectionLimits[name], {
      message: `Too many ${name}: at most ${collectionLimits[name]}`,
    })
    .meta({ maxProperties: collectionLimits[name], description: collectionDescriptions[name] });

export const documentShape = {
  format: z.literal('irradia'),
  version: z.literal(documentVersion),
  name: z.string().max(200).describe('Title of the scene'),
  description: z.string().max(4000).describe('What the scene shows'),
  camera: cameraSchema,
  fog: fogSchema,
  environment: environmentSchema,
  background: backgroundSchema,
  ground: groundSchema,
  lights: collection('lights', id, lightSchema),
  objects: collection('objects', id, objectSchema),
  groups: collection('groups', id, groupSchema),
  materials: collection('materials', id, materialSchema),
  models: collection('models', modelName, modelSourceSchema),
  assets: collection('assets', id, assetSchema),
  view: viewSchema,
  effects: effectsSchema,
  pathTracing: pathTracingSchema,
};

export const documentSchema = z.strictObject(documentShape);
export type Document = z.output<typeof documentSchema>;

/** The parts of a document that hold many of a kind, by id. */
export type Collection = 'lights' | 'objects' | 'groups' | 'materials' | 'models' | 'assets';
export const collections: readonly Collection[] = [
  'lights',
  'objects',
  'groups',
  'materials',
  'models',
  'assets',
];
/** The parts that a document has once. */
export type Single = Exclude<keyof Document, Collection>;
export const singles: readonly Single[] = [
  'format',
  'version',
  'name',
  'description',
  'camera',
  'fog',
  'environment',
  'background',
  'ground',
  'view',
  'effects',
  'pathTracing',
];

export const entitySchemas = {
  lights: lightSchema,
  objects: objectSchema,
  groups: groupSchema,
  materials: materialSchema,
  models: modelSourceSchema,
  assets: assetSchema,
} as const satisfies Record<Collection, z.ZodType>;

export const documentFileSchema = withDefaults(
  {
    ...documentShape,
    camera: cameraFileSchema,
    fog: fogFileSchema,
    environment: environmentFileSchema,
    ground: groundFileSchema,
    lights: collection('lights', id, lightFileSchema),
    objects: collection('objects', id, objectFileSchema),
    groups: collection('groups', id, groupFileSchema),
    materials: collection('materials', id, materialFileSchema),
    view: viewFileSchema,
    effects: effectsFileSchema,
    pathTracing: pathTracingFileSchema,
  },
  {
    name: 'Untitled',
    description: '',
    camera: cameraDefaults,
    fog: fogDefaults,
    environment: environmentDefaults,
    background: backgroundDefault,
    ground: groundDefaults,
    lights: {},
    objects: {},
    groups: {},
    materials: {},
    models: {},
    assets: {},
    view: viewDefaults,
    effects: effectsDefaults,
    pathTracing: pathTracingDefaults,
  },
);

export type { EffectName, Effects } from './effects-schema.ts';
export type { Background, Environment, EnvironmentSource, SoftBox } from './environment-schema.ts';
export type { AddableGeometry, Geometry, GeometryOf, GeometryType } from './geometry-schema.ts';
export type { Ground } from './ground-schema.ts';
export type { Group } from './group-schema.ts';
export type { Light, LightOf, LightType } from './light-schema.ts';
export type { Material, MaterialMap, ScaledTextureRef, TextureRef } from './material-schema.ts';
export type {
  Camera,
  Fog,
  PathTracing,
  View,
} from './stage-schema.ts';
