/**
 * three.js's own scene files (ObjectLoader, "JSON Object/Scene format 4"), as far as they are used here. What other
 * programs and versions add stays and is ignored.
 */
import { z } from 'zod';

const uuid = z.string().max(200);
const name = z.string().max(10_000).optional();
const finite = z.number();
const vector2 = z.tuple([finite, finite]);
const vector3 = z.tuple([finite, finite, finite]);
const list = <S extends z.ZodType>(item: S, max: number) => z.array(item).max(max).default([]);

/** Only true arrays: `{ length: 1e9 }` would be an array, too, to a typed array's constructor. */
const numbers = z.array(z.unknown());
const attribute = z.looseObject({
  itemSize: z.int().min(1).max(16).optional(),
  type: z.string().optional(),
  array: numbers.optional(),
  normalized: z.boolean().optional(),
});
const bufferData = z.looseObject({
  attributes: z.record(z.string(), attribute),
  index: z.looseObject({ type: z.string(), array: numbers }).optional(),
  groups: z
    .array(
      z.looseObject({
        start: z.number(),
        count: z.number().nullable(),
        materialIndex: z.int().min(0).optional(),
      }),
    )
    .max(100_000)
    .optional(),
});
/** Until 2021 primitives were called BoxBufferGeometry, and the box was once a cube. */
const geometryType = z
  .string()
  .transform((type) =>
    type
      .replace(/^Cube(?=(Buffer)?Geometry$)/, 'Box')
      .replace(/^(?!Instanced)(\w+)BufferGeometry$/, '$1Geometry'),
  );
export const geometrySchema = z.looseObject({ uuid, type: geometryType, name, data: bufferData.optional() });

const color = z.int().min(0).max(0xffffff);
const reference = uuid.nullish();
export const materialSchema = z.looseObject({
  uuid,
  type: z.string(),
  name,
  color: color.optional(),
  emissive: color.optional(),
  emissiveIntensity: finite.default(1),
  roughness: finite.default(1),
  metalness: finite.default(0),
  specular: color.optional(),
  shininess: finite.default(30),
  opacity: finite.default(1),
  transparent: z.boolean().default(false),
  alphaTest: finite.default(0),
  side: z.int().default(0),
  vertexColors: z.unknown().optional(),
  wireframe: z.boolean().default(false),
  map: reference,
  roughnessMap: reference,
  metalnessMap: reference,
  normalMap: reference,
  normalScale: vector2.optional(),
  bumpMap: reference,
  bumpScale: finite.default(1),
  aoMap: reference,
  aoMapIntensity: finite.default(1),
  emissiveMap: reference,
  alphaMap: reference,
  clearcoat: finite.default(0),
  clearcoatRoughness: finite.default(0),
  clearcoatMap: reference,
  clearcoatNormalMap: reference,
  sheen: finite.default(0),
  sheenRoughness: finite.default(1),
  sheenColor: color.optional(),
  sheenColorMap: reference,
  ior: finite.optional(),
  reflectivity: finite.default(0.5),
  specularIntensity: finite.default(1),
  specularColor: color.default(0xffffff),
  specularIntensityMap: reference,
  transmission: finite.default(0),
  transmissionMap: reference,
  thickness: finite.default(0),
  attenuationColor: color.default(0xffffff),
  attenuationDistance: finite.nullish(),
  anisotropy: finite.default(0),
  anisotropyRotation: finite.default(0),
  anisotropyMap: reference,
  iridescence: finite.default(0),
  dispersion: finite.default(0),
});
export type SourceMaterial = z.output<typeof materialSchema>;

export const textureSchema = z.looseObject({
  uuid,
  image: reference,
  repeat: vector2.default([1, 1]),
  offset: vector2.default([0, 0]),
  center: vector2.default([0, 0]),
  rotation: finite.default(0),
  wrap: z.tuple([finite, finite]).default([1001, 1001]),
  channel: z.int().min(0).max(3).default(0),
  flipY: z.boolean().default(true),
});
export type SourceTexture = z.output<typeof textureSchema>;

export const imageSchema = z.looseObject({
  uuid,
  url: z.union([
    z.string(),
    z.looseObject({ type: z.string(), data: numbers, width: z.int().min(1), height: z.int().min(1) }),
    z.array(z.unknown()),
  ]),
});
export type SourceImage = z.output<typeof imageSchema>;

export const objectSchema = z.looseObject({
  uuid: uuid.optional(),
  type: z.string(),
  name,
  visible: z.boolean().default(true),
  matrix: z.array(finite).length(16).optional(),
  position: vector3.optional(),
  rotation: z.array(z.unknown()).optional(),
  quaternion: z.tuple([finite, finite, finite, finite]).optional(),
  scale: vector3.optional(),
  children: z.array(z.unknown()).max(1e6).default([]),
  geometry: uuid.optional(),
  material: z.union([uuid, z.array(uuid).max(10_000)]).optional(),
  count: z.int().min(0).max(1e6).optional(),
  instanceMatrix: z.looseObject({ array: z.array(finite) }).optional(),
  color: color.default(0xffffff),
  groundColor: color.default(0x000000),
  intensity: finite.default(1),
  distance: finite.default(0),
  decay: finite.default(2),
  angle: finite.default(Math.PI / 3),
  penumbra: finite.default(0),
  width: finite.default(10),
  height: finite.default(10),
  target: uuid.optional(),
  fov: finite.default(50),
  near: finite.default(0.1),
  far: finite.default(2000),
});
export type SourceObject = z.output<typeof objectSchema>;

export const sceneSchema = z.looseObject({
  geometries: list(geometrySchema, 100_000),
  materials: list(materialSchema, 100_000),
  textures: list(textureSchema, 100_000),
  images: list(imageSchema, 10_000),
  shapes: list(z.looseObject({ uuid }), 10_000),
  object: objectSchema,
});
export type SourceScene = z.output<typeof sceneSchema>;

const typeOf = (json: unknown): unknown =>
  (json as { metadata?: { type?: unknown } | null } | null)?.metadata?.type;

/** A project of three.js's editor has a scene inside; its own metadata are mostly empty. */
export function isEditorProject(json: unknown): json is { scene: unknown; [field: string]: unknown } {
  const scene = (json as { scene?: unknown } | null)?.scene;
  return typeOf(json) === 'App' || (typeOf(json) === undefined && typeOf(scene) === 'Object');
}

/** Whether a file's JSON is a scene, an object or a geometry of three.js, or a project of its editor. */
export function isObjectScene(json: unknown): boolean {
  const type = typeOf(json);
  return isEditorProject(json) || ['Object', 'BufferGeometry', 'Geometry', 'Scene'].includes(String(type));
}
