/** Any view of the bench on any painter, and which angles the pointer is at. */
import { cartesianAngle, drawCartesian } from './cartesian.ts';
import { colors, type Plot, type Probe } from './frame.ts';
import { drawImages, imageProbe } from './image.ts';
import type { Painter, Point } from './painter.ts';
import { drawPolar, polarAngle } from './polar.ts';

export function drawPlot(painter: Painter, plot: Plot): void {
  painter.fill({ x: 0, y: 0, width: painter.width, height: painter.height }, colors.background);
  const { view } = plot.settings;
  if (view === 'polar') drawPolar(painter, plot);
  else if (view === 'image') drawImages(painter, plot);
  else drawCartesian(painter, plot);
}

export function probeAt({ settings, curves }: Plot, width: number, height: number, at: Point): Probe | null {
  if (settings.view === 'image') return imageProbe(curves.length, width, height, at);
  const angle =
    settings.view === 'polar'
      ? polarAngle(width, height, at)
      : cartesianAngle(settings.view, width, height, at);
  return angle === null ? null : { angle };
}
