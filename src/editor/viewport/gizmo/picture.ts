/** What is to be drawn of a gizmo, at rest and while it is dragged. */
import type { Pixel } from '../projector.ts';
import type { Pointer } from './drag.ts';
import type { GizmoPicture } from './draw.ts';
import { dragGuides } from './guides.ts';
import type { HandleId } from './handles.ts';
import { type Change, handStep } from './placed.ts';
import { readout } from './readout.ts';
import type { Stand } from './stand.ts';

export interface Dragged {
  readonly handle: HandleId;
  readonly change: Change;
  /** Where the gizmo stood, and where the pointer was, when it was taken hold of. */
  readonly from: Stand;
  readonly start: Pointer;
  /** The pointer now. */
  readonly at: Pixel;
  /** What has been typed. */
  readonly typed: string;
}

export function pictureOf(stand: Stand, hovered: HandleId | null, dragged: Dragged | null): GizmoPicture {
  const { tool, handles, view } = stand;
  if (dragged === null) return { tool, handles, hovered, active: null, guides: [], sector: [], text: null };
  const { handle, change, from, start, at, typed } = dragged;
  // Only a move takes the pivot along.
  const { pivot } = change.type === 'move' ? stand.frame : from.frame;
  const { guides, sector } = dragGuides(handle, change, { frame: { ...from.frame, pivot }, view }, start);
  const done = readout(handle, change, from.frame, handStep(from.view.pixel));
  const value = typed === '' ? done : `${done}   ${typed}▏`;
  return { tool, handles, hovered, active: handle, guides, sector, text: { at, value } };
}
