/** What of the selection can be moved, and where its gizmo stands. */
import type { Document, Light } from '../../../scene/schema.ts';
import type { Entity } from '../../state.ts';
import { type Axes, aimedAxes, axesOf, type Frame, middleOf, turnOf, worldAxes } from './frame.ts';
import type { GizmoTool } from './handles.ts';
import type { Placed } from './placed.ts';

export interface Mover {
  readonly kind: 'objects' | 'lights';
  readonly id: string;
  readonly name: string;
  readonly placed: Placed;
  /** Its own, in the world. */
  readonly axes: Axes;
}

/** What is selected and stands somewhere, without what is locked. */
export function moversOf(document: Document, selected: readonly Entity[]): Mover[] {
  return selected.flatMap(({ kind, id }): Mover[] => {
    if (kind === 'objects') {
      const object = document.objects[id];
      if (!object || object.locked) return [];
      const { name, position, rotation, scale } = object;
      return [{ kind, id, name, placed: { position, rotation, scale }, axes: axesOf(turnOf(rotation)) }];
    }
    const light = kind === 'lights' ? document.lights[id] : undefined;
    if (kind !== 'lights' || !light || light.locked || !('position' in light)) return [];
    return [{ kind, id, name: light.name, placed: placedLight(light), axes: lightAxes(light) }];
  });
}

type StandingLight = Extract<Light, { position: unknown }>;

function placedLight(light: StandingLight): Placed {
  const { position } = light;
  if (!('target' in light)) return { position };
  const { target } = light;
  if (light.type !== 'rectangle') return { position, target };
  return { position, target, width: light.width, height: light.height };
}

function lightAxes(light: StandingLight): Axes {
  return 'target' in light ? aimedAxes(light.position, light.target) : worldAxes();
}

/** A point that is alone has nothing that turns or scales. */
export function canBe(tool: GizmoTool, movers: readonly Mover[]): boolean {
  if (tool === 'move' || movers.length > 1) return true;
  return movers.some(({ placed: { rotation, target, scale, width } }) =>
    tool === 'rotate' ? (rotation ?? target) !== undefined : (scale ?? width) !== undefined,
  );
}

export interface FrameOptions {
  readonly tool: GizmoTool;
  readonly space: 'world' | 'local';
  /** Of several: the middle of where they stand, or where the last one stands. */
  readonly pivot: 'middle' | 'last';
}

/** Null if there is nothing to move. */
export function frameOf(movers: readonly Mover[], { tool, space, pivot }: FrameOptions): Frame | null {
  const last = movers.at(-1);
  if (!last) return null;
  const points = movers.map(({ placed }) => placed.position);
  return {
    pivot: middleOf(pivot === 'last' ? points.slice(-1) : points),
    // A scale is along a thing's own axes, whatever the others are for.
    axes: space === 'local' || (tool === 'scale' && movers.length === 1) ? last.axes : worldAxes(),
  };
}
