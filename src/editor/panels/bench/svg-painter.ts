import { encodePng } from '../../../io/png.ts';
import { encodeBase64 } from '../../../scene/base64.ts';
import { edgeWidth, FONT, FONT_SIZE, type Painter } from './painter.ts';

export interface SvgPainter extends Painter {
  /** The file. */
  finish(): string;
}

export function svgPainter(width: number, height: number): SvgPainter {
  const parts: string[] = [];
  let clips = 0;
  const number = (value: number) => String(Number(value.toFixed(2)));
  const box = (x: number, y: number, w: number, h: number) =>
    `x="${number(x)}" y="${number(y)}" width="${number(w)}" height="${number(h)}"`;
  return {
    width,
    height,
    fill({ x, y, width: w, height: h }, color) {
      parts.push(`<rect ${box(x, y, w, h)} fill="${color}"/>`);
    },
    line(points, { color, width: lineWidth = 1, dash = [] }) {
      const path = points.map(([x, y]) => `${number(x)},${number(y)}`).join(' ');
      const dashes = dash.length ? ` stroke-dasharray="${dash.join(' ')}"` : '';
      parts.push(
        `<polyline points="${path}" fill="none" stroke="${color}" stroke-width="${lineWidth}" stroke-linejoin="round"${dashes}/>`,
      );
    },
    polygon(points, color, edge) {
      const path = points.map(([x, y]) => `${number(x)},${number(y)}`).join(' ');
      const stroke = edge === null ? '' : ` stroke="${edge}" stroke-width="${edgeWidth(color, edge)}"`;
      parts.push(`<polygon points="${path}" fill="${color}"${stroke}/>`);
    },
    disc([x, y], radius, color) {
      parts.push(`<circle cx="${number(x)}" cy="${number(y)}" r="${number(radius)}" fill="${color}"/>`);
    },
    text(text, [x, y], { color, align = 'left', turn = 0 }) {
      const anchor = { left: 'start', center: 'middle', right: 'end' }[align];
      const turned = turn ? ` transform="rotate(${turn} ${number(x)} ${number(y)})"` : '';
      parts.push(
        `<text x="${number(x)}" y="${number(y)}" dy=".35em" fill="${color}" text-anchor="${anchor}"${turned}>${escaped(text)}</text>`,
      );
    },
    image({ width: w, height: h, rgba }, area, smooth = false) {
      const png = encodeBase64(encodePng(new Uint8Array(rgba), w, h));
      parts.push(
        `<image ${box(area.x, area.y, area.width, area.height)} preserveAspectRatio="none" image-rendering="${smooth ? 'auto' : 'pixelated'}" href="data:image/png;base64,${png}"/>`,
      );
    },
    clip({ x, y, width: w, height: h }, draw) {
      clips += 1;
      parts.push(`<clipPath id="clip${clips}"><rect ${box(x, y, w, h)}/></clipPath>`);
      parts.push(`<g clip-path="url(#clip${clips})">`);
      draw();
      parts.push('</g>');
    },
    finish: () =>
      [
        `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="${escaped(FONT)}" font-size="${FONT_SIZE}">`,
        ...parts,
        '</svg>',
        '',
      ].join('\n'),
  };
}

function escaped(text: string): string {
  return text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}
