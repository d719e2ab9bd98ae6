/** What a drag has done so far, in numbers. */
import { MathUtils } from 'three/webgpu';
import type { Frame } from './frame.ts';
import { AXES, axesIn, type HandleId } from './handles.ts';
import type { Change } from './placed.ts';

/** @param step what lengths are rounded to, m */
export function readout(id: HandleId, change: Change, { axes }: Frame, step: number): string {
  switch (change.type) {
    case 'move': {
      const digits = Math.max(2, Math.round(-Math.log10(step)));
      const along = axes.map((axis) => change.offset.dot(axis));
      return `${named(id, along, (length) => signed(length, digits))} m`;
    }
    case 'turn':
      return `${signed(MathUtils.radToDeg(change.angle), 1)}°`;
    case 'scale': {
      const [x] = change.factors;
      if (id === 'centre') return `× ${x.toFixed(2)}`;
      return named(id, change.factors, (factor) => `× ${factor.toFixed(2)}`);
    }
  }
}

/** Those axes that the handle changes, by name. */
function named(id: HandleId, values: readonly number[], write: (value: number) => string): string {
  return axesIn(id)
    .map((i) => `${AXES[i].toUpperCase()} ${write(values[i] as number)}`)
    .join('  ');
}

function signed(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits);
  if (Number(text) === 0) return text;
  return `${value < 0 ? '−' : '+'}${text}`;
}
