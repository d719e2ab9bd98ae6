/** Draws in the colours of the page's theme: what is `var(--...)` becomes what it is now. */
import { computedColor } from '../../theme/theme.ts';
import type { Painter } from './painter.ts';

export function themed(painter: Painter): Painter {
  return {
    ...painter,
    fill: (area, color) => painter.fill(area, computedColor(color)),
    line: (points, stroke) => painter.line(points, { ...stroke, color: computedColor(stroke.color) }),
    polygon: (points, color, edge) =>
      painter.polygon(points, computedColor(color), edge === null ? null : computedColor(edge)),
    disc: (center, radius, color) => painter.disc(center, radius, computedColor(color)),
    text: (text, at, style) => painter.text(text, at, { ...style, color: computedColor(style.color) }),
  };
}
