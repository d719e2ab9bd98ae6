/** The studio as a picture in which soft boxes are chosen, moved and sized, by pointer or by keys. */

import { changeSoftBox, removeSoftBox } from '../../../scene/environment-commands.ts';
import type { EnvironmentSource, SoftBox } from '../../../scene/environment-schema.ts';
import { studioMap } from '../../../scene/studio.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { type Gesture, newGesture } from '../../ui/gesture.ts';
import {
  cornerOf,
  directionOf,
  outlineOf,
  PICTURE_HEIGHT,
  PICTURE_WIDTH,
  placeOf,
  sizeTowards,
} from './geometry.ts';

type Studio = Extract<EnvironmentSource, { type: 'studio' }>;

export interface PictureOptions {
  readonly session: Session;
  /** Which box is chosen; -1 for none. */
  selected(): number;
  select(index: number): void;
}

const SVG = 'http://www.w3.org/2000/svg';
/** Columns of the drawn image: half of the map's. */
const DRAWN_WIDTH = 256;

export function studioPicture({ session, selected, select }: PictureOptions): {
  element: HTMLElement;
  update(): void;
} {
  const { store } = session;
  const canvas = h('canvas', { width: DRAWN_WIDTH, height: DRAWN_WIDTH / 2 });
  const marks = document.createElementNS(SVG, 'svg');
  marks.setAttribute('viewBox', `0 0 ${PICTURE_WIDTH} ${PICTURE_HEIGHT}`);
  const element = h('div', {
    class: 'studio-picture',
    role: 'group',
    'aria-label': t('The studio: directions as a chrome ball shows them to the camera'),
    tip: t(
      'As a chrome ball shows it to the camera: its left is the left here, behind the camera is the middle.\nDrag a box to move it, its corner to size it. Keys: arrows move, + and - size, Delete deletes',
    ),
  });
  element.append(canvas, marks);
  const groups: SVGGElement[] = [];
  let drawn: Studio | null = null;

  const studio = (): Studio | null => {
    const { source } = store.document.environment;
    return source.type === 'studio' ? source : null;
  };
  const change = (index: number, values: Partial<SoftBox>, label: string, gesture: Gesture) =>
    attempt(t('The soft box stays as it is'), () =>
      changeSoftBox(store, index, values, label, gesture && `soft box ${index} ${gesture}`),
    );
  const placeIn = (event: PointerEvent): [number, number] => {
    const bounds = marks.getBoundingClientRect();
    return [
      ((event.clientX - bounds.left) / bounds.width) * PICTURE_WIDTH,
      ((event.clientY - bounds.top) / bounds.height) * PICTURE_HEIGHT,
    ];
  };

  /** @param isCorner whether it sizes the box, or moves it */
  const drag = (group: SVGGElement, index: number, isCorner: boolean, start: PointerEvent) => {
    const box = studio()?.boxes[index];
    if (start.button !== 0 || box === undefined) return;
    start.preventDefault();
    start.stopPropagation();
    select(index);
    group.focus({ preventScroll: true });
    const gesture = newGesture();
    const from = placeIn(start);
    const middle = placeOf(box);
    const move = (event: PointerEvent) => {
      const [x, y] = placeIn(event);
      if (isCorner) {
        change(index, sizeTowards(box, directionOf([x, y])), 'Size soft box', gesture);
        return;
      }
      const to = directionOf([middle[0] + x - from[0], middle[1] + y - from[1]]);
      change(
        index,
        { azimuth: Math.round(to.azimuth), elevation: Math.round(to.elevation) },
        'Move soft box',
        gesture,
      );
    };
    const end = () => {
      marks.removeEventListener('pointermove', move);
      marks.removeEventListener('pointerup', end);
      marks.removeEventListener('pointercancel', end);
      store.endMerge();
    };
    marks.setPointerCapture(start.pointerId);
    marks.addEventListener('pointermove', move);
    marks.addEventListener('pointerup', end);
    marks.addEventListener('pointercancel', end);
  };

  const onKey = (index: number, event: KeyboardEvent) => {
    const box = studio()?.boxes[index];
    if (box === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 1 : 5;
    const move = (azimuth: number, elevation: number) =>
      change(
        index,
        {
          azimuth: (((box.azimuth + azimuth) % 360) + 360) % 360,
          elevation: Math.min(90, Math.max(-90, box.elevation + elevation)),
        },
        'Move soft box',
        undefined,
      );
    const size = (factor: number) =>
      change(
        index,
        {
          width: Math.min(170, Math.max(1, Math.round(box.width * factor * 10) / 10)),
          height: Math.min(170, Math.max(1, Math.round(box.height * factor * 10) / 10)),
        },
        'Size soft box',
        undefined,
      );
    const actions: Readonly<Record<string, () => unknown>> = {
      // To the picture's left azimuths grow.
      ArrowLeft: () => move(step, 0),
      ArrowRight: () => move(-step, 0),
      ArrowUp: () => move(0, step),
      ArrowDown: () => move(0, -step),
      '+': () => size(1.1),
      '=': () => size(1.1),
      '-': () => size(1 / 1.1),
      Delete: () => attempt(t('The soft box stays'), () => removeSoftBox(store, index)),
      Backspace: () => attempt(t('The soft box stays'), () => removeSoftBox(store, index)),
    };
    const run = actions[event.key];
    if (run === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    run();
  };

  const addGroup = (index: number) => {
    const group = document.createElementNS(SVG, 'g');
    group.setAttribute('tabindex', '0');
    group.setAttribute('role', 'button');
    const outline = document.createElementNS(SVG, 'path');
    const corner = document.createElementNS(SVG, 'circle');
    corner.setAttribute('r', '4.5');
    group.append(outline, corner);
    outline.addEventListener('pointerdown', (event) => drag(group, index, false, event));
    corner.addEventListener('pointerdown', (event) => drag(group, index, true, event));
    group.addEventListener('keydown', (event) => onKey(index, event));
    group.addEventListener('focus', () => select(index));
    marks.append(group);
    groups.push(group);
  };

  return {
    element,
    update() {
      const source = studio();
      if (source === null) return;
      if (source !== drawn) drawStudio(canvas, source);
      drawn = source;
      while (groups.length > source.boxes.length) groups.pop()?.remove();
      while (groups.length < source.boxes.length) addGroup(groups.length);
      for (const [index, box] of source.boxes.entries()) {
        const group = groups[index]!;
        const [outline, corner] = [group.children[0]!, group.children[1]!];
        const isSelected = index === selected();
        outline.setAttribute('d', outlineOf(box));
        const [x, y] = cornerOf(box);
        corner.setAttribute('cx', x.toFixed(1));
        corner.setAttribute('cy', y.toFixed(1));
        group.classList.toggle('selected', isSelected);
        group.setAttribute('aria-pressed', String(isSelected));
        group.setAttribute(
          'aria-label',
          t('Soft box {number}: {azimuth}° around, {elevation}° high', {
            number: index + 1,
            azimuth: Math.round(box.azimuth),
            elevation: Math.round(box.elevation),
          }),
        );
      }
    },
  };
}

/** Tone mapped so that the brightest box is almost white: L / (L + a quarter of the most). */
function drawStudio(canvas: HTMLCanvasElement, source: Studio): void {
  const { texels, width, height } = studioMap(source);
  const context = canvas.getContext('2d');
  if (context === null) return;
  let most = 0;
  for (let i = 0; i < texels.length; i += 4)
    most = Math.max(most, texels[i]!, texels[i + 1]!, texels[i + 2]!);
  const image = context.createImageData(canvas.width, canvas.height);
  for (let y = 0; y < canvas.height; y += 1) {
    for (let x = 0; x < canvas.width; x += 1) {
      const at = 4 * (y * canvas.width + x);
      // Columns of the map run by azimuth from west by north and east; those of the picture the other way from north.
      const { azimuth, elevation } = directionOf([
        ((x + 0.5) / canvas.width) * PICTURE_WIDTH,
        ((y + 0.5) / canvas.height) * PICTURE_HEIGHT,
      ]);
      const column = Math.floor((((azimuth + 90) % 360) / 360) * width) % width;
      const row = Math.min(height - 1, Math.floor((0.5 + elevation / 180) * height));
      const from = 4 * (row * width + column);
      for (let c = 0; c < 3; c += 1) {
        const light = texels[from + c]!;
        const shown = most > 0 ? light / (light + most / 4) / 0.8 : 0;
        image.data[at + c] = 255 * Math.min(1, shown) ** (1 / 2.2);
      }
      image.data[at + 3] = 255;
    }
  }
  context.putImageData(image, 0, 0);
}
