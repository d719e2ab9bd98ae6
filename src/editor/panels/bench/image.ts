/** The image slices of all subjects side by side. */
import { channelOf } from '../../../analysis/plots/channel.ts';
import type { ImageSlice } from '../../../analysis/plots/image-slice.ts';
import { colors, type Plot, type Probe } from './frame.ts';
import type { Area, Painter, Pixels, Point } from './painter.ts';
import type { BenchSettings } from './settings.ts';

const MARGIN = { left: 44, right: 14, top: 28, bottom: 34 };

function tiles(count: number, width: number, height: number): Area[] {
  const { left, right, top, bottom } = MARGIN;
  const side = Math.max(16, Math.min(height - top - bottom, width / Math.max(1, count) - left - right));
  const stride = side + left + right;
  const begin = Math.max(0, (width - stride * count) / 2) + left;
  return Array.from({ length: count }, (_, i) => ({
    x: begin + i * stride,
    y: top,
    width: side,
    height: side,
  }));
}

export function imageProbe(count: number, width: number, height: number, [x, y]: Point): Probe | null {
  for (const area of tiles(count, width, height)) {
    const [column, row] = [(x - area.x) / area.width, 1 - (y - area.y) / area.height];
    if (column >= 0 && column <= 1 && row >= 0 && row <= 1) return { angle: 90 * column * column, y: row };
  }
  return null;
}

export function drawImages(painter: Painter, { curves, settings, probe }: Plot): void {
  const areas = tiles(curves.length, painter.width, painter.height);
  for (const [i, curve] of curves.entries()) {
    const area = areas[i] as Area;
    const [right, bottom] = [area.x + area.width, area.y + area.height];
    painter.fill(area, '#000000');
    if (curve.image) painter.image(shown(curve.image, settings), area);
    painter.fill({ x: area.x, y: area.y - 18, width: 8, height: 8 }, curve.color);
    painter.text(curve.name, [area.x + 14, area.y - 14], { color: colors.text });
    for (const angle of [0, 5, 15, 30, 60, 90]) {
      const x = area.x + area.width * Math.sqrt(angle / 90);
      painter.line(
        [
          [x, bottom],
          [x, bottom + 4],
        ],
        { color: colors.axis },
      );
      if (angle === 5 && area.width < 160) continue;
      painter.text(`${angle}°`, [x, bottom + 13], { color: colors.faint, align: 'center' });
    }
    for (const angle of [0, 30, 60, 90]) {
      const y = bottom - (area.height * angle) / 90;
      painter.line(
        [
          [area.x - 4, y],
          [area.x, y],
        ],
        { color: colors.axis },
      );
      painter.text(`${angle}°`, [area.x - 7, y], { color: colors.faint, align: 'right' });
    }
    painter.text('θh', [right, bottom + 27], { color: colors.text, align: 'right' });
    painter.text('θd', [area.x - 7, area.y - 14], { color: colors.text, align: 'right' });
    if (probe?.y !== undefined) {
      const x = area.x + area.width * Math.sqrt(probe.angle / 90);
      const y = bottom - area.height * probe.y;
      painter.line(
        [
          [x, area.y],
          [x, bottom],
        ],
        { color: '#ffffff50' },
      );
      painter.line(
        [
          [area.x, y],
          [right, y],
        ],
        { color: '#ffffff50' },
      );
    }
  }
}

/** sRGB (IEC 61966-2-1), clipped at 1; a single channel is grey. */
function shown({ size, pixels }: ImageSlice, { channel, brightness }: BenchSettings): Pixels {
  const gain = 2 ** brightness;
  const rgba = new Uint8ClampedArray(4 * size * size);
  for (let i = 0; i < size * size; i++) {
    const rgb = [pixels[3 * i] ?? 0, pixels[3 * i + 1] ?? 0, pixels[3 * i + 2] ?? 0] as const;
    const grey = channel === 'rgb' ? null : channelOf(rgb, channel);
    for (let c = 0; c < 3; c++) rgba[4 * i + c] = encode((grey ?? rgb[c] ?? 0) * gain);
    rgba[4 * i + 3] = 255;
  }
  return { width: size, height: size, rgba };
}

function encode(value: number): number {
  const v = Math.max(0, Math.min(1, value));
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
}
