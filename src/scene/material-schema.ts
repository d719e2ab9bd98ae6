/** Materials and their textures. A material's parameters are defined by its model's file. */
import { z } from 'zod';
import {
  boolean,
  choice,
  choiceOrNull,
  color,
  group,
  integer,
  integerOrNull,
  number,
  reference,
  vector2,
  withDefaults,
} from './fields.ts';
import { nameField } from './light-schema.ts';

/** As in GLSL: what a .brdf file can call a parameter. */
export const parameterNamePattern = /^[A-Za-z_][A-Za-z0-9_]{0,63}$/;
const parameterName = z.string().regex(parameterNamePattern);

/** A model's name: its file's, without folder and extension. */
export const modelNamePattern = /^[A-Za-z0-9][A-Za-z0-9 ._-]{0,63}$/;
export const modelName = z
  .string()
  .regex(modelNamePattern)
  .describe('Name of the BRDF: a shipped model or one under `models`');

const textureShape = {
  asset: reference('The image, or the glTF file that holds it', 'assets'),
  texture: integerOrNull(
    'Index of the texture in a glTF file; of a pattern 0 its colour, 1 its normals, 2 its height (r) and roughness (g); null for an image',
    {
      range: [0, 1e6],
    },
  ),
  channel: choiceOrNull('The channel that drives a number; null takes the colour', ['r', 'g', 'b', 'a']),
  colorSpace: choice('sRGB for colours, linear for data', ['srgb', 'linear']),
  repeat: vector2('How often the image repeats over the surface', {
    range: [-1e4, 1e4],
    unit: '×',
    step: 0.1,
  }),
  offset: vector2('Shift in texture coordinates', { range: [-1e4, 1e4], step: 0.01 }),
  rotation: number('Rotation of the image', {
    range: [-360, 360],
    unit: '°',
    slider: [-180, 180],
    step: 1,
  }),
  wrap: choice('What lies beyond the image’s edge', ['repeat', 'mirror', 'clamp']),
  uv: integer('Which set of texture coordinates', { range: [0, 3], slider: [0, 1] }),
};
const textureDefaults = {
  texture: null,
  channel: null,
  colorSpace: 'linear',
  repeat: [1, 1],
  offset: [0, 0],
  rotation: 0,
  wrap: 'repeat',
  uv: 0,
} as const;

export const textureRefShape = textureShape;
export const textureRefSchema = z.strictObject(textureShape);
export type TextureRef = z.output<typeof textureRefSchema>;
const textureRefFileSchema = withDefaults(
  textureShape,
  structuredClone(textureDefaults) as Partial<TextureRef>,
);

export const scaledTextureShape = {
  ...textureShape,
  scale: number('Strength of the map', { range: [-100, 100], slider: [0, 2], step: 0.01 }),
};
export const scaledTextureSchema = z.strictObject(scaledTextureShape);
export type ScaledTextureRef = z.output<typeof scaledTextureSchema>;
const scaledTextureFileSchema = withDefaults(scaledTextureShape, {
  ...(structuredClone(textureDefaults) as Partial<TextureRef>),
  scale: 1,
});

/** A texture reference with every field but the asset at its default. */
export function textureRef(asset: string, values: Partial<TextureRef> = {}): TextureRef {
  return { ...(structuredClone(textureDefaults) as Omit<TextureRef, 'asset'>), ...values, asset };
}

/** Any finite number: a model's range is for sliders, values beyond it may be typed. */
const parameterValue = z.union([z.number(), z.boolean(), z.tuple([z.number(), z.number(), z.number()])]);

const maxParameters = 256;
const countIsBounded = (record: Record<string, unknown>): boolean =>
  Object.keys(record).length <= maxParameters;
const tooMany = { message: `Too many entries: at most ${maxParameters}` };

const parameters = group(
  z.record(parameterName, parameterValue).refine(countIsBounded, tooMany),
  'Values of the model’s parameters, by name; what is not here has the model’s default',
);

const texturesField = 'Textures of the model’s parameters, by name: value times texel';

const mapFields = {
  normalMap: 'Tangent space normal map',
  bumpMap: 'Height map that bends the normal',
  occlusionMap: 'Ambient occlusion: darkens ambient and environment light',
  emissiveMap: 'Multiplies the emitted light',
  opacityMap: 'With mask or blend: multiplies the opacity, by its alpha unless a channel is chosen',
} as const;

const common = {
  name: nameField,
  model: modelName,
  parameters,
  emissive: color('Colour of the light that the surface emits, linear Rec. 709'),
  emissiveIntensity: number('Luminance of the emitted light', {
    range: [0, 1e9],
    unit: 'nt',
    slider: [0, 10],
    step: 0.01,
  }),
  alphaMode: choice('Opaque; mask: there or not; blend: see-through', ['opaque', 'mask', 'blend']),
  alphaCutoff: number('With mask: what is less opaque than this is not there', {
    range: [0, 1],
    step: 0.01,
  }),
  opacity: number('With mask or blend: how opaque the surface is', { range: [0, 1], step: 0.01 }),
  doubleSided: boolean('Show the faces’ backs too'),
  multipleScattering: boolean(
    'Adds the light that bounces from facet to facet: rough metals keep their brightness. For models that know it',
  ),
};

export const materialShape = {
  ...common,
  textures: group(z.record(parameterName, textureRefSchema).refine(countIsBounded, tooMany), texturesField),
  normalMap: group(scaledTextureSchema.nullable(), mapFields.normalMap),
  bumpMap: group(scaledTextureSchema.nullable(), mapFields.bumpMap),
  occlusionMap: group(scaledTextureSchema.nullable(), mapFields.occlusionMap),
  emissiveMap: group(scaledTextureSchema.nullable(), mapFields.emissiveMap),
  opacityMap: group(scaledTextureSchema.nullable(), mapFields.opacityMap),
} as const;

export const materialSchema = z.strictObject(materialShape);
export type Material = z.output<typeof materialSchema>;
export type MaterialMap = keyof typeof mapFields;
export const materialMaps = Object.keys(mapFields) as MaterialMap[];

export const materialDefaults: Readonly<Material> = {
  name: 'Material',
  model: 'principled',
  parameters: {},
  textures: {},
  normalMap: null,
  bumpMap: null,
  occlusionMap: null,
  emissiveMap: null,
  opacityMap: null,
  emissive: [0, 0, 0],
  emissiveIntensity: 1,
  alphaMode: 'opaque',
  alphaCutoff: 0.5,
  opacity: 1,
  doubleSided: false,
  multipleScattering: false,
};

/** The model has no default in a file: what reflects the light is not left to guessing. */
export const materialFileSchema = withDefaults(
  {
    ...common,
    textures: z
      .record(parameterName, textureRefFileSchema)
      .refine(countIsBounded, tooMany)
      .describe(texturesField),
    normalMap: scaledTextureFileSchema.nullable().describe(mapFields.normalMap),
    bumpMap: scaledTextureFileSchema.nullable().describe(mapFields.bumpMap),
    occlusionMap: scaledTextureFileSchema.nullable().describe(mapFields.occlusionMap),
    emissiveMap: scaledTextureFileSchema.nullable().describe(mapFields.emissiveMap),
    opacityMap: scaledTextureFileSchema.nullable().describe(mapFields.opacityMap),
  },
  { ...materialDefaults, model: undefined },
);
