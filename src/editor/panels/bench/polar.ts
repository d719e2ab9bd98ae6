/** The slice in the plane of incidence as one sees it from the side: the surface below, the normal upwards. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import {
  colors,
  curveTable,
  degrees,
  handleColor,
  incidenceOf,
  lightFromPlane,
  lightInPlane,
  type Plot,
  quantityOf,
  strandsOf,
  tenths,
  turnedViewer,
  type View,
  valuesOf,
} from './frame.ts';
import type { Painter, Point } from './painter.ts';
import { valueScale } from './scale.ts';
import { STEEPEST } from './settings.ts';

interface Fan {
  readonly center: Point;
  readonly radius: number;
}

/** How near to a handle a drag takes hold of it, CSS pixels. */
const REACH = 14;

function fanOf(width: number, height: number): Fan {
  const radius = Math.max(20, Math.min(height - 58, width / 2 - 40));
  const free = Math.max(0, height - 58 - radius);
  return { center: [width / 2, height - 30 - free / 2], radius };
}

function pointAt({ center, radius }: Fan, angle: number, part: number): Point {
  const theta = (angle * Math.PI) / 180;
  return [center[0] + radius * part * Math.sin(theta), center[1] - radius * part * Math.cos(theta)];
}

/** The angle under the pointer of what moves, negative on the side of what stands still; null beside the plot. */
function angleUnder(width: number, height: number, [x, y]: Point): number | null {
  const { center, radius } = fanOf(width, height);
  const [dx, dy] = [x - center[0], center[1] - y];
  const distance = Math.hypot(dx, dy);
  if (distance < 4 || distance > radius + 26 || dy < -10) return null;
  return Math.max(-90, Math.min(90, (Math.atan2(dx, dy) * 180) / Math.PI));
}

export const polarView: View = {
  draw: drawPolar,
  probe(_plot, width, height, at) {
    const x = angleUnder(width, height, at);
    return x === null ? null : { x };
  },
  where: ({ x }, { settings }) => `θ${incidenceOf(settings).moving} ${degrees(x)}`,
  value: (curve, { x }) => curve.at(x)?.rgb,
  grip(plot, width, height, at) {
    if (angleUnder(width, height, at) === null) return null;
    const { settings, still, moving } = incidenceOf(plot.settings);
    const angle = lightInPlane(settings);
    const [x, y] = pointAt(fanOf(width, height), angle ?? 0, 1);
    return angle !== null && Math.hypot(at[0] - x, at[1] - y) < REACH ? moving : still;
  },
  drag(plot, width, height, at, handle) {
    const angle = angleUnder(width, height, at);
    if (angle === null) return {};
    const { settings, moving, change } = incidenceOf(plot.settings);
    if (handle === moving) return change(lightFromPlane(angle, settings));
    return change({ thetaV: Math.min(STEEPEST, tenths(Math.abs(angle))) });
  },
  keys(settings, right) {
    const seen = incidenceOf(settings);
    return seen.change(turnedViewer(seen.settings, right));
  },
  table: (plot) => curveTable(`theta_${incidenceOf(plot.settings).moving}_deg`, plot),
};

function drawPolar(painter: Painter, plot: Plot): void {
  const { curves, probe } = plot;
  const { settings, still, moving } = incidenceOf(plot.settings);
  const fan = fanOf(painter.width, painter.height);
  const { center, radius } = fan;
  const scale = valueScale(valuesOf(plot), settings.log, settings.range);
  const at = (angle: number, part: number): Point => pointAt(fan, angle, part);
  const arc = (part: number) => Array.from({ length: 91 }, (_, i) => at(-90 + 2 * i, part));

  for (let angle = -90; angle <= 90; angle += 15) {
    const flat = Math.abs(angle) === 90;
    painter.line([center, at(angle, 1)], { color: flat || angle === 0 ? colors.axis : colors.grid });
    const label = `${Math.abs(angle)}°`;
    const align = angle < -20 ? 'right' : angle > 20 ? 'left' : 'center';
    if (angle % 30 === 0 || radius > 150) {
      painter.text(label, at(angle, 1 + 10 / radius), { color: colors.faint, align });
    }
  }
  painter.line(arc(1), { color: colors.grid });
  for (const { at: part, label } of scale.ticks) {
    if (part <= 0) continue;
    painter.line(arc(part), { color: colors.grid });
    const [x, y] = at(90, part);
    painter.text(label, [x, y + 15], { color: colors.faint, align: 'center' });
  }
  painter.text(quantityOf(settings), [14, 14], { color: colors.text });

  painter.line([center, at(settings.thetaV, 1)], { color: colors.faint, dash: [3, 4] });
  const color = handleColor(still);
  painter.line([center, at(-settings.thetaV, 1)], { color });
  painter.disc(at(-settings.thetaV, 1), 4, color);
  painter.text(still, at(-settings.thetaV - 4, 1 - 14 / radius), { color, align: 'center' });
  const light = lightInPlane(settings);
  if (light !== null) {
    painter.disc(at(light, 1), 4, handleColor(moving));
    painter.text(moving, at(light + 4, 1 - 14 / radius), { color: handleColor(moving), align: 'center' });
  }
  if (probe) painter.line([center, at(probe.x, 1)], { color: colors.axis });

  painter.clip({ x: 0, y: 0, width: painter.width, height: center[1] + 1 }, () => {
    for (const curve of curves) {
      for (const { channel, stroke } of strandsOf(curve, settings.channel)) {
        const place = (angle: number, rgb: readonly [number, number, number]) =>
          at(angle, Math.min(1.5, scale.position(channelOf(rgb, channel))));
        painter.line(
          curve.points.map(({ angle, rgb }) => place(angle, rgb)),
          stroke,
        );
        const under = probe && curve.at(probe.x);
        if (under) painter.disc(place(under.angle, under.rgb), 3.5, stroke.color);
      }
    }
  });
}
