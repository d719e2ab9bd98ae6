/**
 * The picture of the studio: all directions side by side, as a chrome ball shows them to the camera. What is at the
 * picture's left is at the camera's left; in the middle is what is behind the camera, at the edges what is behind the scene.
 */
import type { SoftBox } from '../../../scene/environment-schema.ts';
import { softBoxFrame } from '../../../scene/studio.ts';

/** The picture's units; heights are half of it. */
export const PICTURE_WIDTH = 360;
export const PICTURE_HEIGHT = 180;

type Point = readonly [x: number, y: number];
type Direction = Pick<SoftBox, 'azimuth' | 'elevation'>;

const wrap = (degrees: number): number => ((((degrees + 180) % 360) + 360) % 360) - 180;

/** In the picture's units. */
export function placeOf({ azimuth, elevation }: Direction): Point {
  return [PICTURE_WIDTH / 2 - wrap(azimuth - 180), PICTURE_HEIGHT / 2 - elevation];
}

/** The direction that is shown there, azimuths from 0 to 360. */
export function directionOf([x, y]: Point): Direction {
  const azimuth = (((180 + PICTURE_WIDTH / 2 - x) % 360) + 360) % 360;
  return { azimuth, elevation: Math.min(90, Math.max(-90, PICTURE_HEIGHT / 2 - y)) };
}

const EDGE_POINTS = 8;

/** The outline of a box as an SVG path; across the picture's edge it comes in at the other side. */
export function outlineOf(box: SoftBox): string {
  const { middle, right, up } = softBoxFrame(box);
  const [w, h] = [box.width, box.height].map((degrees) => Math.tan((degrees * Math.PI) / 360)) as [
    number,
    number,
  ];
  const corners: readonly Point[] = [
    [-w, -h],
    [w, -h],
    [w, h],
    [-w, h],
  ];
  const points: Point[] = [];
  let last: number | null = null;
  for (const [i, [x0, y0]] of corners.entries()) {
    const [x1, y1] = corners[(i + 1) % 4]!;
    for (let k = 0; k < EDGE_POINTS; k += 1) {
      const t = k / EDGE_POINTS;
      const [a, b] = [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t];
      const d = middle.map((value, c) => value + a * right[c]! + b * up[c]!) as [number, number, number];
      const azimuth = (Math.atan2(d[0], -d[2]) * 180) / Math.PI;
      const elevation = (Math.atan2(d[1], Math.hypot(d[0], d[2])) * 180) / Math.PI;
      let [x] = placeOf({ azimuth, elevation });
      // The next point is close by, if need be beyond the edge.
      if (last !== null) x = last + wrap(x - last);
      last = x;
      points.push([x, PICTURE_HEIGHT / 2 - elevation]);
    }
  }
  const path = (shift: number) =>
    `M${points.map(([x, y]) => `${(x + shift).toFixed(1)} ${y.toFixed(1)}`).join('L')}Z`;
  return [0, -PICTURE_WIDTH, PICTURE_WIDTH].map(path).join('');
}

/** A box' new size when its corner is dragged to a place: angles from its middle about its own axes. */
export function sizeTowards(box: SoftBox, to: Direction): { width: number; height: number } {
  const { middle, right, up } = softBoxFrame(box);
  const [a, e] = [(to.azimuth * Math.PI) / 180, (to.elevation * Math.PI) / 180];
  const d = [Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)] as const;
  const along = (v: readonly number[]) => d[0] * v[0]! + d[1] * v[1]! + d[2] * v[2]!;
  const z = Math.max(along(middle), 1e-3);
  const size = (v: readonly number[]) =>
    Math.min(170, Math.max(1, Math.round((Math.atan(Math.abs(along(v)) / z) * 360) / Math.PI)));
  return { width: size(right), height: size(up) };
}

/** Where the corner is that is dragged: the right upper one as the picture shows the box. */
export function cornerOf(box: SoftBox): Point {
  const { middle, right, up } = softBoxFrame(box);
  const [w, h] = [box.width, box.height].map((degrees) => Math.tan((degrees * Math.PI) / 360)) as [
    number,
    number,
  ];
  const d = middle.map((value, c) => value - w * right[c]! + h * up[c]!) as [number, number, number];
  return placeOf({
    azimuth: (Math.atan2(d[0], -d[2]) * 180) / Math.PI,
    elevation: (Math.atan2(d[1], Math.hypot(d[0], d[2])) * 180) / Math.PI,
  });
}
