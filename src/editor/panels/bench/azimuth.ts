/** The slice over the azimuth as one sees it from above: the tangent to the right, the normal towards the reader. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import { type Rgb, radians } from '../../../analysis/plots/curve.ts';
import { t } from '../../language/language.ts';
import {
  colors,
  curveTable,
  degrees,
  type Plot,
  quantityOf,
  strandsOf,
  type View,
  valuesOf,
  wrapped,
} from './frame.ts';
import type { Painter, Point } from './painter.ts';
import { valueScale } from './scale.ts';

/** Values beyond the axis end here. */
const FARTHEST = 1.15;

interface Disc {
  readonly center: Point;
  readonly radius: number;
}

function discOf(width: number, height: number): Disc {
  return { center: [width / 2, height / 2], radius: Math.max(20, Math.min(height / 2 - 26, width / 2 - 44)) };
}

function pointAt({ center, radius }: Disc, phi: number, part: number): Point {
  const [c, s] = [Math.cos(radians(phi)), Math.sin(radians(phi))];
  return [center[0] + radius * part * c, center[1] - radius * part * s];
}

const symbol = ({ settings }: Plot) => (settings.turns === 'half' ? 'φh' : 'φl');

export const azimuthView: View = {
  draw: drawAzimuth,
  probe(_plot, width, height, [x, y]) {
    const { center, radius } = discOf(width, height);
    const [dx, dy] = [x - center[0], center[1] - y];
    const distance = Math.hypot(dx, dy);
    if (distance < 4 || distance > radius + 26) return null;
    return { x: wrapped((Math.atan2(dy, dx) * 180) / Math.PI) };
  },
  where: ({ x }, plot) => `${symbol(plot)} ${degrees(x)}`,
  value: (curve, { x }) => curve.at(x)?.rgb,
  table: (plot) => curveTable(plot.settings.turns === 'half' ? 'phi_h_deg' : 'phi_l_deg', plot),
};

function drawAzimuth(painter: Painter, plot: Plot): void {
  const { settings, curves, probe } = plot;
  const disc = discOf(painter.width, painter.height);
  const scale = valueScale(valuesOf(plot), settings.log, settings.range);
  const at = (phi: number, part: number) => pointAt(disc, phi, part);
  const ring = (part: number) => Array.from({ length: 121 }, (_, i) => at(3 * i, part));

  for (let phi = 0; phi < 360; phi += 30) {
    painter.line([disc.center, at(phi, 1)], { color: phi % 90 === 0 ? colors.axis : colors.grid });
    const align = phi === 90 || phi === 270 ? 'center' : phi > 90 && phi < 270 ? 'right' : 'left';
    painter.text(`${phi}°`, at(phi, 1 + 10 / disc.radius), { color: colors.faint, align });
  }
  painter.line(ring(1), { color: colors.grid });
  for (const { at: part } of scale.ticks) if (part > 0) painter.line(ring(part), { color: colors.grid });
  painter.text(quantityOf(settings), [14, 14], { color: colors.text });
  painter.text(t('over {symbol}', { symbol: symbol(plot) }), [14, 30], { color: colors.faint });
  if (settings.turns === 'light') {
    painter.disc(at(settings.phiV, 1), 4, colors.guide);
    painter.text('v', at(settings.phiV + 6, 1 - 10 / disc.radius), { color: colors.guide, align: 'center' });
  }
  if (probe) painter.line([disc.center, at(probe.x, 1)], { color: colors.axis });
  for (const curve of curves) {
    for (const { channel, stroke } of strandsOf(curve, settings.channel)) {
      const place = (phi: number, rgb: Rgb) =>
        at(phi, Math.min(FARTHEST, scale.position(channelOf(rgb, channel))));
      painter.line(
        curve.points.map(({ angle, rgb }) => place(angle, rgb)),
        stroke,
      );
      const under = probe && curve.at(probe.x);
      if (under) painter.disc(place(under.angle, under.rgb), 3.5, stroke.color);
    }
  }
  for (const { at: part, label } of scale.ticks) {
    const [x, y] = at(0, part);
    if (part > 0) painter.text(label, [x - 4, y + 9], { color: colors.faint, align: 'right' });
  }
}
