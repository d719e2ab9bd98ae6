/** What all plots are drawn from, and their common parts. */
import type { Sweep } from '../../../analysis/plots/albedo-sweep.ts';
import { type Channel, channelOf } from '../../../analysis/plots/channel.ts';
import type { Curve, CurvePoint, Reflectance, Rgb } from '../../../analysis/plots/curve.ts';
import type { Lobe } from '../../../analysis/plots/lobe.ts';
import type { Picture } from '../../../analysis/plots/picture.ts';
import { t } from '../../language/language.ts';
import type { Painter, Point, Stroke } from './painter.ts';
import { type BenchView, type PaneSettings, STEEPEST } from './settings.ts';

/** Of the theme (style/tokens.css). */
export const colors = {
  background: 'var(--plot-background)',
  veil: 'var(--plot-veil)',
  grid: 'var(--plot-grid)',
  axis: 'var(--plot-axis)',
  text: 'var(--plot-text)',
  faint: 'var(--plot-faint)',
  guide: 'var(--plot-guide)',
  light: 'var(--plot-light)',
} as const;

const CHANNEL_COLORS = {
  luminance: '',
  red: 'var(--axis-x)',
  green: 'var(--axis-y)',
  blue: 'var(--axis-z)',
} as const;
/** With a line for each channel the colour is the channel's, and dashes tell materials apart. */
const DASHES: readonly (readonly number[])[] = [[], [7, 4], [2, 3], [9, 3, 2, 3], [14, 5]];

export const dashOf = (index: number): readonly number[] => DASHES[index % DASHES.length] ?? [];

/** What a view draws of one subject; a view has the data of its own kind only. */
export interface PlottedCurve {
  readonly id: string;
  readonly name: string;
  readonly color: string;
  readonly index: number;
  readonly f: Reflectance;
  readonly points: Curve;
  /** Exactly what is at an angle, for the probe. */
  at(angle: number): CurvePoint | null;
  readonly sweep: Sweep;
  readonly lobe: Lobe | null;
  readonly picture: Picture | null;
}

/** Where the pointer is, on the view's own axes. */
export interface Probe {
  readonly x: number;
  readonly y?: number;
}

/** A number of the first subject's model, and what it is there. */
export interface SweptParameter {
  readonly name: string;
  readonly min: number;
  readonly max: number;
  readonly value: number;
}

export interface Plot {
  readonly settings: PaneSettings;
  readonly curves: readonly PlottedCurve[];
  readonly probe: Probe | null;
  /** Of the view over a parameter; null where the model has no number. */
  readonly parameter: SweptParameter | null;
}

/** What a drag on the plot can take hold of. */
export type Handle = 'v' | 'l' | 'turn';

export interface Table {
  readonly head: readonly string[];
  /** The numbers that are on the axes. */
  readonly rows: readonly { readonly at: readonly number[]; readonly values: readonly (Rgb | undefined)[] }[];
}

/** One way to look at the subjects. */
export interface View {
  draw(painter: Painter, plot: Plot): void;
  /** Where the pointer is; null beside the plot. */
  probe(plot: Plot, width: number, height: number, at: Point): Probe | null;
  /** The same in words. */
  where(probe: Probe, plot: Plot): string;
  /** What is there. */
  value(curve: PlottedCurve, probe: Probe, plot: Plot): Rgb | undefined;
  /** What a drag that begins there would move. */
  grip?(plot: Plot, width: number, height: number, at: Point): Handle | null;
  /** The settings after that drag came to a point; to turn, after it went so far. */
  drag?(plot: Plot, width: number, height: number, at: Point, handle: Handle): Partial<PaneSettings>;
  /** The settings after an arrow key: to the right, and upwards; in degrees. */
  keys?(settings: PaneSettings, right: number, up: number): Partial<PaneSettings>;
  /** The numbers behind the drawing. */
  table(plot: Plot): Table;
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

const ALBEDOS: readonly BenchView[] = ['albedo', 'sweep'];

export function quantityOf({ view, term, cosine }: PaneSettings): string {
  if (ALBEDOS.includes(view))
    return term === 'BRDF' ? t('directional albedo') : t('directional albedo of {term}', { term });
  if (view === 'fresnel') return t('reflectance');
  const name = term === 'BRDF' ? 'f' : term;
  return cosine ? `${name} · n·l` : `${name} (1/sr)`;
}

export const degrees = (value: number): string => `${value.toFixed(1).replace('-', '−')}°`;

export const turnedViewer = (settings: PaneSettings, right: number): Partial<PaneSettings> => ({
  thetaV: Math.max(0, Math.min(STEEPEST, settings.thetaV + right)),
});

/** Degrees in [0, 360). */
export const wrapped = (angle: number): number => ((angle % 360) + 360) % 360;

/** theta_l in the plane of incidence, negative on the viewer's side; null if l is not in it. */
export function lightInPlane({ thetaL, phiL, phiV }: PaneSettings): number | null {
  const apart = wrapped(phiL - phiV);
  if (thetaL === 0 || Math.abs(apart - 180) < 0.5) return thetaL;
  return apart < 0.5 || apart > 359.5 ? -thetaL : null;
}

export function lightFromPlane(angle: number, { phiV }: PaneSettings): Partial<PaneSettings> {
  return {
    thetaL: Math.min(STEEPEST, Math.abs(tenths(angle))),
    phiL: wrapped(angle < 0 ? phiV : phiV + 180),
  };
}

/** A slice through the plane of incidence, with what stands still in the place of v and what moves in that of l. */
export interface Incidence {
  readonly settings: PaneSettings;
  readonly still: 'v' | 'l';
  readonly moving: 'v' | 'l';
  /** Changes of these settings as changes of the bench's. */
  change(patch: Partial<PaneSettings>): Partial<PaneSettings>;
}

export function incidenceOf(settings: PaneSettings): Incidence {
  if (settings.over === 'light') return { settings, still: 'v', moving: 'l', change: (patch) => patch };
  return { settings: exchanged(settings), still: 'l', moving: 'v', change: exchanged };
}

/** l and v in each other's places. */
function exchanged<Settings extends Partial<PaneSettings>>(settings: Settings): Settings {
  const { thetaL, phiL, thetaV, phiV, ...rest } = settings;
  return {
    ...rest,
    ...(thetaV !== undefined && { thetaL: thetaV }),
    ...(phiV !== undefined && { phiL: phiV }),
    ...(thetaL !== undefined && { thetaV: thetaL }),
    ...(phiL !== undefined && { phiV: phiL }),
  } as Settings;
}

export const handleColor = (handle: 'v' | 'l'): string => (handle === 'l' ? colors.light : colors.guide);

export const tenths = (value: number): number => Math.round(10 * value) / 10;

/** The table of curves over one axis. */
export function curveTable(name: string, { curves }: Plot): Table {
  const angles = new Set(curves.flatMap((curve) => curve.points.map((point) => point.angle)));
  const tables = curves.map(({ points }) => new Map(points.map(({ angle, rgb }) => [angle, rgb])));
  return {
    head: [name],
    rows: [...angles]
      .sort((a, b) => a - b)
      .map((angle) => ({ at: [angle], values: tables.map((table) => table.get(angle)) })),
  };
}
