/** The lines that show how a light stands in the scene, and the corners that mark what is aimed at. */
import { type Box3, type Matrix4, Vector3 } from 'three/webgpu';
import type { Light } from '../../scene/schema.ts';
import type { Point } from './projector.ts';

/** A polyline in world space. */
export type Line = readonly Point[];

export interface LightLines {
  main: Line[];
  /** Where the light reaches, dashed. */
  faint: Line[];
}

export function lightLines(light: Light): LightLines {
  switch (light.type) {
    case 'ambient':
    case 'hemisphere':
      return { main: [], faint: [] };
    case 'point':
      return {
        main: light.radius > 0 ? sphereLines(light.position, light.radius) : [],
        faint: light.range > 0 ? sphereLines(light.position, light.range) : [],
      };
    case 'directional': {
      const { forward, right, up } = frame(light.position, light.target);
      const size = 0.3;
      const rays = [-1, 0, 1].flatMap((i) =>
        [-1, 0, 1]
          .filter((j) => Math.abs(i) + Math.abs(j) !== 2)
          .map((j): Line => {
            const from = at(light.position, [right, i * size], [up, j * size]);
            return [from, at(from, [forward, size * 2.5])];
          }),
      );
      return { main: rays, faint: [[light.position, light.target]] };
    }
    case 'spot': {
      const { forward, right, up, distance } = frame(light.position, light.target);
      const ring = (degrees: number): Point[] => {
        const angle = (Math.min(degrees, 89) * Math.PI) / 180;
        // A ring on the sphere about the light: a cone of 90 degrees still has one.
        const centre = at(light.position, [forward, distance * Math.cos(angle)]);
        return circle(centre, right, up, distance * Math.sin(angle));
      };
      const edge = ring(light.cutoff);
      const spokes = [0, 0.25, 0.5, 0.75].map((t): Line => {
        const end = edge[Math.round(t * (edge.length - 1))];
        return end ? [light.position, end] : [];
      });
      const inner = light.penumbra > 0 ? [ring(light.cutoff * (1 - light.penumbra))] : [];
      // The lamp itself: a disc that faces what it lights.
      const lamp = light.radius > 0 ? [circle(light.position, right, up, light.radius)] : [];
      return { main: [edge, ...spokes, ...lamp], faint: [[light.position, light.target], ...inner] };
    }
    case 'rectangle': {
      const { forward, right, up } = frame(light.position, light.target);
      const corner = (x: number, y: number) =>
        at(light.position, [right, (x * light.width) / 2], [up, (y * light.height) / 2]);
      const outline = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)];
      const normal = at(light.position, [forward, Math.max(light.width, light.height) * 0.4]);
      return { main: [outline, [light.position, normal]], faint: [[normal, light.target]] };
    }
  }
}

/** A quarter of each edge of a box at every corner. */
export function boxCorners(box: Box3, matrix: Matrix4): Line[] {
  if (box.isEmpty()) return [];
  const part = 0.22;
  const lines: Line[] = [];
  const sides = [0, 1];
  const corner = (i: number, j: number, k: number) =>
    new Vector3(
      box.min.x + (box.max.x - box.min.x) * i,
      box.min.y + (box.max.y - box.min.y) * j,
      box.min.z + (box.max.z - box.min.z) * k,
    )
      .applyMatrix4(matrix)
      .toArray() as [number, number, number];
  for (const i of sides)
    for (const j of sides)
      for (const k of sides) {
        const from = corner(i, j, k);
        lines.push([from, corner(i ? 1 - part : part, j, k)]);
        lines.push([from, corner(i, j ? 1 - part : part, k)]);
        lines.push([from, corner(i, j, k ? 1 - part : part)]);
      }
  return lines;
}

type Step = readonly [direction: Vector3, length: number];

function at(from: Point, ...steps: readonly Step[]): Point {
  const result = new Vector3(...from);
  for (const [direction, length] of steps) result.addScaledVector(direction, length);
  return [result.x, result.y, result.z];
}

/** The axes of a light that looks at its target, as three.js orients it. */
function frame(position: Point, target: Point) {
  const forward = new Vector3(...target).sub(new Vector3(...position));
  const distance = forward.length();
  if (distance > 0) forward.divideScalar(distance);
  else forward.set(0, 0, -1);
  const helper = Math.abs(forward.y) > 0.9999 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  const right = new Vector3().crossVectors(forward, helper).normalize();
  const up = new Vector3().crossVectors(right, forward);
  return { forward, right, up, distance };
}

const SIDES = 48;

function circle(centre: Point, right: Vector3, up: Vector3, radius: number): Point[] {
  return Array.from({ length: SIDES + 1 }, (_, i) => {
    const angle = (i / SIDES) * 2 * Math.PI;
    return at(centre, [right, radius * Math.cos(angle)], [up, radius * Math.sin(angle)]);
  });
}

function sphereLines(centre: Point, radius: number): Line[] {
  const [x, y, z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
  return [circle(centre, x, y, radius), circle(centre, y, z, radius), circle(centre, z, x, radius)];
}
