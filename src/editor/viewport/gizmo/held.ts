/** A drag that is under way: what it moves, along what, and how far by the pointer or by what is typed. */
import type { Entity, Steps } from '../../state.ts';
import { type Drag, type Pointer, startDrag } from './drag.ts';
import { AXES, axesIn, type HandleId, PLANES } from './handles.ts';
import type { Change, Triple } from './placed.ts';
import type { Stand } from './stand.ts';
import type { Target } from './targets.ts';
import { typedChange } from './typed.ts';

/** What the pointer is on: a handle, or the target of a light. */
export type Grip = { readonly handle: HandleId } | { readonly target: Target };

export interface Held {
  /** Null: it follows the pointer without a button, until a click or Enter. */
  readonly pointerId: number | null;
  readonly start: Pointer;
  /** Of the undo step. */
  readonly merge: string;
  readonly steps: Steps;
  /** What was selected before. */
  readonly selected: readonly Entity[];
  grip: Grip;
  stand: Stand | null;
  drag: Drag | null;
  last: { readonly pointer: Pointer; readonly ctrl: boolean };
  change: Change | null;
  moved: boolean;
  typed: string;
  /** Copies are to be dragged, and the originals stay; until they are made. */
  copies: boolean;
}

/** What the pointer, or what is typed, asks for; null where it says nothing. */
export function changeOf({ grip, stand, drag, last, typed }: Held, snap: boolean): Change | null {
  if (!stand || !('handle' in grip)) return null;
  if (typed.trim() !== '') return typedChange(typed, stand.tool, grip.handle, stand.frame, stand.view);
  return drag?.(last.pointer, snap) ?? null;
}

/** Along an axis alone, with Shift across it; the same key again makes it free. False where nothing changes. */
export function constrain(held: Held, key: string, isAcross: boolean): boolean {
  const i = AXES.indexOf(key.toLowerCase() as (typeof AXES)[number]);
  const { stand, grip, start, steps } = held;
  const axis = AXES[i];
  const plane = PLANES[i];
  if (!stand || !('handle' in grip) || !axis || !plane) return false;
  const { tool, frame, view } = stand;
  const free: HandleId = tool === 'rotate' ? 'view' : 'centre';
  const wanted = isAcross && tool !== 'rotate' ? plane : axis;
  const handle = grip.handle === wanted ? free : wanted;
  held.grip = { handle };
  // Where the pointer took hold may be far from the handle of that axis: a scale stays that of the middle.
  const drag = startDrag(tool, tool === 'scale' ? free : handle, frame, view, start, steps);
  held.drag = tool === 'scale' ? only(drag, handle) : drag;
  return true;
}

function only(drag: Drag, handle: HandleId): Drag {
  const axes = axesIn(handle);
  return (now, snap) => {
    const change = drag(now, snap);
    if (change?.type !== 'scale') return change;
    const factors = change.factors.map((factor, i) => (axes.includes(i as 0 | 1 | 2) ? factor : 1)) as Triple;
    return { ...change, factors };
  };
}
