/** The geometries of a document: the thesis's primitives, Suzanne, and parts of glTF assets. */
import { z } from 'zod';
import { boolean, integer, number, reference, withDefaults } from './fields.ts';

const length = (description: string, min = 1e-4) =>
  number(description, { range: [min, 1e5], unit: 'm', slider: [0.01, 10], step: 0.01 });

/** A radius that may vanish, as the top of a cylinder may. */
const radius = (description: string) => length(description, 0);

const angle = (description: string) =>
  number(description, { range: [-360, 360], unit: '°', slider: [0, 360], step: 1 });

const segments = (description: string, min: number, slider: number) =>
  integer(description, { range: [min, 4096], slider: [min, slider] });

const thetaStart = angle('Angle at which the shape begins');
const thetaLength = angle('Angle that the shape covers; 360 is the whole');
const radialSegments = segments('Divisions around the axis', 3, 128);
const heightSegments = segments('Divisions along the height', 1, 64);
const openEnded = boolean('Without the caps at the ends');

/** The fields of each geometry, in the order in which the inspector shows them. */
export const geometryShapes = {
  plane: {
    type: z.literal('plane'),
    width: length('Size along x'),
    height: length('Size along y'),
    widthSegments: segments('Divisions along x', 1, 64),
    heightSegments: segments('Divisions along y', 1, 64),
  },
  circle: {
    type: z.literal('circle'),
    radius: length('Distance from the centre to the edge'),
    segments: segments('Divisions around the centre', 3, 256),
    thetaStart,
    thetaLength,
  },
  box: {
    type: z.literal('box'),
    width: length('Size along x'),
    height: length('Size along y'),
    depth: length('Size along z'),
    widthSegments: segments('Divisions along x', 1, 32),
    heightSegments: segments('Divisions along y', 1, 32),
    depthSegments: segments('Divisions along z', 1, 32),
  },
  cone: {
    type: z.literal('cone'),
    radius: length('Radius of the base'),
    height: length('From the base to the tip'),
    radialSegments,
    heightSegments,
    openEnded,
    thetaStart,
    thetaLength,
  },
  cylinder: {
    type: z.literal('cylinder'),
    radiusTop: radius('Radius of the upper end'),
    radiusBottom: radius('Radius of the lower end'),
    height: length('From end to end'),
    radialSegments,
    heightSegments,
    openEnded,
    thetaStart,
    thetaLength,
  },
  torus: {
    type: z.literal('torus'),
    radius: length('From the centre of the ring to the centre of the tube'),
    tube: length('Radius of the tube'),
    radialSegments: segments('Divisions around the tube', 3, 128),
    tubularSegments: segments('Divisions along the ring', 3, 256),
    arc: angle('Angle that the ring covers; 360 is the whole'),
  },
  sphere: {
    type: z.literal('sphere'),
    radius: length('Radius'),
    widthSegments: segments('Divisions around the axis', 3, 256),
    heightSegments: segments('Divisions from pole to pole', 2, 128),
  },
  suzanne: { type: z.literal('suzanne') },
  gltf: {
    type: z.literal('gltf'),
    asset: reference('The glTF file', 'assets'),
    node: integer('Index of the node in the file', { range: [0, 1e6] }),
    primitive: integer('Index of the primitive in the node’s mesh', { range: [0, 1e6] }),
  },
} as const;

export const geometrySchemas = {
  plane: z.strictObject(geometryShapes.plane),
  circle: z.strictObject(geometryShapes.circle),
  box: z.strictObject(geometryShapes.box),
  cone: z.strictObject(geometryShapes.cone),
  cylinder: z.strictObject(geometryShapes.cylinder),
  torus: z.strictObject(geometryShapes.torus),
  sphere: z.strictObject(geometryShapes.sphere),
  suzanne: z.strictObject(geometryShapes.suzanne),
  gltf: z.strictObject(geometryShapes.gltf),
} as const;

export type GeometryType = keyof typeof geometryShapes;
export type GeometryOf<T extends GeometryType> = z.output<(typeof geometrySchemas)[T]>;
export type Geometry = { [T in GeometryType]: GeometryOf<T> }[GeometryType];

/** The geometries that need nothing but their parameters: what an Add menu offers. */
export type AddableGeometry = Exclude<GeometryType, 'gltf'>;

/** What a geometry of each type is when it has just been added, and what a file may leave out. */
export const geometryDefaults: { readonly [T in AddableGeometry]: Readonly<GeometryOf<T>> } = {
  plane: { type: 'plane', width: 2, height: 2, widthSegments: 1, heightSegments: 1 },
  circle: { type: 'circle', radius: 1, segments: 64, thetaStart: 0, thetaLength: 360 },
  box: {
    type: 'box',
    width: 1,
    height: 1,
    depth: 1,
    widthSegments: 1,
    heightSegments: 1,
    depthSegments: 1,
  },
  cone: {
    type: 'cone',
    radius: 0.5,
    height: 1,
    radialSegments: 64,
    heightSegments: 1,
    openEnded: false,
    thetaStart: 0,
    thetaLength: 360,
  },
  cylinder: {
    type: 'cylinder',
    radiusTop: 0.5,
    radiusBottom: 0.5,
    height: 1,
    radialSegments: 64,
    heightSegments: 1,
    openEnded: false,
    thetaStart: 0,
    thetaLength: 360,
  },
  torus: { type: 'torus', radius: 0.5, tube: 0.2, radialSegments: 32, tubularSegments: 96, arc: 360 },
  sphere: { type: 'sphere', radius: 0.5, widthSegments: 64, heightSegments: 32 },
  suzanne: { type: 'suzanne' },
};

export const addableGeometries = Object.keys(geometryDefaults) as AddableGeometry[];

/** What a geometry is called in menus and as the name of a new object. */
export const geometryNames: Readonly<Record<GeometryType, string>> = {
  plane: 'Plane',
  circle: 'Circle',
  box: 'Cube',
  cone: 'Cone',
  cylinder: 'Cylinder',
  torus: 'Torus',
  sphere: 'Sphere',
  suzanne: 'Suzanne',
  gltf: 'Mesh',
};

/** About 8.4 million triangles: the thesis's spheres had 8 million each. */
const maxQuads = 2048 * 2048;

/** How many quads a primitive has, roughly; what keeps a hostile document from filling memory. */
export function quadCount(geometry: Geometry): number {
  switch (geometry.type) {
    case 'plane':
      return geometry.widthSegments * geometry.heightSegments;
    case 'circle':
      return geometry.segments / 2;
    case 'box': {
      const { widthSegments: w, heightSegments: h, depthSegments: d } = geometry;
      return 2 * (w * h + w * d + h * d);
    }
    case 'cone':
    case 'cylinder':
      return geometry.radialSegments * (geometry.heightSegments + 1);
    case 'torus':
      return geometry.radialSegments * geometry.tubularSegments;
    case 'sphere':
      return geometry.widthSegments * geometry.heightSegments;
    case 'suzanne':
    case 'gltf':
      return 0;
  }
}

/** Of the different primitives of a document together: some seconds of work, a gigabyte of memory. */
export const maxQuadsInAll = 4 * maxQuads;

const tooFine = {
  path: ['type'],
  message: `Too many segments: a geometry may have at most ${2 * maxQuads} triangles`,
};
const isModest = (geometry: Geometry): boolean => quadCount(geometry) <= maxQuads;

export const geometrySchema = z
  .discriminatedUnion('type', [
    geometrySchemas.plane,
    geometrySchemas.circle,
    geometrySchemas.box,
    geometrySchemas.cone,
    geometrySchemas.cylinder,
    geometrySchemas.torus,
    geometrySchemas.sphere,
    geometrySchemas.suzanne,
    geometrySchemas.gltf,
  ])
  .refine(isModest, tooFine);

export const geometryFileSchema = z
  .discriminatedUnion('type', [
    withDefaults(geometryShapes.plane, geometryDefaults.plane),
    withDefaults(geometryShapes.circle, geometryDefaults.circle),
    withDefaults(geometryShapes.box, geometryDefaults.box),
    withDefaults(geometryShapes.cone, geometryDefaults.cone),
    withDefaults(geometryShapes.cylinder, geometryDefaults.cylinder),
    withDefaults(geometryShapes.torus, geometryDefaults.torus),
    withDefaults(geometryShapes.sphere, geometryDefaults.sphere),
    geometrySchemas.suzanne,
    withDefaults(geometryShapes.gltf, { primitive: 0 }),
  ])
  .refine(isModest, tooFine);
