/** The hemisphere of directions as one sees it from outside, in parallel projection. */
import type { Vec3 } from '../../../analysis/vector.ts';
import { wrapped } from './frame.ts';
import type { Point } from './painter.ts';

export interface Projection {
  readonly radius: number;
  /** Towards who looks. */
  readonly back: Vec3;
  /** On the page; x to the right, y down. */
  place(p: Vec3): Point;
  /** Larger is nearer. */
  depth(p: Vec3): number;
  /** The direction whose tip at a length is under a point: of the two on that sphere the nearer, or the other. */
  direction(at: Point, length: number, nearer: boolean): { theta: number; phi: number };
}

const MARGIN = { side: 28, top: 26, bottom: 22 };

const radians = (angle: number) => (angle * Math.PI) / 180;

/** @param azimuth, elevation degrees: where one looks from */
export function projectionOf(width: number, height: number, azimuth: number, elevation: number): Projection {
  const [ca, sa] = [Math.cos(radians(azimuth)), Math.sin(radians(azimuth))];
  const [ce, se] = [Math.cos(radians(elevation)), Math.sin(radians(elevation))];
  const right: Vec3 = [-sa, ca, 0];
  const up: Vec3 = [-se * ca, -se * sa, ce];
  const back: Vec3 = [ce * ca, ce * sa, se];
  const free = height - MARGIN.top - MARGIN.bottom;
  const radius = Math.max(20, Math.min(width / 2 - MARGIN.side, free / (1 + se)));
  const center: Point = [width / 2, MARGIN.top + (free - radius * (1 + se)) / 2 + radius];
  const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return {
    radius,
    back,
    place: (p) => [center[0] + radius * dot(p, right), center[1] - radius * dot(p, up)],
    depth: (p) => dot(p, back),
    direction([x, y], length, nearer) {
      let a = (x - center[0]) / radius / length;
      let b = (center[1] - y) / radius / length;
      const out = Math.hypot(a, b);
      if (out > 1) [a, b] = [a / out, b / out];
      const c = Math.sqrt(Math.max(0, 1 - a * a - b * b)) * (nearer ? 1 : -1);
      const p = [0, 1, 2].map((k) => a * right[k as 0] + b * up[k as 0] + c * back[k as 0]);
      const [px = 0, py = 0, pz = 0] = p;
      const theta = (Math.acos(Math.max(-1, Math.min(1, pz))) * 180) / Math.PI;
      return { theta, phi: wrapped((Math.atan2(py, px) * 180) / Math.PI) };
    },
  };
}
