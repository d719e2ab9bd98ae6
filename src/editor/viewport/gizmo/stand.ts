/** The gizmo as it stands at this moment: what it would move, and its handles on the screen. */
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import { plural } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { gizmoView } from './camera-view.ts';
import type { Axes, Frame } from './frame.ts';
import { type GizmoTool, type GizmoView, type Handle, handlesOf } from './handles.ts';
import { canBe, frameOf, type Mover, moversOf } from './movers.ts';

export interface Stand {
  readonly movers: readonly Mover[];
  readonly frame: Frame;
  readonly tool: GizmoTool;
  readonly view: GizmoView;
  readonly handles: readonly Handle[];
}

export interface StandOptions {
  readonly canvas: HTMLCanvasElement;
  readonly mirror: SceneMirror;
  readonly session: Session;
}

export class Stands {
  readonly #options: StandOptions;
  /** A pointer that moves over thousands of selected objects does not look at each of them. */
  #found: {
    readonly objects: Document['objects'];
    readonly lights: Document['lights'];
    readonly selected: readonly Entity[];
    readonly movers: readonly Mover[];
  } | null = null;

  constructor(options: StandOptions) {
    this.#options = options;
  }

  /** Null where there is nothing to be moved. @param axes in place of what the editor's settings say */
  of(axes: Axes | null): Stand | null {
    const { session, mirror, canvas } = this.#options;
    const { tool, space, pivot } = session.state.value;
    if (tool === 'select' || tool === 'box') return null;
    const movers = this.#movers();
    const frame = frameOf(movers, { tool, space, pivot });
    if (!frame || !canBe(tool, movers)) return null;
    const view = gizmoView(mirror.camera, canvas.clientWidth, canvas.clientHeight, frame.pivot);
    const standing = { ...frame, axes: axes ?? frame.axes };
    return { movers, frame: standing, tool, view, handles: handlesOf(tool, standing, view) };
  }

  #movers(): readonly Mover[] {
    const { store, state } = this.#options.session;
    const { objects, lights } = store.document;
    const { selected } = state.value;
    const found = this.#found;
    if (found?.objects === objects && found.lights === lights && found.selected === selected)
      return found.movers;
    const movers = moversOf(store.document, selected);
    this.#found = { objects, lights, selected, movers };
    return movers;
  }
}

/** Of the undo step. */
export function labelOf({ tool, movers }: Stand): string {
  const name = movers[0]?.name ?? '';
  const count = movers.length;
  if (tool === 'move') return plural(count, 'Move {name}', 'Move {count} things', { name });
  if (tool === 'rotate') return plural(count, 'Rotate {name}', 'Rotate {count} things', { name });
  return plural(count, 'Scale {name}', 'Scale {count} things', { name });
}
