/**
 * glTF 2.0 as far as it is used here (section numbers are the specification's). Unknown
 * fields stay: the file is stored and given to the geometry loader as it is.
 */
import { z } from 'zod';

const index = z.int().min(0).max(1e7);
const size = z
  .int()
  .min(0)
  .max(2 ** 32);
const finite = z.number();
const name = z.string().max(10_000).optional();
const extensions = z.record(z.string(), z.unknown()).optional();
const list = <S extends z.ZodType>(item: S, max: number) => z.array(item).max(max).default([]);

const buffer = z.looseObject({ uri: z.string().optional(), byteLength: size });

/** EXT_meshopt_compression and its successor KHR_meshopt_compression have the same fields. */
export const meshoptSchema = z.looseObject({
  buffer: index,
  byteOffset: size.default(0),
  byteLength: size,
  byteStride: z.int().min(1).max(256),
  count: size,
});
export const dracoSchema = z.looseObject({ bufferView: index, attributes: z.record(z.string(), index) });

const bufferView = z.looseObject({
  buffer: index,
  byteOffset: size.default(0),
  byteLength: size,
  byteStride: z.int().min(4).max(252).optional(),
  extensions,
});

/** 3.6.2 */
const accessor = z.looseObject({
  bufferView: index.optional(),
  byteOffset: size.default(0),
  componentType: z.literal([5120, 5121, 5122, 5123, 5125, 5126]),
  normalized: z.boolean().optional(),
  count: size,
  type: z.enum(['SCALAR', 'VEC2', 'VEC3', 'VEC4', 'MAT2', 'MAT3', 'MAT4']),
  sparse: z
    .looseObject({
      count: size,
      indices: z.looseObject({ bufferView: index, byteOffset: size.default(0) }),
      values: z.looseObject({ bufferView: index, byteOffset: size.default(0) }),
    })
    .optional(),
});

/** 3.7.2 */
const primitive = z.looseObject({
  attributes: z.record(z.string(), index),
  indices: index.optional(),
  material: index.optional(),
  mode: z.int().min(0).max(6).default(4),
  targets: z.array(z.record(z.string(), index)).max(256).optional(),
  extensions,
});
/** Triangles, strips and fans; points and lines have no surface to reflect light. */
export const isSurface = (mode: number): boolean => mode >= 4;

const mesh = z.looseObject({ name, primitives: z.array(primitive).min(1).max(100_000) });

const vector3 = z.tuple([finite, finite, finite]);
const vector4 = z.tuple([finite, finite, finite, finite]);
const node = z.looseObject({
  name,
  children: z.array(index).max(1e6).default([]),
  mesh: index.optional(),
  camera: index.optional(),
  skin: index.optional(),
  matrix: z.array(finite).length(16).optional(),
  translation: vector3.optional(),
  rotation: vector4.optional(),
  scale: vector3.optional(),
  extensions,
  extras: z.unknown().optional(),
});

/** KHR_texture_transform */
export const transformSchema = z.looseObject({
  offset: z.tuple([finite, finite]).default([0, 0]),
  rotation: finite.default(0),
  scale: z.tuple([finite, finite]).default([1, 1]),
  texCoord: z.int().min(0).max(3).optional(),
});

export const textureInfoSchema = z.looseObject({
  index,
  texCoord: z.int().min(0).max(3).default(0),
  scale: finite.optional(),
  strength: finite.optional(),
  extensions,
});

/** 3.9.2 */
const metallicRoughness = z.looseObject({
  baseColorFactor: vector4.default([1, 1, 1, 1]),
  baseColorTexture: textureInfoSchema.optional(),
  metallicFactor: finite.default(1),
  roughnessFactor: finite.default(1),
  metallicRoughnessTexture: textureInfoSchema.optional(),
});
const material = z.looseObject({
  name,
  pbrMetallicRoughness: metallicRoughness.optional(),
  normalTexture: textureInfoSchema.optional(),
  occlusionTexture: textureInfoSchema.optional(),
  emissiveTexture: textureInfoSchema.optional(),
  emissiveFactor: vector3.default([0, 0, 0]),
  alphaMode: z.enum(['OPAQUE', 'MASK', 'BLEND']).default('OPAQUE'),
  alphaCutoff: finite.default(0.5),
  doubleSided: z.boolean().default(false),
  extensions,
});

/** 3.10.3 */
const camera = z.looseObject({
  name,
  type: z.enum(['perspective', 'orthographic']),
  perspective: z.looseObject({ yfov: finite, znear: finite, zfar: finite.optional() }).optional(),
});

/** KHR_lights_punctual */
const light = z.looseObject({
  name,
  type: z.enum(['directional', 'point', 'spot']),
  color: vector3.default([1, 1, 1]),
  intensity: finite.default(1),
  range: finite.optional(),
  spot: z
    .looseObject({ innerConeAngle: finite.default(0), outerConeAngle: finite.default(Math.PI / 4) })
    .optional(),
});
export const lightsSchema = z.looseObject({ lights: z.array(light).max(10_000) });

export const gltfSchema = z.looseObject({
  asset: z.looseObject({ version: z.string() }),
  extensionsRequired: z.array(z.string()).max(1000).default([]),
  extensionsUsed: z.array(z.string()).max(1000).default([]),
  scene: index.optional(),
  scenes: list(z.looseObject({ name, nodes: z.array(index).max(1e6).default([]) }), 10_000),
  nodes: list(node, 200_000),
  meshes: list(mesh, 100_000),
  accessors: list(accessor, 1e6),
  bufferViews: list(bufferView, 1e6),
  buffers: list(buffer, 10_000),
  images: list(
    z.looseObject({
      name,
      uri: z.string().optional(),
      mimeType: z.string().optional(),
      bufferView: index.optional(),
    }),
    10_000,
  ),
  textures: list(z.looseObject({ source: index.optional(), sampler: index.optional(), extensions }), 100_000),
  samplers: list(
    z.looseObject({
      wrapS: z.int().default(10497),
      wrapT: z.int().default(10497),
      magFilter: z.int().optional(),
    }),
    100_000,
  ),
  materials: list(material, 100_000),
  cameras: list(camera, 10_000),
  animations: z.array(z.unknown()).default([]),
  skins: list(z.looseObject({ joints: z.array(index).max(1e6).default([]) }), 10_000),
  extensions,
  extras: z.unknown().optional(),
});

export type Gltf = z.output<typeof gltfSchema>;
export type GltfNode = Gltf['nodes'][number];
export type GltfMaterial = Gltf['materials'][number];
export type GltfTextureInfo = z.output<typeof textureInfoSchema>;

/** WebP, AVIF and KTX2 come by extension. */
export function imageIndex(texture: Gltf['textures'][number]): number | undefined {
  for (const name of ['EXT_texture_webp', 'EXT_texture_avif', 'KHR_texture_basisu']) {
    const extension = texture.extensions?.[name];
    if (typeof extension === 'object' && extension !== null && 'source' in extension)
      if (typeof extension.source === 'number') return extension.source;
  }
  return texture.source;
}

/** In `extras`: what Irradia's export says of a file and of a node, so that it comes back as it was. */
export const OUR_SCENE = { irradia: 'scene' } as const;
export const OUR_GROUP = { irradia: 'group' } as const;

const saysOfUs = (extras: unknown): unknown => (extras as { irradia?: unknown } | null | undefined)?.irradia;
export const isSceneOfOurs = ({ extras }: Gltf): boolean => saysOfUs(extras) === OUR_SCENE.irradia;
export const isGroupOfOurs = ({ extras }: GltfNode): boolean => saysOfUs(extras) === OUR_GROUP.irradia;
