/** What all plots are drawn from, and their common parts. */
import { type Channel, channelOf } from '../../../analysis/plots/channel.ts';
import type { Curve, CurvePoint, Reflectance } from '../../../analysis/plots/curve.ts';
import type { ImageSlice } from '../../../analysis/plots/image-slice.ts';
import type { Stroke } from './painter.ts';
import type { BenchSettings } from './settings.ts';

export const colors = {
  background: '#141619',
  grid: '#262a30',
  axis: '#3a3e46',
  text: '#959ba5',
  faint: '#737984',
  guide: '#b9bec7',
} as const;

const CHANNEL_COLORS = { luminance: '', red: '#e5766f', green: '#85bd6b', blue: '#6b9fe6' } as const;
/** With a line for each channel the colour is the channel's, and dashes tell materials apart. */
const DASHES: readonly (readonly number[])[] = [[], [7, 4], [2, 3], [9, 3, 2, 3], [14, 5]];

export const dashOf = (index: number): readonly number[] => DASHES[index % DASHES.length] ?? [];

export interface PlottedCurve {
  readonly id: string;
  readonly name: string;
  readonly color: string;
  readonly index: number;
  readonly points: Curve;
  readonly image: ImageSlice | null;
  readonly f: Reflectance;
  /** Exactly what is at an angle, for the probe. */
  at(angle: number): CurvePoint | null;
}

export interface Probe {
  /** Of the plot's own axis, degrees; theta_h in the image slice. */
  readonly angle: number;
  /** In the image slice, the part of its height from the bottom. */
  readonly y?: number;
}

export interface Plot {
  readonly settings: BenchSettings;
  readonly curves: readonly PlottedCurve[];
  readonly probe: Probe | null;
}

export interface Strand {
  readonly channel: Channel;
  readonly stroke: Stroke;
}

export function strandsOf(curve: PlottedCurve, channel: Channel | 'rgb'): Strand[] {
  if (channel !== 'rgb') return [{ channel, stroke: { color: curve.color, width: 1.75 } }];
  return (['red', 'green', 'blue'] as const).map((each) => ({
    channel: each,
    stroke: { color: CHANNEL_COLORS[each], width: 1.5, dash: dashOf(curve.index) },
  }));
}

export function valuesOf({ curves, settings }: Plot): number[] {
  return curves.flatMap((curve) =>
    strandsOf(curve, settings.channel).flatMap(({ channel }) =>
      curve.points.map((point) => channelOf(point.rgb, channel)),
    ),
  );
}

export function quantityOf({ view, term, cosine }: BenchSettings): string {
  if (view === 'albedo') return term === 'BRDF' ? 'directional albedo' : `directional albedo of ${term}`;
  const name = term === 'BRDF' ? 'f' : term;
  return cosine ? `${name} · n·l` : `${name} (1/sr)`;
}
