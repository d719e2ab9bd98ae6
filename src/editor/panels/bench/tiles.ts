/** Pictures of all subjects side by side, and of two their difference: slices, maps, lit shapes. */
import { azimuthMapAt } from '../../../analysis/plots/azimuth-slice.ts';
import type { Rgb } from '../../../analysis/plots/curve.ts';
import { imageAngles, imageSliceAt } from '../../../analysis/plots/image-slice.ts';
import { litDirections } from '../../../analysis/plots/lit-picture.ts';
import type { Picture } from '../../../analysis/plots/picture.ts';
import { FILL } from '../../../analysis/plots/surface.ts';
import { direction, type Vec3 } from '../../../analysis/vector.ts';
import { t } from '../../language/language.ts';
import { computedColor } from '../../theme/theme.ts';
import {
  colors,
  degrees,
  type Plot,
  type PlottedCurve,
  type Probe,
  type Table,
  tenths,
  type View,
  wrapped,
} from './frame.ts';
import type { Area, Painter, Point } from './painter.ts';
import { azimuthOptions, imageOptions, litOptions } from './plot-options.ts';
import { shortNumber } from './scale.ts';
import { type PaneSettings, STEEPEST } from './settings.ts';
import { differencePixels, greatestDifference, tonedPixels } from './tone.ts';

interface Margin {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Pictures with axes need room for them; those of things only for their names. */
const AXES: Margin = { left: 44, right: 14, top: 28, bottom: 34 };
/** Radians. */
const POLE_RING = 0.04;
const BARE: Margin = { left: 8, right: 8, top: 28, bottom: 8 };

function countOf({ curves }: Plot): number {
  return curves.length === 2 ? 3 : curves.length;
}

/** As large as fits, in as many rows as that takes. */
function tiles(count: number, width: number, height: number, { left, right, top, bottom }: Margin): Area[] {
  let best = { side: 0, columns: 1 };
  for (let columns = 1; columns <= Math.max(1, count); columns++) {
    const rows = Math.ceil(count / columns);
    const side = Math.min(height / rows - top - bottom, width / columns - left - right);
    if (side > best.side) best = { side, columns };
  }
  const side = Math.max(16, best.side);
  const rows = Math.ceil(count / best.columns);
  const [strideX, strideY] = [side + left + right, side + top + bottom];
  const beginY = Math.max(0, (height - strideY * rows) / 2);
  return Array.from({ length: count }, (_, i) => {
    const row = Math.floor(i / best.columns);
    // The last row may be shorter; each is in the middle.
    const inRow = Math.min(best.columns, count - row * best.columns);
    const begin = Math.max(0, (width - strideX * inRow) / 2);
    return {
      x: begin + (i % best.columns) * strideX + left,
      y: beginY + row * strideY + top,
      width: side,
      height: side,
    };
  });
}

/** The part of the way over a picture's width and height, from below. */
function partAt(areas: readonly Area[], [x, y]: Point): Probe | null {
  for (const area of areas) {
    const [column, row] = [(x - area.x) / area.width, 1 - (y - area.y) / area.height];
    if (column >= 0 && column <= 1 && row >= 0 && row <= 1) return { x: column, y: row };
  }
  return null;
}

interface TileAxes {
  readonly x: { readonly label: string; readonly ticks: readonly Tick[] };
  readonly y: { readonly label: string; readonly ticks: readonly Tick[] };
}

interface Tick {
  readonly at: number;
  readonly label: string;
}

const ticks = (angles: readonly number[], at: (angle: number) => number): Tick[] =>
  angles.map((angle) => ({ at: at(angle), label: `${angle}°` }));

function drawTiles(painter: Painter, plot: Plot, axes: TileAxes | null): void {
  const { curves, settings, probe } = plot;
  const areas = tiles(countOf(plot), painter.width, painter.height, axes ? AXES : BARE);
  for (const [i, area] of areas.entries()) {
    const curve = curves[i];
    if (axes) painter.fill(area, '#000000');
    if (curve) {
      painter.fill({ x: area.x, y: area.y - 18, width: 8, height: 8 }, curve.color);
      painter.text(curve.name, [area.x + 14, area.y - 14], { color: colors.text });
      if (curve.picture) painter.image(tonedPixels(curve.picture, settings), area, !axes);
    } else drawDifference(painter, plot, area, !axes);
    if (axes) drawAxes(painter, area, axes);
    if (axes && probe?.y !== undefined) {
      const x = area.x + area.width * probe.x;
      const y = area.y + area.height * (1 - probe.y);
      const cross: readonly (readonly [Point, Point])[] = [
        [
          [x, area.y],
          [x, area.y + area.height],
        ],
        [
          [area.x, y],
          [area.x + area.width, y],
        ],
      ];
      for (const line of cross) painter.line(line, { color: '#ffffff50' });
    }
  }
}

function drawDifference(painter: Painter, { curves, settings }: Plot, area: Area, smooth: boolean): void {
  const [a, b] = curves;
  if (!a?.picture || !b?.picture) return;
  const pixels = differencePixels(
    a.picture,
    b.picture,
    [computedColor(a.color), computedColor(b.color)],
    settings,
  );
  const most = greatestDifference(a.picture, b.picture);
  if (pixels) painter.image(pixels, area, smooth);
  const text =
    most === null
      ? t('Difference')
      : t('Difference, at most {value}', { value: shortNumber(Number(most.toPrecision(3))) });
  painter.text(text, [area.x, area.y - 14], { color: colors.text });
}

function drawAxes(painter: Painter, area: Area, axes: TileAxes): void {
  const [right, bottom] = [area.x + area.width, area.y + area.height];
  let end = Number.NEGATIVE_INFINITY;
  for (const { at, label } of axes.x.ticks) {
    const x = area.x + area.width * at;
    painter.line(
      [
        [x, bottom],
        [x, bottom + 4],
      ],
      { color: colors.axis },
    );
    if (x - end < 26) continue;
    end = x;
    painter.text(label, [x, bottom + 13], { color: colors.faint, align: 'center' });
  }
  for (const { at, label } of axes.y.ticks) {
    const y = bottom - area.height * at;
    painter.line(
      [
        [area.x - 4, y],
        [area.x, y],
      ],
      { color: colors.axis },
    );
    painter.text(label, [area.x - 7, y], { color: colors.faint, align: 'right' });
  }
  painter.text(axes.x.label, [right, bottom + 27], { color: colors.text, align: 'right' });
  painter.text(axes.y.label, [area.x - 7, area.y - 14], { color: colors.text, align: 'right' });
}

function probeWith(margin: Margin): View['probe'] {
  return (plot, width, height, at) => partAt(tiles(countOf(plot), width, height, margin), at);
}

/** @param at the numbers on the axes at a point of the unit square */
function pictureTable(
  head: readonly string[],
  { curves }: Plot,
  at: (x: number, y: number) => readonly number[],
): Table {
  const size = Math.min(...curves.map((curve) => curve.picture?.size ?? 0));
  const rows = Array.from({ length: curves.length > 0 ? size * size : 0 }, (_, i) => ({
    at: at(((i % size) + 0.5) / size, 1 - (Math.floor(i / size) + 0.5) / size),
    values: curves.map((curve) => pixelOf(curve.picture, size, i)),
  }));
  return { head, rows };
}

function pixelOf(picture: Picture | null, size: number, i: number): Rgb | undefined {
  if (picture?.size !== size || picture.alpha?.[i] === 0) return undefined;
  const [r = 0, g = 0, b = 0] = picture.pixels.subarray(3 * i, 3 * i + 3);
  const coverage = picture.alpha?.[i] ?? 1;
  return [r / coverage, g / coverage, b / coverage];
}

export const imageView: View = {
  draw(painter, plot) {
    const { squareRoot } = plot.settings;
    const x = (angle: number) => (squareRoot ? Math.sqrt(angle / 90) : angle / 90);
    drawTiles(painter, plot, {
      x: { label: 'θh', ticks: ticks([0, 5, 15, 30, 60, 90], x) },
      y: { label: 'θd', ticks: ticks([0, 30, 60, 90], (angle) => angle / 90) },
    });
  },
  probe: probeWith(AXES),
  where({ x, y = 0 }, { settings }) {
    const { thetaH, thetaD } = imageAngles(x, y, settings);
    return `θh ${degrees(thetaH)}   θd ${degrees(thetaD)}`;
  },
  value: ({ f }, { x, y = 0 }, { settings }) => imageSliceAt(f, x, y, imageOptions(settings)),
  table: (plot) =>
    pictureTable(['theta_h_deg', 'theta_d_deg'], plot, (x, y) => {
      const { thetaH, thetaD } = imageAngles(x, y, plot.settings);
      return [thetaH, thetaD];
    }),
};

const turned = ({ settings }: Plot) => (settings.turns === 'half' ? 'h' : 'l');

export const mapView: View = {
  draw(painter, plot) {
    drawTiles(painter, plot, {
      x: { label: `φ${turned(plot)}`, ticks: ticks([0, 90, 180, 270, 360], (angle) => angle / 360) },
      y: { label: `θ${turned(plot)}`, ticks: ticks([0, 30, 60, 90], (angle) => angle / 90) },
    });
  },
  probe: probeWith(AXES),
  where: ({ x, y = 0 }, plot) => `φ${turned(plot)} ${degrees(360 * x)}   θ${turned(plot)} ${degrees(90 * y)}`,
  value: ({ f }, { x, y = 0 }, { settings }) => azimuthMapAt(f, x, y, azimuthOptions(settings)),
  table: (plot) =>
    pictureTable([`phi_${turned(plot)}_deg`, `theta_${turned(plot)}_deg`], plot, (x, y) => [360 * x, 90 * y]),
};

/** The value of the pixel: what is seen, not the BRDF. */
function seen({ picture }: PlottedCurve, { x, y = 0 }: Probe): Rgb | undefined {
  if (!picture) return undefined;
  const { size } = picture;
  const column = Math.min(size - 1, Math.floor(x * size));
  const row = Math.min(size - 1, Math.floor((1 - y) * size));
  return pixelOf(picture, size, row * size + column);
}

/** The light straight above the point of the sphere that is under the pointer. */
function lightUnder(plot: Plot, width: number, height: number, at: Point): Partial<PaneSettings> | null {
  const part = partAt(tiles(countOf(plot), width, height, BARE), at);
  if (!part) return null;
  const { right, up, back } = litDirections(litOptions(plot.settings)).eye;
  let [a, b] = [2 * part.x - 1, 2 * (part.y ?? 0) - 1];
  const out = Math.hypot(a, b);
  if (out > 1) [a, b] = [a / out, b / out];
  const c = Math.sqrt(Math.max(0, 1 - a * a - b * b));
  const [x, y, z] = ([0, 1, 2] as const).map((k) => a * right[k] + b * up[k] + c * back[k]) as [
    number,
    number,
    number,
  ];
  const theta = (Math.acos(Math.max(-1, Math.min(1, z))) * 180) / Math.PI;
  return {
    thetaL: Math.min(STEEPEST, tenths(theta)),
    phiL: wrapped(tenths((Math.atan2(y, x) * 180) / Math.PI)),
  };
}

const lit: Omit<View, 'draw'> = {
  probe: probeWith(BARE),
  where: () => 'radiance',
  value: seen,
  grip: (plot, width, height, at) => (lightUnder(plot, width, height, at) ? 'l' : null),
  drag: (plot, width, height, at) => lightUnder(plot, width, height, at) ?? {},
  keys: ({ thetaL, phiL }, right, up) => ({
    thetaL: Math.max(0, Math.min(STEEPEST, thetaL + up)),
    phiL: wrapped(phiL + right),
  }),
  table: (plot) => pictureTable(['x', 'y'], plot, (x, y) => [2 * x - 1, 2 * y - 1]),
};

/** A ring about the pole, where light and viewer are at the plots' angles to the surface. */
function drawPole(painter: Painter, plot: Plot): void {
  const { right, up, back } = litDirections(litOptions(plot.settings)).eye;
  if (back[2] <= 0) return;
  for (const area of tiles(countOf(plot), painter.width, painter.height, BARE)) {
    const ring = Array.from({ length: 25 }, (_, i): Point => {
      const [x, y, z] = direction(Math.cos(POLE_RING), (i * Math.PI) / 12);
      const part = (axis: Vec3) => FILL * (axis[0] * x + axis[1] * y + axis[2] * z);
      return [area.x + (area.width / 2) * (1 + part(right)), area.y + (area.height / 2) * (1 - part(up))];
    });
    painter.line(ring, { color: '#ffffff70' });
  }
}

export const sphereView: View = {
  ...lit,
  draw(painter, plot) {
    drawTiles(painter, plot, null);
    drawPole(painter, plot);
  },
};

export const objectView: View = { ...lit, draw: (painter, plot) => drawTiles(painter, plot, null) };
