/** From subjects to what is drawn: slices at once, the rest as far as the workers have come. */
import { azimuthSlice, azimuthSliceAt } from '../../../analysis/plots/azimuth-slice.ts';
import type { Curve, CurvePoint, Reflectance } from '../../../analysis/plots/curve.ts';
import { differenceSlice, differenceSliceAt } from '../../../analysis/plots/difference-slice.ts';
import { halfSlice, halfSliceAt } from '../../../analysis/plots/half-slice.ts';
import { lightSlice, lightSliceAt } from '../../../analysis/plots/light-slice.ts';
import type { TriangleMesh } from '../../../analysis/plots/surface.ts';
import { viewerSlice, viewerSliceAt } from '../../../analysis/plots/viewer-slice.ts';
import type { Background } from './background.ts';
import { between } from './between.ts';
import type { PlottedCurve, SweptParameter } from './frame.ts';
import type { Result, Task } from './jobs.ts';
import { azimuthOptions, imageOptions, lightOptions, litOptions } from './plot-options.ts';
import type { Evaluators, Subject, SubjectReflectance } from './series.ts';
import type { PaneSettings } from './settings.ts';
import { substanceCurves } from './substance-curves.ts';

/** The same one always, by which a pane sees that nothing has changed. */
const EMPTY: readonly never[] = [];

export interface PlotData {
  readonly curves: readonly PlottedCurve[];
  /** Of what the workers are at; 1 when there is nothing to wait for. */
  readonly progress: number;
}

export interface PlotSources {
  readonly evaluators: Evaluators;
  readonly background: Background;
  /** The shape of the lit object; null while there is none. */
  readonly mesh: () => TriangleMesh | null;
  readonly parameter: SweptParameter | null;
  /** Whether the points of slices, too, are to be in float64. */
  readonly exact: boolean;
}

export function plotData(
  subjects: readonly Subject[],
  settings: PaneSettings,
  sources: PlotSources,
): PlotData {
  if (settings.view === 'fresnel') return { curves: substanceCurves(settings.substance), progress: 1 };
  const curves: PlottedCurve[] = [];
  const parts: number[] = [];
  const task = taskOf(settings, sources);
  for (const [index, subject] of subjects.entries()) {
    if (settings.solo !== null && settings.solo !== subject.id) continue;
    const functions = reflectanceOf(sources.evaluators, subject, settings.term);
    if (!functions) continue;
    const { exact: f, quick } = functions;
    const { id, name, color } = subject;
    const common = { id, name, color, index, f, sweep: EMPTY, lobe: null, picture: null };
    if (!task) {
      // A probe reads one value, a file is read to the last digit; a curve of some hundred points is looked at.
      const points = slice(sources.exact ? f : quick, settings);
      curves.push({ ...common, points, at: (angle) => sliceAt(f, angle, settings) });
      continue;
    }
    const result = sources.background.ask(subject, settings.term, task);
    parts.push(result?.progress ?? 0);
    curves.push({ ...common, ...partsOf(result) });
  }
  return { curves, progress: parts.length ? parts.reduce((a, b) => a + b) / parts.length : 1 };
}

/** What a view asks the workers for; null if it is computed at once, or cannot be. */
function taskOf(settings: PaneSettings, { background, mesh, parameter }: PlotSources): Task | null {
  const { view: kind, phiV } = settings;
  switch (kind) {
    case 'albedo':
      return { kind, phiV };
    case 'sweep': {
      if (!parameter) return null;
      const { name, min, max } = parameter;
      return { kind, parameter: name, min, max, phiV };
    }
    case 'image':
      return { kind, options: imageOptions(settings) };
    case 'map':
      return { kind, options: azimuthOptions(settings) };
    case 'lobe':
      return { kind, options: lightOptions(settings) };
    case 'sphere':
      return { kind, options: litOptions(settings) };
    case 'object': {
      const triangles = mesh();
      return triangles && { kind, mesh: background.shape(triangles), options: litOptions(settings) };
    }
    default:
      return null;
  }
}

type Parts = Pick<PlottedCurve, 'points' | 'at' | 'sweep' | 'lobe' | 'picture'>;

function partsOf(result: Result | null): Parts {
  const { sweep = EMPTY, lobe = null, picture = null } = result ?? {};
  // The probe over a parameter reads the first angle's line.
  const first = sweep.map(({ value, albedos }) => ({ angle: value, rgb: albedos[0] ?? [0, 0, 0] }));
  const points = result?.curve ?? EMPTY;
  const line = sweep.length ? first : points;
  return { points, sweep, lobe, picture, at: (angle) => between(line, angle) };
}

function reflectanceOf(evaluators: Evaluators, subject: Subject, term: string): SubjectReflectance | null {
  try {
    return evaluators.reflectance(subject, term);
  } catch {
    // As in termsOf(): a model that cannot be evaluated is reported where it is edited.
    return null;
  }
}

/** Panes are drawn again when any part of another pane comes: what did not change is not computed again. */
const slices = new WeakMap<Reflectance, Map<string, Curve>>();
const MOST_SLICES = 24;

function slice(f: Reflectance, settings: PaneSettings): Curve {
  const { view, over, thetaV, phiV, thetaL, phiL, thetaH, thetaD, turns, cosine } = settings;
  const key = JSON.stringify([view, over, thetaV, phiV, thetaL, phiL, thetaH, thetaD, turns, cosine]);
  const known = slices.get(f) ?? new Map<string, Curve>();
  slices.set(f, known);
  const kept = known.get(key);
  if (kept) return kept;
  if (known.size >= MOST_SLICES) known.clear();
  const fresh = computeSlice(f, settings);
  known.set(key, fresh);
  return fresh;
}

function computeSlice(f: Reflectance, settings: PaneSettings): Curve {
  const options = { ...settings, phiH: settings.phiV };
  switch (settings.view) {
    case 'polar':
    case 'thetaL':
      return settings.over === 'viewer' ? viewerSlice(f, options) : lightSlice(f, options);
    case 'thetaH':
      return halfSlice(f, options);
    case 'thetaD':
      return differenceSlice(f, options);
    case 'phi':
    case 'azimuth':
      return azimuthSlice(f, azimuthOptions(settings));
    default:
      return EMPTY;
  }
}

function sliceAt(f: Reflectance, angle: number, settings: PaneSettings): CurvePoint | null {
  const options = { ...settings, phiH: settings.phiV };
  switch (settings.view) {
    case 'polar':
    case 'thetaL':
      return settings.over === 'viewer' ? viewerSliceAt(f, angle, options) : lightSliceAt(f, angle, options);
    case 'thetaH':
      return halfSliceAt(f, angle, options);
    case 'thetaD':
      return differenceSliceAt(f, angle, options);
    case 'phi':
    case 'azimuth':
      return azimuthSliceAt(f, angle, azimuthOptions(settings));
    default:
      return null;
  }
}
