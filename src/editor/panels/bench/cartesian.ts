/** A plot with the angle to the right and the value upwards. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import { colors, type Plot, quantityOf, strandsOf, valuesOf } from './frame.ts';
import type { Area, Painter, Point } from './painter.ts';
import { type Scale, valueScale } from './scale.ts';
import type { BenchView } from './settings.ts';

const AXES: Readonly<Record<Exclude<BenchView, 'image' | 'polar'>, { label: string; from: number }>> = {
  thetaL: { label: 'θl', from: -90 },
  thetaH: { label: 'θh', from: 0 },
  thetaD: { label: 'θd', from: 0 },
  albedo: { label: 'θv', from: 0 },
};

/** So much room has each label of an angle. */
const LABEL_WIDTH = 38;
const MARGIN = { left: 62, right: 18, top: 14, bottom: 36 };

function cartesianArea(width: number, height: number): Area {
  const { left, right, top, bottom } = MARGIN;
  return {
    x: left,
    y: top,
    width: Math.max(1, width - left - right),
    height: Math.max(1, height - top - bottom),
  };
}

const axisOf = (view: BenchView) => AXES[view as keyof typeof AXES];

/** The angle under the pointer, or null beside the plot. */
export function cartesianAngle(view: BenchView, width: number, height: number, [x, y]: Point): number | null {
  const area = cartesianArea(width, height);
  const part = (x - area.x) / area.width;
  if (part < -0.02 || part > 1.02 || y < area.y || y > area.y + area.height) return null;
  const { from } = axisOf(view);
  return from + (90 - from) * Math.min(1, Math.max(0, part));
}

export function drawCartesian(painter: Painter, plot: Plot): void {
  const { settings, curves, probe } = plot;
  const area = cartesianArea(painter.width, painter.height);
  // An albedo is a share: 1 is always in sight, for a curve above it makes energy.
  const values = settings.view === 'albedo' && !settings.log ? [...valuesOf(plot), 1] : valuesOf(plot);
  const scale = valueScale(values, settings.log, settings.range);
  const { from, label } = axisOf(settings.view);
  const x = (angle: number) => area.x + ((angle - from) / (90 - from)) * area.width;
  const y = (value: number) => area.y + area.height * (1 - scale.position(value));

  drawGrid(painter, area, scale, x, from);
  const middle = area.y + area.height / 2;
  painter.text(label, [area.x + area.width, painter.height - 9], { color: colors.text, align: 'right' });
  painter.text(quantityOf(settings), [12, middle], { color: colors.text, align: 'center', turn: -90 });

  painter.clip({ ...area, y: area.y - 4, height: area.height + 8 }, () => {
    const bottom = area.y + area.height;
    if (settings.view === 'albedo') {
      painter.line(
        [
          [area.x, y(1)],
          [area.x + area.width, y(1)],
        ],
        { color: colors.faint, dash: [4, 4] },
      );
    }
    if (settings.view === 'thetaL') {
      for (const angle of [settings.thetaV, -settings.thetaV]) {
        const dash = angle < 0 || settings.thetaV === 0 ? [] : [3, 4];
        painter.line(
          [
            [x(angle), area.y],
            [x(angle), bottom],
          ],
          { color: colors.faint, dash },
        );
      }
    }
    if (probe)
      painter.line(
        [
          [x(probe.angle), area.y],
          [x(probe.angle), bottom],
        ],
        { color: colors.axis },
      );
    for (const curve of curves) {
      for (const { channel, stroke } of strandsOf(curve, settings.channel)) {
        painter.line(
          curve.points.map(({ angle, rgb }) => [x(angle), y(channelOf(rgb, channel))]),
          stroke,
        );
        const under = probe && curve.at(probe.angle);
        if (under) painter.disc([x(under.angle), y(channelOf(under.rgb, channel))], 3.5, stroke.color);
      }
    }
  });
  if (settings.view === 'thetaL') {
    painter.text('v', [x(-settings.thetaV) + 5, area.y + 7], { color: colors.guide });
    if (settings.thetaV > 0)
      painter.text('mirror', [x(settings.thetaV) + 5, area.y + 7], { color: colors.faint });
  }
}

function drawGrid(
  painter: Painter,
  area: Area,
  scale: Scale,
  x: (angle: number) => number,
  from: number,
): void {
  const bottom = area.y + area.height;
  for (const { at, label } of scale.ticks) {
    const level = Math.round(bottom - at * area.height) + 0.5;
    painter.line(
      [
        [area.x, level],
        [area.x + area.width, level],
      ],
      { color: at === 0 ? colors.axis : colors.grid },
    );
    painter.text(label, [area.x - 7, level], { color: colors.faint, align: 'right' });
  }
  const perDegree = area.width / (90 - from);
  const step = [10, 15].find((degrees) => degrees * perDegree >= LABEL_WIDTH) ?? 30;
  for (let angle = Math.ceil(from / step) * step; angle <= 90; angle += step) {
    const at = Math.round(x(angle)) + 0.5;
    painter.line(
      [
        [at, area.y],
        [at, bottom],
      ],
      { color: angle === 0 ? colors.axis : colors.grid },
    );
    painter.text(`${angle}°`.replace('-', '−'), [at, bottom + 11], { color: colors.faint, align: 'center' });
  }
}
