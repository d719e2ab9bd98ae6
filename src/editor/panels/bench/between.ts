import type { Curve, CurvePoint } from '../../../analysis/plots/curve.ts';

/** On the straight line between the neighbours, as it is drawn. */
export function between(points: Curve, angle: number): CurvePoint | null {
  const next = points.findIndex((point) => point.angle >= angle);
  const [a, b] = [points[next - 1], points[next]];
  if (b?.angle === angle) return b;
  if (!a || !b) return null;
  const part = (angle - a.angle) / (b.angle - a.angle);
  const mix = (i: 0 | 1 | 2) => a.rgb[i] + part * (b.rgb[i] - a.rgb[i]);
  return { angle, rgb: [mix(0), mix(1), mix(2)] };
}
