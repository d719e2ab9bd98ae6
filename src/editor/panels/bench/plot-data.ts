/** From subjects to what is drawn: slices at once, the rest as far as the worker has come. */

import type { Curve, CurvePoint, Reflectance } from '../../../analysis/plots/curve.ts';
import { differenceSlice, differenceSliceAt } from '../../../analysis/plots/difference-slice.ts';
import { halfSlice, halfSliceAt } from '../../../analysis/plots/half-slice.ts';
import { lightSlice, lightSliceAt } from '../../../analysis/plots/light-slice.ts';
import type { Background } from './background.ts';
import type { PlottedCurve } from './frame.ts';
import type { Evaluators, Subject } from './series.ts';
import type { BenchSettings } from './settings.ts';

export interface PlotData {
  readonly curves: readonly PlottedCurve[];
  /** Of what the worker is at; 1 when there is nothing to wait for. */
  readonly progress: number;
}

export function plotData(
  subjects: readonly Subject[],
  settings: BenchSettings,
  evaluators: Evaluators,
  background: Background,
): PlotData {
  const curves: PlottedCurve[] = [];
  const parts: number[] = [];
  for (const [index, subject] of subjects.entries()) {
    if (settings.solo !== null && settings.solo !== subject.id) continue;
    const f = reflectanceOf(evaluators, subject, settings.term);
    if (!f) continue;
    const { id, name, color } = subject;
    const common = { id, name, color, index };
    if (settings.view === 'albedo' || settings.view === 'image') {
      const { view, phiV, cosine } = settings;
      const task = view === 'albedo' ? ({ kind: view, phiV } as const) : ({ kind: view, cosine } as const);
      const result = background.ask(subject, settings.term, task);
      parts.push(result?.progress ?? 0);
      const points = result?.curve ?? [];
      curves.push({
        ...common,
        points,
        image: result?.image ?? null,
        f,
        at: (angle) => between(points, angle),
      });
    } else curves.push({ ...common, image: null, f, ...slice(f, settings) });
  }
  return { curves, progress: parts.length ? parts.reduce((a, b) => a + b) / parts.length : 1 };
}

function reflectanceOf(evaluators: Evaluators, subject: Subject, term: string): Reflectance | null {
  try {
    return evaluators.reflectance(subject, term);
  } catch {
    // As in termsOf(): a model that cannot be evaluated is reported where it is edited.
    return null;
  }
}

function slice(
  f: Reflectance,
  settings: BenchSettings,
): { points: Curve; at: (angle: number) => CurvePoint | null } {
  const options = { ...settings, phiH: settings.phiV };
  switch (settings.view) {
    case 'thetaH':
      return { points: halfSlice(f, options), at: (angle) => halfSliceAt(f, angle, options) };
    case 'thetaD':
      return { points: differenceSlice(f, options), at: (angle) => differenceSliceAt(f, angle, options) };
    default:
      return { points: lightSlice(f, options), at: (angle) => lightSliceAt(f, angle, options) };
  }
}

/** On the straight line between the neighbours, as it is drawn. */
function between(points: Curve, angle: number): CurvePoint | null {
  const next = points.findIndex((point) => point.angle >= angle);
  const [a, b] = [points[next - 1], points[next]];
  if (b?.angle === angle) return b;
  if (!a || !b) return null;
  const part = (angle - a.angle) / (b.angle - a.angle);
  const mix = (i: 0 | 1 | 2) => a.rgb[i] + part * (b.rgb[i] - a.rgb[i]);
  return { angle, rgb: [mix(0), mix(1), mix(2)] };
}
