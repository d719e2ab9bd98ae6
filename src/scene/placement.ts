/** Where new objects and lights go: near what the camera looks at, beside what is there, on the floor. */
import type { Geometry } from './geometry-schema.ts';
import type { Document, SceneObject } from './schema.ts';

type Triple = [number, number, number];

/** An axis-aligned box. */
interface Box {
  readonly center: Triple;
  readonly half: Triple;
}

/** Free space around a new object, in metres. */
const GAP = 0.1;
/** What is flatter than this share of its width is a floor, a ceiling or a table top: things stand on it. */
const FLAT = 0.05;
/** Rings around the middle that are tried, and places on the first of them. */
const RINGS = 40;
const PLACES = 8;
/** Lights closer than this, in metres, hide each other's helpers. */
const LIGHT_SPACING = 0.6;

/** Half the size of a geometry along its axes; of a mesh from a file, whose size is not known here, a guess. */
function halfSize(geometry: Geometry): Triple {
  switch (geometry.type) {
    case 'plane':
      return [geometry.width / 2, geometry.height / 2, 0];
    case 'circle':
      return [geometry.radius, geometry.radius, 0];
    case 'box':
      return [geometry.width / 2, geometry.height / 2, geometry.depth / 2];
    case 'cone':
      return [geometry.radius, geometry.height / 2, geometry.radius];
    case 'cylinder': {
      const radius = Math.max(geometry.radiusTop, geometry.radiusBottom);
      return [radius, geometry.height / 2, radius];
    }
    case 'torus': {
      const reach = geometry.radius + geometry.tube;
      return [reach, reach, geometry.tube];
    }
    case 'sphere':
      return [geometry.radius, geometry.radius, geometry.radius];
    case 'suzanne':
      return [0.93, 0.67, 0.58];
    case 'gltf':
      return [1, 1, 1];
  }
}

/** The box around an object: each of its axes, turned, reaches this far along each axis of the world. */
function boxOf({ geometry, position, rotation, scale }: Omit<SceneObject, 'material'>): Box {
  const half = halfSize(geometry).map((h, i) => Math.abs(h * (scale[i] as number))) as Triple;
  const angles = rotation.map((degrees) => (degrees * Math.PI) / 180);
  const [ca, cb, cc] = angles.map(Math.cos) as Triple;
  const [sa, sb, sc] = angles.map(Math.sin) as Triple;
  // Rx Ry Rz, as three.js turns an object by its Euler angles in the order XYZ.
  const matrix: readonly Triple[] = [
    [cb * cc, -cb * sc, sb],
    [ca * sc + sa * cc * sb, ca * cc - sa * sc * sb, -sa * cb],
    [sa * sc - ca * cc * sb, sa * cc + ca * sc * sb, ca * cb],
  ];
  const reach = matrix.map((row) => row.reduce((sum, x, i) => sum + Math.abs(x) * (half[i] as number), 0));
  return { center: [...position], half: reach as Triple };
}

const isFlat = ({ half: [x, y, z] }: Box): boolean => y <= FLAT * Math.min(x, z);
const top = ({ center, half }: Box): number => center[1] + half[1];
const bottom = ({ center, half }: Box): number => center[1] - half[1];

/** The height of what an object at (x, z) would stand on: the highest floor below the eye, else the ground. */
function floorAt(boxes: readonly Box[], eye: number, x: number, z: number): number {
  const floors = boxes.filter(
    (box) =>
      isFlat(box) &&
      top(box) < eye &&
      Math.abs(x - box.center[0]) <= box.half[0] &&
      Math.abs(z - box.center[2]) <= box.half[2],
  );
  if (floors.length > 0) return Math.max(...floors.map(top));
  const standing = boxes.filter((box) => !isFlat(box)).map(bottom);
  return standing.length > 0 ? Math.min(...standing) : 0;
}

/** The height of the lowest visible object, by the boxes around them; 0 if there is none. */
export function lowestObject({ objects }: Document): number {
  const visible = Object.values(objects).filter((object) => object.visible);
  return visible.length > 0 ? Math.min(...visible.map((object) => bottom(boxOf(object)))) : 0;
}

const overlap = (a: Box, b: Box): boolean =>
  [0, 1, 2].every(
    (i) =>
      Math.abs((a.center[i] as number) - (b.center[i] as number)) <
      (a.half[i] as number) + (b.half[i] as number) + (i === 1 ? 0 : GAP),
  );

/**
 * The free place nearest to where the camera looks, on the floor there; above everything if there is none.
 *
 * @param object the new one; its position does not count
 */
export function freePlace(document: Document, object: Omit<SceneObject, 'material'>): Triple {
  const { half } = boxOf(object);
  const [x0, , z0] = document.camera.target;
  const boxes = Object.values(document.objects).map(boxOf);
  const others = boxes.filter((box) => !isFlat(box));
  const step = Math.max(half[0], half[2], 0.25) + GAP / 2;
  for (let ring = 0; ring < RINGS; ring++) {
    for (let k = 0; k < Math.max(1, ring * PLACES); k++) {
      const angle = (2 * Math.PI * k) / Math.max(1, ring * PLACES);
      const [x, z] = [x0 + ring * step * Math.cos(angle), z0 + ring * step * Math.sin(angle)].map(
        (c) => Math.round(c * 1000) / 1000,
      ) as [number, number];
      const y = floorAt(boxes, document.camera.position[1], x, z) + half[1];
      // Standing on something is not to be inside it.
      const place: Box = { center: [x, y + 1e-6, z], half };
      if (!others.some((other) => overlap(place, other))) return [x, y, z];
    }
  }
  return [x0, Math.max(...others.map(top)) + half[1], z0];
}

/** A light's default position, moved to where the camera looks and aside from other lights there. */
export function lightPlace(document: Document, position: readonly number[]): Triple {
  const [x, y, z] = lightTarget(document, position);
  const taken = Object.values(document.lights).flatMap((light) =>
    'position' in light ? [light.position] : [],
  );
  const isFree = (at: number) =>
    taken.every(([a, b, c]) => Math.hypot(a - at, b - y, c - z) >= LIGHT_SPACING * 0.99);
  // To the right, to the left, further to the right: one more place than there are lights.
  for (let k = 0; k <= 2 * taken.length; k++) {
    const at = x + LIGHT_SPACING * Math.ceil(k / 2) * (k % 2 === 1 ? 1 : -1);
    if (isFree(at)) return [at, y, z];
  }
  return [x, y, z];
}

/** A point that is given from the floor below where the camera looks. */
export function lightTarget(document: Document, [dx = 0, dy = 0, dz = 0]: readonly number[]): Triple {
  const [x, , z] = document.camera.target;
  const boxes = Object.values(document.objects).map(boxOf);
  return [x + dx, floorAt(boxes, document.camera.position[1], x, z) + dy, z + dz];
}
