/** Draws a gizmo on the overlay: crisp, in CSS pixels, over whatever picture is shown. */
import type { Pixel } from '../projector.ts';
import type { GizmoTool, Handle, HandleId } from './handles.ts';

export interface GizmoPicture {
  readonly tool: GizmoTool;
  readonly handles: readonly Handle[];
  readonly hovered: HandleId | null;
  /** While it is dragged, nothing else is shown. */
  readonly active: HandleId | null;
  /** The line, or the lines, along which the drag goes, and the sector that it has turned through. */
  readonly guides: readonly { readonly id: HandleId; readonly line: readonly Pixel[] }[];
  readonly sector: readonly Pixel[];
  /** What the drag has done, beside the pointer. */
  readonly text: { readonly at: Pixel; readonly value: string } | null;
}

/** As the axes in the inspector, stronger: they stand before pictures of any colour. */
const COLORS: Readonly<Record<HandleId, string>> = {
  x: '#f2665e',
  y: '#86cc55',
  z: '#5b9dff',
  yz: '#f2665e',
  zx: '#86cc55',
  xy: '#5b9dff',
  centre: '#f4f5f7',
  view: '#d9dce1',
};
export const AXIS_COLORS = { x: COLORS.x, y: COLORS.y, z: COLORS.z } as const;
const HOVERED = '#ffd27a';
const HALO = 'rgba(0, 0, 0, 0.5)';
const LINE = 2.5;
const THICK = 3.5;
/** An arrow's head, and half a cube. */
const HEAD = { length: 15, half: 5.5, cube: 5 } as const;

export function drawGizmo(context: CanvasRenderingContext2D, picture: GizmoPicture): void {
  const { handles, hovered, active, tool } = picture;
  context.save();
  context.lineCap = 'round';
  context.lineJoin = 'round';
  drawGuides(context, picture);
  for (const handle of handles) {
    if (active !== null && handle.id !== active) continue;
    const chosen = handle.id === (active ?? hovered);
    const color = chosen ? HOVERED : COLORS[handle.id];
    context.globalAlpha = handle.strength;
    if (handle.area) drawArea(context, handle, color, chosen);
    else if (tool === 'rotate') drawRing(context, handle, color, chosen);
    else drawAxis(context, handle, color, chosen, tool);
  }
  context.restore();
  if (picture.text) drawText(context, picture.text.at, picture.text.value);
}

function trace(context: CanvasRenderingContext2D, line: readonly Pixel[]): void {
  context.beginPath();
  for (const [i, { x, y }] of line.entries()) {
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
}

function strokeTwice(context: CanvasRenderingContext2D, color: string, width: number): void {
  context.strokeStyle = HALO;
  context.lineWidth = width + 2;
  context.stroke();
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}

function drawGuides(context: CanvasRenderingContext2D, { guides, sector }: GizmoPicture): void {
  for (const { id, line } of guides) {
    trace(context, line);
    context.globalAlpha = 0.55;
    context.strokeStyle = COLORS[id];
    context.lineWidth = 1;
    context.stroke();
  }
  if (sector.length < 3) return;
  trace(context, sector);
  context.closePath();
  context.globalAlpha = 0.25;
  context.fillStyle = HOVERED;
  context.fill();
  context.globalAlpha = 0.9;
  context.strokeStyle = HOVERED;
  context.lineWidth = 1;
  context.stroke();
}

function drawArea(
  context: CanvasRenderingContext2D,
  { id, points }: Handle,
  color: string,
  chosen: boolean,
): void {
  const alpha = context.globalAlpha;
  trace(context, points);
  context.closePath();
  context.globalAlpha = alpha * (chosen ? 0.6 : id === 'centre' ? 0.25 : 0.32);
  context.fillStyle = color;
  context.fill();
  context.globalAlpha = alpha;
  strokeTwice(context, color, id === 'centre' ? 2 : 1.25);
}

function drawRing(context: CanvasRenderingContext2D, handle: Handle, color: string, chosen: boolean): void {
  const alpha = context.globalAlpha;
  context.globalAlpha = alpha * 0.28;
  for (const line of handle.away) {
    trace(context, line);
    context.strokeStyle = color;
    context.lineWidth = 1.25;
    context.stroke();
  }
  context.globalAlpha = alpha * (handle.id === 'view' && !chosen ? 0.6 : 1);
  trace(context, handle.points);
  strokeTwice(context, color, chosen ? THICK : handle.id === 'view' ? 1.5 : LINE);
}

function drawAxis(
  context: CanvasRenderingContext2D,
  { points }: Handle,
  color: string,
  chosen: boolean,
  tool: GizmoTool,
): void {
  const [from, to] = points as readonly [Pixel, Pixel];
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const [ux, uy] = length > 0 ? [(to.x - from.x) / length, (to.y - from.y) / length] : [0, 0];
  // An axis that comes towards the eye is short, and so is its head.
  const head = Math.min(HEAD.length, length * 0.5);
  const neck = tool === 'move' ? { x: to.x - ux * head, y: to.y - uy * head } : to;
  trace(context, [from, neck]);
  strokeTwice(context, color, chosen ? THICK : LINE);
  const { half, cube } = HEAD;
  const shape: Pixel[] =
    tool === 'move'
      ? [
          to,
          { x: neck.x - uy * half, y: neck.y + ux * half },
          { x: neck.x + uy * half, y: neck.y - ux * half },
        ]
      : [
          { x: to.x - cube, y: to.y - cube },
          { x: to.x + cube, y: to.y - cube },
          { x: to.x + cube, y: to.y + cube },
          { x: to.x - cube, y: to.y + cube },
        ];
  trace(context, shape);
  context.closePath();
  context.strokeStyle = HALO;
  context.lineWidth = 2;
  context.stroke();
  context.fillStyle = color;
  context.fill();
}

/** The target that a light looks at, as a diamond that can be taken hold of. */
export function drawTarget(context: CanvasRenderingContext2D, { x, y }: Pixel, chosen: boolean): void {
  const size = chosen ? 7.5 : 6;
  context.save();
  trace(context, [
    { x, y: y - size },
    { x: x + size, y },
    { x, y: y + size },
    { x: x - size, y },
  ]);
  context.closePath();
  context.fillStyle = chosen ? HOVERED : 'rgba(22, 24, 28, 0.85)';
  context.fill();
  strokeTwice(context, chosen ? HOVERED : '#eaa54b', 1.5);
  context.restore();
}

function drawText(context: CanvasRenderingContext2D, { x, y }: Pixel, value: string): void {
  context.save();
  context.font = '600 12px Inter, "Segoe UI", system-ui, sans-serif';
  context.textBaseline = 'middle';
  const width = context.measureText(value).width + 16;
  const { width: full } = context.canvas.getBoundingClientRect();
  // Beside the pointer, and within the picture.
  const left = Math.max(4, Math.min(x + 18, full - width - 4));
  const top = Math.max(4, y - 34);
  context.beginPath();
  context.roundRect(left, top, width, 24, 5);
  context.fillStyle = 'rgba(14, 15, 17, 0.88)';
  context.fill();
  context.fillStyle = '#fff';
  context.fillText(value, left + 8, top + 12.5);
  context.restore();
}
