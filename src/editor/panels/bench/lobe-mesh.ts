/** Lobes as coloured quadrangles in the order in which they are painted: the farthest first. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import { type Rgb, radians } from '../../../analysis/plots/curve.ts';
import type { Lobe } from '../../../analysis/plots/lobe.ts';
import { direction, type Vec3 } from '../../../analysis/vector.ts';
import { computedColor } from '../../theme/theme.ts';
import type { PlottedCurve } from './frame.ts';
import type { Point } from './painter.ts';
import type { Projection } from './projection.ts';
import type { Scale } from './scale.ts';
import type { PaneSettings } from './settings.ts';
import { encodeSrgb, rgbOf } from './tone.ts';

export interface Facet {
  readonly corners: readonly Point[];
  readonly color: string;
  readonly edge: string | null;
  readonly depth: number;
  /** Of the facet's middle, degrees. */
  readonly theta: number;
  readonly phi: number;
}

/** A value beyond the axis ends here. */
const FARTHEST = 1.35;
/** Several lobes are seen through one another. */
/** The wire's part of opaque. */
const WIRE = 0.375;
const TRANSLUCENT = 0.55;
/** Square pixels: a sharp lobe has most of its facets where it is almost nothing. */
const LEAST_AREA = 0.05;

/** What the length of the lobe is: luminance where the colours are shown. */
const lengthChannel = (channel: PaneSettings['channel']) => (channel === 'rgb' ? 'luminance' : channel);

export function lobeValues({ lobe }: PlottedCurve, { channel }: PaneSettings): number[] {
  if (!lobe) return [];
  const values: number[] = [];
  for (let i = 0; i < lobe.values.length; i += 3) {
    values.push(channelOf(rgbAt(lobe, i), lengthChannel(channel)));
  }
  return values;
}

export function facetsOf(
  curves: readonly PlottedCurve[],
  settings: PaneSettings,
  scale: Scale,
  projection: Projection,
): Facet[] {
  const facets = curves.flatMap((curve) =>
    facetsOfOne(curve, settings, scale, projection, curves.length > 1),
  );
  return facets.sort((a, b) => a.depth - b.depth);
}

function facetsOfOne(
  { lobe, color }: PlottedCurve,
  settings: PaneSettings,
  scale: Scale,
  { place, depth, back }: Projection,
  several: boolean,
): Facet[] {
  if (!lobe) return [];
  const { thetas, phis } = lobe;
  const columns = phis.length;
  const base = rgbOf(computedColor(color));
  // The lamp of the drawing, not of the BRDF: over the left shoulder of who looks.
  const lamp = unit([back[0] + 0.35 * back[1], back[1] - 0.35 * back[0], back[2] + 0.7]);
  const tips: Vec3[] = [];
  for (const [row, theta] of thetas.entries()) {
    for (const [column, phi] of phis.entries()) {
      const value = channelOf(rgbAt(lobe, 3 * (row * columns + column)), lengthChannel(settings.channel));
      const length = Math.min(FARTHEST, scale.position(value));
      const [x, y, z] = direction(Math.cos(radians(theta)), radians(phi));
      tips.push([length * x, length * y, length * z]);
    }
  }
  const facets: Facet[] = [];
  for (let row = 0; row + 1 < thetas.length; row++) {
    for (let column = 0; column < columns; column++) {
      const next = (column + 1) % columns;
      const indices = [
        row * columns + column,
        (row + 1) * columns + column,
        (row + 1) * columns + next,
        row * columns + next,
      ];
      const [a, b, c, d] = indices.map((i) => tips[i]) as [Vec3, Vec3, Vec3, Vec3];
      const corners = [place(a), place(b), place(c), place(d)] as const;
      const area = areaOf(corners);
      // An opaque lobe hides its far side from anybody above the surface.
      if (several ? Math.abs(area) < LEAST_AREA : area < LEAST_AREA) continue;
      const normal = unit(cross(minus(c, a), minus(d, b)));
      const shade = 0.42 + 0.58 * Math.abs(dot(normal, lamp));
      const rgb = settings.channel === 'rgb' ? chromaOf(rgbAt(lobe, 3 * (indices[0] as number))) : base;
      const shaded = rgb.map((value) => Math.round(value * shade)).join(' ');
      // Where the colours are those of the light, a wire tells which lobe is which.
      const wire = settings.channel === 'rgb' ? `rgb(${base.join(' ')} / ${WIRE})` : null;
      facets.push({
        corners,
        color: several ? `rgb(${shaded} / ${TRANSLUCENT})` : `rgb(${shaded})`,
        edge: several ? wire : `rgb(${shaded})`,
        depth: (depth(a) + depth(b) + depth(c) + depth(d)) / 4,
        theta: ((thetas[row] as number) + (thetas[row + 1] as number)) / 2,
        phi: phis[column] as number,
      });
    }
  }
  return facets;
}

function rgbAt({ values }: Lobe, i: number): Rgb {
  return [values[i] as number, values[i + 1] as number, values[i + 2] as number];
}

/** The colour of what is reflected, whatever its strength. */
function chromaOf(rgb: Rgb): readonly number[] {
  const most = Math.max(...rgb, 1e-12);
  return rgb.map((value) => encodeSrgb(value / most));
}

/** Of a quadrangle on the page; negative where it is seen from within the lobe. */
function areaOf([a, b, c, d]: readonly [Point, Point, Point, Point]): number {
  return ((c[1] - a[1]) * (d[0] - b[0]) - (c[0] - a[0]) * (d[1] - b[1])) / 2;
}

const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
function unit(v: Vec3): Vec3 {
  const length = Math.hypot(...v) || 1;
  return [v[0] / length, v[1] / length, v[2] / length];
}
