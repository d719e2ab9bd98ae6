/** Plots with an angle or a parameter to the right and the value upwards. */
import { sweepAngles } from '../../../analysis/plots/albedo-sweep.ts';
import { channelOf } from '../../../analysis/plots/channel.ts';
import type { Curve } from '../../../analysis/plots/curve.ts';
import { t } from '../../language/language.ts';
import {
  colors,
  curveTable,
  dashOf,
  degrees,
  handleColor,
  incidenceOf,
  lightFromPlane,
  lightInPlane,
  type Plot,
  type PlottedCurve,
  quantityOf,
  strandsOf,
  tenths,
  turnedViewer,
  type View,
} from './frame.ts';
import type { Area, Painter, Point } from './painter.ts';
import { type Scale, shortNumber, valueScale } from './scale.ts';
import { STEEPEST } from './settings.ts';

interface Axis {
  readonly label: string;
  readonly from: number;
  readonly to: number;
  /** Distances between two lines, the closest first; the first that has room for its labels is taken. */
  readonly steps: readonly number[];
  text(value: number): string;
}

/** So much room has each label of the axis. */
const LABEL_WIDTH = 38;
const MARGIN = { left: 62, right: 18, top: 14, bottom: 36 };
const REACH = 10;

function areaOf(width: number, height: number): Area {
  const { left, right, top, bottom } = MARGIN;
  return {
    x: left,
    y: top,
    width: Math.max(1, width - left - right),
    height: Math.max(1, height - top - bottom),
  };
}

const angleText = (angle: number) => `${angle}°`.replace('-', '−');

function axisOf({ settings, parameter }: Plot): Axis {
  const quarter = { from: 0, to: 90, steps: [10, 15, 30], text: angleText };
  const turn = { from: 0, to: 360, steps: [30, 45, 90], text: angleText };
  switch (settings.view) {
    case 'thetaH':
      return { ...quarter, label: 'θh' };
    case 'thetaD':
      return { ...quarter, label: 'θd' };
    case 'albedo':
      return { ...quarter, label: 'θv' };
    case 'fresnel':
      return { ...quarter, label: 'θi' };
    case 'phi':
      return { ...turn, label: settings.turns === 'half' ? 'φh' : 'φl' };
    case 'sweep': {
      const { min = 0, max = 1, name = '' } = parameter ?? {};
      const steps = [0.1, 0.125, 0.25, 0.5].map((part) => part * (max - min));
      return { label: name, from: min, to: max, steps, text: shortNumber };
    }
    default:
      return { ...quarter, from: -90, label: `θ${incidenceOf(settings).moving}` };
  }
}

interface Line {
  readonly points: Curve;
  /** Instead of that of the strand. */
  readonly dash?: readonly number[];
  readonly label?: string;
}

/** A curve has one line; over a parameter, one for each angle of the viewer. */
function linesOf(curve: PlottedCurve, { settings }: Plot): Line[] {
  if (settings.view !== 'sweep') return [{ points: curve.points }];
  return sweepAngles.map((angle, i) => ({
    points: curve.sweep.map(({ value, albedos }) => ({ angle: value, rgb: albedos[i] ?? [0, 0, 0] })),
    dash: dashOf(i),
    label: `θv ${angle}°`,
  }));
}

function valueAt(area: Area, { from, to }: Axis, [x, y]: Point): number | null {
  const part = (x - area.x) / area.width;
  if (part < -0.02 || part > 1.02 || y < area.y || y > area.y + area.height) return null;
  return from + (to - from) * Math.min(1, Math.max(0, part));
}

export const cartesianView: View = {
  draw: drawCartesian,
  probe(plot, width, height, at) {
    const x = valueAt(areaOf(width, height), axisOf(plot), at);
    return x === null ? null : { x };
  },
  where(probe, plot) {
    const { label } = axisOf(plot);
    return `${label} ${plot.settings.view === 'sweep' ? shortNumber(tenths(1000 * probe.x) / 1000) : degrees(probe.x)}`;
  },
  value: (curve, { x }) => curve.at(x)?.rgb,
  grip(plot, width, height, at) {
    const area = areaOf(width, height);
    const axis = axisOf(plot);
    const angle = valueAt(area, axis, at);
    if (angle === null || plot.settings.view !== 'thetaL') return null;
    const { settings, still, moving } = incidenceOf(plot.settings);
    const light = lightInPlane(settings);
    return light !== null &&
      (Math.abs(angle - light) / 180) * area.width < REACH &&
      at[1] > area.y + area.height - 24
      ? moving
      : still;
  },
  drag(plot, width, height, at, handle) {
    const angle = valueAt(areaOf(width, height), axisOf(plot), at);
    if (angle === null) return {};
    const { settings, moving, change } = incidenceOf(plot.settings);
    if (handle === moving) return change(lightFromPlane(angle, settings));
    return change({ thetaV: Math.min(STEEPEST, tenths(Math.abs(angle))) });
  },
  keys(settings, right) {
    const seen = incidenceOf(settings);
    return settings.view === 'thetaL' ? seen.change(turnedViewer(seen.settings, right)) : {};
  },
  table(plot) {
    const { settings, curves, parameter } = plot;
    if (settings.view === 'sweep') {
      const rows = (curves[0]?.sweep ?? []).flatMap(({ value }) =>
        sweepAngles.map((angle, i) => ({
          at: [value, angle],
          values: curves.map((curve) => curve.sweep.find((point) => point.value === value)?.albedos[i]),
        })),
      );
      return { head: [parameter?.name ?? 'parameter', 'theta_v_deg'], rows };
    }
    const names = {
      thetaH: 'theta_h',
      thetaD: 'theta_d',
      albedo: 'theta_v',
      fresnel: 'theta_i',
      thetaL: `theta_${incidenceOf(settings).moving}`,
    };
    const phi = settings.turns === 'half' ? 'phi_h' : 'phi_l';
    const name = settings.view === 'phi' ? phi : names[settings.view as keyof typeof names];
    return curveTable(`${name}_deg`, plot);
  },
};

function drawCartesian(painter: Painter, plot: Plot): void {
  const { curves, probe } = plot;
  const { settings, still, moving } = incidenceOf(plot.settings);
  const area = areaOf(painter.width, painter.height);
  const axis = axisOf(plot);
  const isShare = ['albedo', 'sweep', 'fresnel'].includes(settings.view);
  const values = curves.flatMap((curve) =>
    linesOf(curve, plot).flatMap(({ points }) =>
      strandsOf(curve, settings.channel).flatMap(({ channel }) =>
        points.map(({ rgb }) => channelOf(rgb, channel)),
      ),
    ),
  );
  // A share: 1 is always in sight, for a curve above it makes energy.
  const scale = valueScale(isShare && !settings.log ? [...values, 1] : values, settings.log, settings.range);
  const x = (value: number) => area.x + ((value - axis.from) / (axis.to - axis.from)) * area.width;
  const y = (value: number) => area.y + area.height * (1 - scale.position(value));
  const bottom = area.y + area.height;
  const upright = (value: number, color: string, dash: readonly number[] = []) =>
    painter.line(
      [
        [x(value), area.y],
        [x(value), bottom],
      ],
      { color, dash },
    );

  drawGrid(painter, area, scale, axis, x);
  painter.text(axis.label, [area.x + area.width, painter.height - 9], { color: colors.text, align: 'right' });
  painter.text(quantityOf(settings), [12, area.y + area.height / 2], {
    color: colors.text,
    align: 'center',
    turn: -90,
  });
  painter.clip({ ...area, y: area.y - 4, height: area.height + 8 }, () => {
    if (isShare) {
      painter.line(
        [
          [area.x, y(1)],
          [area.x + area.width, y(1)],
        ],
        { color: colors.faint, dash: [4, 4] },
      );
    }
    if (settings.view === 'sweep' && plot.parameter) upright(plot.parameter.value, colors.faint);
    if (settings.view === 'thetaL') {
      upright(-settings.thetaV, colors.faint);
      if (settings.thetaV > 0) upright(settings.thetaV, colors.faint, [3, 4]);
    }
    if (probe) upright(probe.x, colors.axis);
    for (const curve of curves) {
      for (const line of linesOf(curve, plot)) {
        for (const { channel, stroke } of strandsOf(curve, settings.channel)) {
          painter.line(
            line.points.map(({ angle, rgb }) => [x(angle), y(channelOf(rgb, channel))]),
            line.dash ? { ...stroke, dash: line.dash } : stroke,
          );
        }
      }
      const under = probe && curve.at(probe.x);
      if (!under) continue;
      for (const { channel, stroke } of strandsOf(curve, settings.channel))
        painter.disc([x(under.angle), y(channelOf(under.rgb, channel))], 3.5, stroke.color);
    }
  });
  if (settings.view === 'sweep') drawAngleKey(painter, area);
  if (settings.view === 'fresnel') drawFresnelKey(painter, area, plot);
  if (settings.view === 'thetaL') {
    painter.text(still, [x(-settings.thetaV) + 5, area.y + 7], { color: handleColor(still) });
    if (settings.thetaV > 0)
      painter.text(t('mirror'), [x(settings.thetaV) + 5, area.y + 7], { color: colors.faint });
    const light = lightInPlane(settings);
    if (light !== null) {
      painter.disc([x(light), bottom], 4, handleColor(moving));
      painter.text(moving, [x(light) + 8, bottom - 8], { color: handleColor(moving) });
    }
  }
}

/** Which line is which, and the most that they are apart: substances have no row in the bench's legend. */
function drawFresnelKey(painter: Painter, area: Area, { curves, settings }: Plot): void {
  const [exact, schlick] = curves;
  if (!exact || !schlick) return;
  // Metals are bright from the start, glass is dark: the key goes to the other end.
  const isBright = (exact.points[0]?.rgb[1] ?? 0) > 0.4;
  const top = isBright ? area.y + area.height - 66 : area.y + 34;
  for (const [i, { name, color }] of curves.entries()) {
    const [x, y] = [area.x + 12, top + 16 * i];
    const byDash = settings.channel === 'rgb';
    painter.line(
      [
        [x, y],
        [x + 26, y],
      ],
      { color: byDash ? colors.text : color, width: 2, dash: byDash ? dashOf(i) : [] },
    );
    painter.text(name, [x + 34, y], { color: colors.text });
  }
  const channel = settings.channel === 'rgb' ? 'luminance' : settings.channel;
  const apart = exact.points.map(({ angle, rgb }, i) => {
    const other = schlick.points[i]?.rgb ?? rgb;
    return { angle, error: channelOf(other, channel) - channelOf(rgb, channel) };
  });
  const most = apart.reduce((a, b) => (Math.abs(b.error) > Math.abs(a.error) ? b : a));
  const sign = most.error < 0 ? '−' : '+';
  const figure = `${sign}${shortNumber(Number(Math.abs(most.error).toPrecision(2)))}`;
  painter.text(t('Schlick is off by up to'), [area.x + 12, top + 34], { color: colors.text });
  painter.text(
    t('{figure} in {channel}, at {value}', { figure, channel, value: degrees(most.angle) }),
    [area.x + 12, top + 49],
    {
      color: colors.text,
    },
  );
}

/** Which dashes mean which angle of the viewer. */
function drawAngleKey(painter: Painter, area: Area): void {
  painter.fill({ x: area.x + 4, y: area.y + area.height - 37, width: 186, height: 34 }, colors.veil);
  for (const [i, angle] of sweepAngles.entries()) {
    const [x, y] = [area.x + 10 + (i % 2) * 92, area.y + area.height - 26 + Math.floor(i / 2) * 15];
    painter.line(
      [
        [x, y],
        [x + 26, y],
      ],
      { color: colors.text, width: 1.5, dash: dashOf(i) },
    );
    painter.text(`θv ${angle}°`, [x + 33, y], { color: colors.text });
  }
}

function drawGrid(
  painter: Painter,
  area: Area,
  scale: Scale,
  axis: Axis,
  x: (value: number) => number,
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
  const perUnit = area.width / (axis.to - axis.from);
  const step =
    axis.steps.find((distance) => distance * perUnit >= LABEL_WIDTH) ?? (axis.steps.at(-1) as number);
  const count = Math.round((axis.to - axis.from) / step);
  for (let i = 0; i <= count; i++) {
    const value = axis.from + i * step;
    const at = Math.round(x(value)) + 0.5;
    painter.line(
      [
        [at, area.y],
        [at, bottom],
      ],
      { color: value === 0 ? colors.axis : colors.grid },
    );
    painter.text(axis.text(value), [at, bottom + 11], { color: colors.faint, align: 'center' });
  }
}
