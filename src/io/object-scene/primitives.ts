/** three.js's primitives as the document's, which are made by the same classes and keep their angles in degrees. */
import { MathUtils } from 'three/webgpu';
import { geometrySchema } from '../../scene/geometry-schema.ts';
import type { Primitive } from '../../scene/mirror/geometry.ts';
import type { SourceScene } from './schema.ts';

type Entry = SourceScene['geometries'][number];

const TURN = 2 * Math.PI;

interface Shape {
  type: Primitive['type'];
  /** The document's fields, with what three.js takes where a file leaves them out. */
  fields: Readonly<Record<string, number | boolean>>;
  /** Those that the document has not: only with these values is the shape the same. */
  fixed?: Readonly<Record<string, number>>;
}

const sector = { thetaStart: 0, thetaLength: TURN };
const tube = { height: 1, radialSegments: 32, heightSegments: 1, openEnded: false, ...sector };

/** Defaults are those of the constructors in three.js r187. */
const shapes: Readonly<Record<string, Shape>> = {
  PlaneGeometry: { type: 'plane', fields: { width: 1, height: 1, widthSegments: 1, heightSegments: 1 } },
  CircleGeometry: { type: 'circle', fields: { radius: 1, segments: 32, ...sector } },
  BoxGeometry: {
    type: 'box',
    fields: { width: 1, height: 1, depth: 1, widthSegments: 1, heightSegments: 1, depthSegments: 1 },
  },
  ConeGeometry: { type: 'cone', fields: { radius: 1, ...tube } },
  CylinderGeometry: { type: 'cylinder', fields: { radiusTop: 1, radiusBottom: 1, ...tube } },
  TorusGeometry: {
    type: 'torus',
    fields: { radius: 1, tube: 0.4, radialSegments: 12, tubularSegments: 48, arc: TURN },
    fixed: sector,
  },
  SphereGeometry: {
    type: 'sphere',
    fields: { radius: 1, widthSegments: 32, heightSegments: 16 },
    fixed: { phiStart: 0, phiLength: TURN, thetaStart: 0, thetaLength: Math.PI },
  },
};

const angles = new Set(['thetaStart', 'thetaLength', 'arc']);
/** 60 comes back as 60: what is rounded off is far below what a vertex's float can hold. */
const degrees = (radians: number): number => Math.round(MathUtils.radToDeg(radians) * 1e9) / 1e9;

/** The primitive with the same vertices in the same order; null where the document has none. */
export function ownPrimitive(entry: Entry): Primitive | null {
  const shape = Object.hasOwn(shapes, entry.type) ? shapes[entry.type] : undefined;
  if (shape === undefined) return null;
  for (const [name, value] of Object.entries(shape.fixed ?? {}))
    if (entry[name] !== undefined && entry[name] !== value) return null;
  const values: Record<string, unknown> = { type: shape.type };
  for (const [name, whenMissing] of Object.entries(shape.fields)) {
    const value = entry[name] === undefined ? whenMissing : entry[name];
    values[name] = angles.has(name) && typeof value === 'number' ? degrees(value) : value;
  }
  const result = geometrySchema.safeParse(values);
  // What is out of the document's range, such as a box of no height, stays the mesh that it is.
  return result.success ? (result.data as Primitive) : null;
}
