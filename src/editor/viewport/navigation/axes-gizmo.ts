/** The world's axes as the camera sees them, in a corner of the viewport: each end is a button that looks along its axis. */
import type { PerspectiveCamera } from 'three/webgpu';
import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { type AxisDirection, directionOf } from './view-axes.ts';

export interface AxesGizmo {
  readonly element: HTMLElement;
  update(camera: PerspectiveCamera): void;
}

/** CSS pixels from the middle to an end. */
const REACH = 27;
const SVG = 'http://www.w3.org/2000/svg';

export function createAxesGizmo(look: (direction: AxisDirection) => void): AxesGizmo {
  const names: Record<string, string> = {
    'x+': t('Look from the right, along −x'),
    'x-': t('Look from the left, along +x'),
    'y+': t('Look from above, along −y'),
    'y-': t('Look from below, along +y'),
    'z+': t('Look from the front, along −z'),
    'z-': t('Look from behind, along +z'),
  };
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('aria-hidden', 'true');
  const ends = (['x', 'y', 'z'] as const).flatMap((axis) =>
    ([1, -1] as const).map((sign) => {
      const key = `${axis}${sign > 0 ? '+' : '-'}`;
      const button = h(
        'button',
        {
          type: 'button',
          class: `axis-end ${axis} ${sign > 0 ? 'positive' : 'negative'}`,
          'aria-label': names[key],
          tip: names[key],
          tabindex: key === 'x+' ? 0 : -1,
          on: { click: () => look({ axis, sign }) },
        },
        sign > 0 ? axis.toUpperCase() : '',
      );
      const line = sign > 0 ? document.createElementNS(SVG, 'line') : null;
      line?.setAttribute('class', axis);
      if (line) svg.append(line);
      return { direction: { axis, sign }, button, line };
    }),
  );
  const element = h('div', { class: 'axes-gizmo', role: 'toolbar', 'aria-label': t('View along an axis') });
  element.append(svg, ...ends.map(({ button }) => button));
  // One stop of the Tab key; arrows go from end to end.
  element.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const at = ends.findIndex(({ button }) => button === document.activeElement);
    if (!step || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (at + step + ends.length) % ends.length;
    for (const [i, { button }] of ends.entries()) button.tabIndex = i === next ? 0 : -1;
    ends[next]?.button.focus();
  });
  let drawn = '';
  return {
    element,
    update(camera) {
      camera.updateMatrixWorld();
      const key = camera.quaternion.toArray().join();
      if (key === drawn) return;
      drawn = key;
      for (const { direction, button, line } of ends) {
        const seen = directionOf(direction).transformDirection(camera.matrixWorldInverse);
        const [x, y] = [REACH * seen.x, -REACH * seen.y];
        button.style.translate = `${x}px ${y}px`;
        // Nearer ends cover those behind.
        button.style.zIndex = String(Math.round(10 + 9 * seen.z));
        button.classList.toggle('behind', seen.z < -0.2);
        line?.setAttribute('x2', String(x));
        line?.setAttribute('y2', String(y));
      }
    },
  };
}
