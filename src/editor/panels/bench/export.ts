/** A view as a file: SVG and PNG from the same drawing, CSV from the numbers. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import type { Rgb } from '../../../analysis/plots/curve.ts';
import { t } from '../../language/language.ts';
import { canvasPainter } from './canvas-painter.ts';
import { colors, dashOf, type Plot } from './frame.ts';
import type { Painter } from './painter.ts';
import { drawPlot } from './pane.ts';
import { svgPainter } from './svg-painter.ts';
import { themed } from './themed-painter.ts';
import { viewInfo } from './views.ts';

const LEGEND_ROW = 18;
/** For print and for screens of twice the density. */
const PNG_SCALE = 2;

export function exportSvg(plot: Plot, width: number, height: number): Blob {
  const painter = svgPainter(width, height + legendHeight(plot));
  drawWithLegend(themed(painter), plot, height);
  return new Blob([painter.finish()], { type: 'image/svg+xml' });
}

export async function exportPng(plot: Plot, width: number, height: number): Promise<Blob> {
  const canvas = document.createElement('canvas');
  drawWithLegend(themed(canvasPainter(canvas, width, height + legendHeight(plot), PNG_SCALE)), plot, height);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve));
  if (!blob) throw new Error(t('the browser could not encode the plot as PNG'));
  return blob;
}

const legendHeight = ({ curves }: Plot) => (curves.length ? curves.length * LEGEND_ROW + 10 : 0);

/** A file has no legend beside it: the names go under the plot. */
function drawWithLegend(painter: Painter, plot: Plot, height: number): void {
  drawPlot({ ...painter, height }, { ...plot, probe: null });
  const below = { x: 0, y: height, width: painter.width, height: painter.height - height };
  painter.fill(below, colors.background);
  for (const [i, { name, color, index }] of plot.curves.entries()) {
    const y = height + (i + 0.5) * LEGEND_ROW;
    const byDash = plot.settings.channel === 'rgb';
    const dash = byDash ? dashOf(index) : [];
    painter.line(
      [
        [16, y],
        [44, y],
      ],
      { color: byDash ? colors.text : color, width: 2, dash },
    );
    painter.text(name, [54, y], { color: colors.text });
  }
}

/** Every number in full: what is read back is what was computed. */
export function exportCsv(plot: Plot): Blob {
  const columns = ['red', 'green', 'blue', 'luminance'];
  const cells = (rgb: Rgb | undefined) =>
    rgb ? [...rgb, channelOf(rgb, 'luminance')].map(String) : columns.map(() => '');
  const names = plot.curves.flatMap(({ name }) => columns.map((column) => quoted(`${name} ${column}`)));
  const { head = [], rows = [] } = viewInfo[plot.settings.view].view?.table(plot) ?? {};
  const lines = rows.map(({ at, values }) => [...at.map(String), ...values.flatMap(cells)]);
  return new Blob(
    [[...head, ...names], ...lines].map((line) => `${line.join(',')}\n`),
    { type: 'text/csv' },
  );
}

const quoted = (text: string) => `"${text.replaceAll('"', '""')}"`;
