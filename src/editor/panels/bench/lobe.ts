/** The lobe over the hemisphere of light directions, for one viewer; it can be turned. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import { radians } from '../../../analysis/plots/curve.ts';
import { direction, type Vec3 } from '../../../analysis/vector.ts';
import { colors, degrees, type Handle, type Plot, quantityOf, tenths, type View, wrapped } from './frame.ts';
import { type Facet, facetsOf, lobeValues } from './lobe-mesh.ts';
import type { Painter, Point } from './painter.ts';
import { type Projection, projectionOf } from './projection.ts';
import { type Scale, valueScale } from './scale.ts';
import { type PaneSettings, STEEPEST } from './settings.ts';

/** Handles stand outside of the hemisphere, where no lobe hides them. */
const HANDLE = 1.06;
const REACH = 14;
/** Degrees for a pixel of a drag. */
const TURN = 0.5;

const vectorOf = (theta: number, phi: number): Vec3 => direction(Math.cos(radians(theta)), radians(phi));
const times = (p: Vec3, length: number): Vec3 => [p[0] * length, p[1] * length, p[2] * length];

const projection = ({ settings }: Plot, width: number, height: number) =>
  projectionOf(width, height, settings.azimuth, settings.elevation);

const scaleOf = ({ curves, settings }: Plot): Scale =>
  valueScale(
    curves.flatMap((curve) => lobeValues(curve, settings)),
    settings.log,
    settings.range,
  );

export const lobeView: View = {
  draw: drawLobes,
  probe(plot, width, height, at) {
    const facets = facetsOf(plot.curves, plot.settings, scaleOf(plot), projection(plot, width, height));
    const hit = facets.findLast(({ corners }) => contains(corners, at));
    return hit ? { x: hit.theta, y: hit.phi / 360 } : null;
  },
  where: ({ x, y = 0 }) => `θl ${degrees(x)}   φl ${degrees(360 * y)}`,
  value: ({ f }, { x, y = 0 }, { settings }) => {
    const l = vectorOf(x, 360 * y);
    const rgb = f(l, vectorOf(settings.thetaV, settings.phiV));
    return settings.cosine ? times(rgb, l[2]) : rgb;
  },
  grip(plot, width, height, at) {
    const { place } = projection(plot, width, height);
    const near = (p: Vec3) => {
      const [x, y] = place(times(p, HANDLE));
      return Math.hypot(at[0] - x, at[1] - y) < REACH;
    };
    const { thetaV, phiV, thetaL, phiL } = plot.settings;
    if (near(vectorOf(thetaV, phiV))) return 'v';
    return near(vectorOf(thetaL, phiL)) ? 'l' : 'turn';
  },
  drag: (plot, width, height, at, handle) => moved(plot, projection(plot, width, height), at, handle),
  keys: ({ azimuth, elevation }, right, up) => ({
    azimuth: wrapped(azimuth + 5 * right),
    elevation: Math.max(0, Math.min(90, elevation + 5 * up)),
  }),
  table({ curves }) {
    const [lobe] = curves.map((curve) => curve.lobe);
    const rows = (lobe?.thetas ?? []).flatMap((theta, row) =>
      (lobe?.phis ?? []).map((phi, column) => ({
        at: [theta, phi],
        values: curves.map(({ lobe: other }) => {
          const i = 3 * (row * (lobe?.phis.length ?? 0) + column);
          if (other?.values.length !== lobe?.values.length) return undefined;
          const [r = 0, g = 0, b = 0] = other?.values.subarray(i, i + 3) ?? [];
          return [r, g, b] as const;
        }),
      })),
    );
    return { head: ['theta_l_deg', 'phi_l_deg'], rows };
  },
};

/** Turning is by the way that the pointer went: `at` is then a difference. */
function moved({ settings }: Plot, view: Projection, at: Point, handle: Handle): Partial<PaneSettings> {
  if (handle === 'turn') {
    return {
      azimuth: wrapped(settings.azimuth - TURN * at[0]),
      elevation: Math.max(0, Math.min(90, settings.elevation + TURN * at[1])),
    };
  }
  const [theta, phi] = handle === 'v' ? [settings.thetaV, settings.phiV] : [settings.thetaL, settings.phiL];
  const nearer = view.depth(vectorOf(theta, phi)) >= 0;
  const to = view.direction(at, HANDLE, nearer);
  const [newTheta, newPhi] = [Math.min(STEEPEST, tenths(to.theta)), tenths(to.phi)];
  return handle === 'v' ? { thetaV: newTheta, phiV: newPhi } : { thetaL: newTheta, phiL: newPhi };
}

function drawLobes(painter: Painter, plot: Plot): void {
  const { settings, curves, probe } = plot;
  const view = projection(plot, painter.width, painter.height);
  const scale = scaleOf(plot);
  drawFloor(painter, view, scale);
  drawHemisphere(painter, view, false);
  const v = vectorOf(settings.thetaV, settings.phiV);
  const l = vectorOf(settings.thetaL, settings.phiL);
  const mirror: Vec3 = [-v[0], -v[1], v[2]];
  const origin = view.place([0, 0, 0]);
  painter.line([origin, view.place([0, 0, 1])], { color: colors.axis });
  painter.line([origin, view.place(times(mirror, HANDLE))], { color: colors.faint, dash: [3, 4] });
  painter.line([origin, view.place(times(v, HANDLE))], { color: colors.guide, width: 1.5 });
  painter.line([origin, view.place(times(l, HANDLE))], { color: colors.light, width: 1.5 });
  for (const { corners, color, edge } of facetsOf(curves, settings, scale, view))
    painter.polygon(corners, color, edge);
  drawHemisphere(painter, view, true);
  drawTip(painter, view, l, 'l', colors.light);
  drawTip(painter, view, v, 'v', colors.guide);
  painter.text('n', plus(view.place([0, 0, 1]), [6, -8]), { color: colors.faint });
  painter.text(quantityOf(settings), [14, 14], { color: colors.text });
  if (probe) drawProbe(painter, plot, view, scale);
}

const plus = ([x, y]: Point, [dx, dy]: Point): Point => [x + dx, y + dy];

function drawTip(painter: Painter, view: Projection, p: Vec3, name: string, color: string): void {
  const tip = view.place(times(p, HANDLE));
  const [x0, y0] = view.place([0, 0, 0]);
  const [dx, dy] = [tip[0] - x0, tip[1] - y0];
  const length = Math.hypot(dx, dy) || 1;
  painter.disc(tip, 4.5, color);
  painter.text(name, plus(tip, [(12 * dx) / length, (12 * dy) / length]), { color, align: 'center' });
}

const circle = (radius: number, height: number, from = 0, to = 360): Vec3[] =>
  Array.from({ length: 73 }, (_, i) => {
    const phi = radians(from + ((to - from) * i) / 72);
    return [radius * Math.cos(phi), radius * Math.sin(phi), height];
  });

/** The surface, with a ring for each value that has a line. */
function drawFloor(painter: Painter, view: Projection, scale: Scale): void {
  for (let phi = 0; phi < 180; phi += 30) {
    const [x, y] = [Math.cos(radians(phi)), Math.sin(radians(phi))];
    painter.line([view.place([x, y, 0]), view.place([-x, -y, 0])], { color: colors.grid });
  }
  painter.line([view.place([0, 0, 0]), view.place([1, 0, 0])], { color: colors.axis, width: 1.5 });
  painter.text('x', view.place([1.06, 0, 0]), { color: colors.faint, align: 'center' });
  let lowest = Number.NEGATIVE_INFINITY;
  for (const { at, label } of scale.ticks) {
    if (at <= 0) continue;
    painter.line(circle(at, 0).map(view.place), { color: at > 0.99 ? colors.axis : colors.grid });
    // On the side that is nearest to who looks, where nothing stands in the way.
    const out = Math.hypot(view.back[0], view.back[1]) || 1;
    const [bx, by] = [view.back[0] / out, view.back[1] / out];
    const place = view.place([at * bx, at * by, 0]);
    if (view.radius * at * view.back[2] > 8 && place[1] - lowest > 11) {
      lowest = place[1];
      painter.text(label, plus(place, [0, 8]), { color: colors.faint, align: 'center' });
    }
  }
}

/** Lines of equal theta and phi on the unit hemisphere: behind the lobes, or, fainter, before them. */
function drawHemisphere(painter: Painter, view: Projection, front: boolean): void {
  const color = front ? 'var(--tint-strong)' : colors.grid;
  const lines: Vec3[][] = [circle(1, 0)];
  for (const theta of [30, 60]) lines.push(circle(Math.sin(radians(theta)), Math.cos(radians(theta))));
  for (let phi = 0; phi < 360; phi += 45) {
    lines.push(Array.from({ length: 31 }, (_, i) => vectorOf(3 * i, phi)));
  }
  for (const line of lines) {
    let run: Point[] = [];
    const finish = () => {
      if (run.length > 1) painter.line(run, { color });
      run = [];
    };
    for (const p of line) {
      if (view.depth(p) >= 0 === front) run.push(view.place(p));
      else finish();
    }
    finish();
  }
}

function drawProbe(painter: Painter, plot: Plot, view: Projection, scale: Scale): void {
  const { x = 0, y = 0 } = plot.probe ?? {};
  const channel = plot.settings.channel === 'rgb' ? 'luminance' : plot.settings.channel;
  for (const curve of plot.curves) {
    const rgb = lobeView.value(curve, { x, y }, plot);
    if (!rgb) continue;
    const tip = times(vectorOf(x, 360 * y), Math.min(1.35, scale.position(channelOf(rgb, channel))));
    painter.disc(view.place(tip), 3, 'var(--plot-exact)');
  }
}

function contains(corners: Facet['corners'], [x, y]: Point): boolean {
  let inside = false;
  for (const [i, [xi, yi]] of corners.entries()) {
    const [xj, yj] = corners.at(i - 1) as Point;
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) inside = !inside;
  }
  return inside;
}
