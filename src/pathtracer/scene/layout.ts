/**
 * The numbers of docs/decisions/path-tracer.md, "The scene's memory": sizes in slots of 16 bytes, offsets in slots from
 * a record's first one unless a name says words, and the values of types and flags.
 */

export const WORDS_PER_SLOT = 4;

/** Header's slots. Those from FIRST_RENDERING_SLOT on are written for each rendering. */
export const HEADER = {
  instances: 0,
  lights: 1,
  infiniteLights: 2,
  background: 3,
  upperSky: 4,
  lowerSky: 5,
  boundingSphere: 6,
  fog: 7,
  fogAlbedo: 8,
  models: 9,
  sunDirection: 10,
  sunLuminance: 11,
  sunLimb: 12,
  ground: 13,
  levelSky: 14,
  groundPlace: 15,
  image: 16,
  cameraPosition: 17,
  cameraRight: 18,
  cameraUp: 19,
  cameraForward: 20,
  strategy: 21,
  clamp: 22,
} as const;
export const HEADER_SLOTS = 32;

/** What stands for "none" where 0 would mean the first. */
export const NONE = 0xffffffff;

export const NODE_SLOTS = 7;
export const NODE_WIDTH = 4;
/** The slot of a node's children; the six before it hold the bounds. */
export const NODE_CHILDREN = 6;
/** No traversal of one tree needs a longer stack. */
export const STACK_ENTRIES = 96;
export const LEAF = 0x80000000;

export const BLOCK_SLOTS = 10;
export const BLOCK_TRIANGLES = 4;
/** The slot of a block's triangle numbers; the nine before it hold coordinates. */
export const BLOCK_NUMBERS = 9;

export const MESH_SLOTS = 1;
/** Slots of a vertex with at most one set of texture coordinates; two more sets fit into each further slot. */
export const VERTEX_SLOTS = 2;

export const INSTANCE_SLOTS = 8;
export const INSTANCE = { toObject: 0, toWorld: 3, references: 6 } as const;
export const INSTANCE_FLAGS = { mirrors: 1 } as const;

export const MATERIAL_SLOTS = 5;
export const MATERIAL = { model: 0, emission: 1, scales: 2, textures: 3, channels: 4 } as const;
export const MATERIAL_FLAGS = { doubleSided: 1, mask: 2, blend: 4, emits: 8, transmits: 16 } as const;

/** The generic sampler's table; kernel/generic-sampler.glsl and generic-table.glsl have the same numbers. */
export const GENERIC_TABLE = { rows: 128, columns: 32, views: 16, azimuths: 4, points: 4 } as const;

/** In a parameter's w: the channel is above the slot of its texture use. */
export const CHANNEL_SHIFT = 29;
export const CHANNELS = { r: 0, g: 1, b: 2, a: 3, rgb: 4 } as const;

export const TEXTURE_SLOTS = 3;
export const WRAPS = { repeat: 0, mirror: 1, clamp: 2 } as const;
export const FORMAT_SHIFT = 4;
export const FORMATS = { srgb: 0, linear: 1 } as const;
export const UV_SHIFT = 8;

export const LIGHT_SLOTS = 6;
export const LIGHT_TYPES = {
  point: 0,
  spot: 1,
  rectangle: 2,
  triangle: 3,
  directional: 4,
  sky: 5,
} as const;
export const FALLOFFS = { 'inverse-square': 0, linear: 1, constant: 2 } as const;

export const LIGHT_NODE_SLOTS = 4;
/** The tree of lights is less deep than a bit trail is long: a trail of all ones is that of no light. */
export const MAX_LIGHT_DEPTH = 31;
export const NO_TRAIL = NONE;

export const SKY_SLOTS = 3;
