import { edgeWidth, FONT, FONT_SIZE, type Painter, type Pixels } from './painter.ts';

/** @param scale pixels of the canvas for one unit */
export function canvasPainter(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
  scale: number,
): Painter {
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  // Lines and small pictures, new in every frame: sooner drawn here than packed up for a GPU, which is busy with the
  // scene, and which a machine may not have.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('the browser gave no 2D canvas to draw a plot on');
  context.scale(scale, scale);
  context.font = `${FONT_SIZE}px ${FONT}`;
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  return {
    width,
    height,
    fill({ x, y, width: w, height: h }, color) {
      context.fillStyle = color;
      context.fillRect(x, y, w, h);
    },
    line(points, { color, width: lineWidth = 1, dash = [] }) {
      context.beginPath();
      for (const [x, y] of points) context.lineTo(x, y);
      context.strokeStyle = color;
      context.lineWidth = lineWidth;
      context.setLineDash([...dash]);
      context.stroke();
    },
    polygon(points, color, edge) {
      context.beginPath();
      for (const [x, y] of points) context.lineTo(x, y);
      context.closePath();
      context.fillStyle = color;
      context.fill();
      if (edge === null) return;
      context.strokeStyle = edge;
      context.lineWidth = edgeWidth(color, edge);
      context.setLineDash([]);
      context.stroke();
    },
    disc([x, y], radius, color) {
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fillStyle = color;
      context.fill();
    },
    text(text, [x, y], { color, align = 'left', turn = 0 }) {
      context.save();
      context.translate(x, y);
      context.rotate((turn * Math.PI) / 180);
      context.fillStyle = color;
      context.textAlign = align;
      context.fillText(text, 0, 0);
      context.restore();
    },
    image(pixels, { x, y, width: w, height: h }, smooth = false) {
      context.imageSmoothingEnabled = smooth;
      context.imageSmoothingQuality = 'high';
      context.drawImage(bitmap(pixels), x, y, w, h);
    },
    clip({ x, y, width: w, height: h }, draw) {
      context.save();
      context.beginPath();
      context.rect(x, y, w, h);
      context.clip();
      draw();
      context.restore();
    },
  };
}

function bitmap({ width, height, rgba }: Pixels): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context?.putImageData(new ImageData(rgba, width, height), 0, 0);
  return canvas;
}
