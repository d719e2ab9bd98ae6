/**
 * What is drawn over the picture: where the lights are and shine, and the tools of hands. A 2D canvas
 * of its own, so that it is crisp at any resolution scale, is not tone mapped, is not in screenshots
 * and costs the renderer nothing. What is selected has its outlines in the picture's canvas: outlines.ts.
 */
import type { PerspectiveCamera } from 'three/webgpu';
import type { Document, Light } from '../../scene/schema.ts';
import type { Entity } from '../state.ts';
import { iconPath } from '../ui/icons.ts';
import { type Line, lightLines } from './light-lines.ts';
import { createProjector, type Projector } from './projector.ts';

export interface OverlayInput {
  document: Document;
  camera: PerspectiveCamera;
  selected: readonly Entity[];
  /** Over all the rest. */
  tools(context: CanvasRenderingContext2D): void;
}

/** Where a light's symbol is drawn, CSS pixels. */
export interface LightMark {
  readonly id: string;
  readonly x: number;
  readonly y: number;
}

export interface Overlay {
  readonly element: HTMLCanvasElement;
  draw(input: OverlayInput): void;
  /** The lights that can be picked. */
  readonly lights: readonly LightMark[];
  /** The light whose symbol is at this place of the viewport. */
  lightAt(x: number, y: number): string | null;
}

const ACCENT = '#eaa54b';
/** What is selected, but not last. */
const PALE = '#d8b98a';
const QUIET = '#c9ced6';
const HALO = 'rgba(0, 0, 0, 0.55)';
const SYMBOL_PX = 18;
const symbols = new Map<string, Path2D>();

export function createOverlay(): Overlay {
  const element = document.createElement('canvas');
  element.className = 'overlay';
  const context = element.getContext('2d');
  let lights: LightMark[] = [];

  return {
    element,
    get lights() {
      return lights;
    },
    draw(input) {
      lights = [];
      const { clientWidth: width, clientHeight: height } = element;
      const ratio = devicePixelRatio;
      if (element.width !== Math.round(width * ratio)) element.width = Math.round(width * ratio);
      if (element.height !== Math.round(height * ratio)) element.height = Math.round(height * ratio);
      if (!context || width === 0 || height === 0) return;
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, width, height);
      const projector = createProjector(input.camera, width, height);
      const colors = new Map(
        input.selected.flatMap(({ kind, id }, i, { length }) =>
          kind === 'lights' ? [[id, i === length - 1 ? ACCENT : PALE] as const] : [],
        ),
      );
      for (const [id, light] of Object.entries(input.document.lights)) {
        const color = colors.get(id) ?? null;
        if (!('position' in light) || (color === null && !input.document.view.helpers)) continue;
        drawLight(context, projector, light, color);
        const place = projector.point(light.position);
        if (!place) continue;
        drawSymbol(context, light, place.x, place.y, color);
        if (!light.locked) lights.push({ id, ...place });
      }
      input.tools(context);
    },
    lightAt(x, y) {
      const near = lights.filter((hit) => Math.hypot(hit.x - x, hit.y - y) <= SYMBOL_PX * 0.7);
      near.sort((a, b) => Math.hypot(a.x - x, a.y - y) - Math.hypot(b.x - x, b.y - y));
      return near[0]?.id ?? null;
    },
  };
}

function drawLight(
  context: CanvasRenderingContext2D,
  projector: Projector,
  light: Light,
  /** Of what is selected. */
  mark: string | null,
): void {
  const { main, faint } = lightLines(light);
  const color = mark ?? QUIET;
  const chosen = mark !== null;
  context.globalAlpha = light.visible ? (chosen ? 1 : 0.65) : 0.3;
  drawLines(context, projector, main, color, chosen ? 1.5 : 1);
  context.globalAlpha *= 0.5;
  context.setLineDash([4, 4]);
  drawLines(context, projector, faint, color, 1);
  context.setLineDash([]);
  context.globalAlpha = 1;
}

function drawLines(
  context: CanvasRenderingContext2D,
  projector: Projector,
  lines: readonly Line[],
  color: string,
  width: number,
): void {
  if (lines.length === 0) return;
  context.beginPath();
  for (const line of lines) {
    for (let i = 1; i < line.length; i++) {
      const [a, b] = [line[i - 1], line[i]];
      const segment = a && b && projector.segment(a, b);
      if (!segment) continue;
      context.moveTo(segment[0].x, segment[0].y);
      context.lineTo(segment[1].x, segment[1].y);
    }
  }
  context.lineCap = 'round';
  context.strokeStyle = HALO;
  context.lineWidth = width + 1.5;
  context.stroke();
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}

function drawSymbol(
  context: CanvasRenderingContext2D,
  light: Light,
  x: number,
  y: number,
  mark: string | null,
): void {
  let path = symbols.get(light.type);
  if (!path) {
    path = new Path2D(iconPath(light.type));
    symbols.set(light.type, path);
  }
  context.save();
  context.globalAlpha = light.visible ? 1 : 0.45;
  context.beginPath();
  context.arc(x, y, SYMBOL_PX * 0.62, 0, 2 * Math.PI);
  context.fillStyle = mark ?? 'rgba(22, 24, 28, 0.85)';
  context.fill();
  context.strokeStyle = mark ?? 'rgba(255, 255, 255, 0.25)';
  context.lineWidth = 1;
  context.stroke();
  context.translate(x - 6.5, y - 6.5);
  context.scale(13 / 16, 13 / 16);
  context.strokeStyle = mark
    ? '#191b1f'
    : `rgb(${light.color.map((c) => Math.round(120 + 135 * Math.sqrt(c))).join(' ')})`;
  context.lineWidth = 1.5;
  context.lineJoin = 'round';
  context.stroke(path);
  context.restore();
}
