/**
 * Numbers that are typed during a drag say how far it goes, in place of the pointer: metres, degrees or factors, with
 * arithmetic as in every field. Spaces part the numbers of several axes.
 */
import { MathUtils, Vector3 } from 'three/webgpu';
import { evaluateExpression } from '../../ui/expression.ts';
import { axisOf, towards } from './drag.ts';
import type { Frame } from './frame.ts';
import { axesIn, type GizmoTool, type GizmoView, type HandleId } from './handles.ts';
import type { Change, Triple } from './placed.ts';

/** More than anybody types. */
const MOST = 40;

/** The text after a key; null where the key is none of a number. */
export function typedAfter(text: string, key: string): string | null {
  if (key === 'Backspace') return text.slice(0, -1);
  if (!/^[\d.,+\-*/() ]$/.test(key) || text.length >= MOST) return null;
  return text + key;
}

/** What the text means for a handle; null while it is not, or not yet, numbers that are possible. */
export function typedChange(
  text: string,
  tool: GizmoTool,
  id: HandleId,
  frame: Frame,
  view: GizmoView,
): Change | null {
  const values = text.trim().split(/\s+/).map(evaluateExpression);
  if (!values.every((value) => value !== null)) return null;
  const [first = 0] = values;
  if (tool === 'rotate') {
    const axis = frame.axes[axisOf(id)] ?? towards(frame, view);
    return { type: 'turn', axis: axis.clone(), angle: MathUtils.degToRad(first) };
  }
  const axes = axesIn(id);
  if (tool === 'move') {
    const offset = new Vector3();
    for (const [k, i] of axes.entries()) offset.addScaledVector(frame.axes[i], values[k] ?? 0);
    return { type: 'move', offset };
  }
  // One number for all of them.
  const factors = ([0, 1, 2] as const).map((i) =>
    axes.includes(i) ? (values[axes.indexOf(i)] ?? first) : 1,
  ) as Triple;
  return factors.every((factor) => factor > 0) ? { type: 'scale', factors } : null;
}
