/** What a click on the picture selects. */
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { ignoreEnd } from '../../threads/thread.ts';
import type { FocusPicking } from '../focus-picking.ts';
import type { Overlay } from '../overlay.ts';
import { type Picked, plantTrees, rayAt, whenPicked } from './picking.ts';

/** A pointer that moves further than this while it is down drags. */
export const CLICK_PX = 4;

export interface ClickOptions {
  readonly canvas: HTMLCanvasElement;
  readonly mirror: SceneMirror;
  readonly session: Session;
  readonly overlay: Overlay;
  readonly focusPicking: FocusPicking;
}

type Click = Pick<PointerEvent, 'clientX' | 'clientY' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey'>;

/** Hands over what is first under the pointer and not locked, once it is known. */
export function pickFirst(
  { canvas, mirror, session, overlay }: ClickOptions,
  event: Pick<MouseEvent, 'clientX' | 'clientY'>,
  use: (found: Entity | null) => void,
): void {
  const { store } = session;
  const box = canvas.getBoundingClientRect();
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  const light = overlay.lightAt(x, y);
  if (light !== null) {
    use({ kind: 'lights', id: light });
    return;
  }
  const ray = rayAt(mirror, (x / box.width) * 2 - 1, 1 - (y / box.height) * 2);
  const state = () => [store.document.objects];
  void whenPicked(mirror, ray, state, (picked) => {
    const first = picked.find(({ id }) => !store.document.objects[id]?.locked);
    use(first ? { kind: 'objects', id: first.id } : null);
  }).catch(ignoreEnd);
}

/** Selects what is there; with Shift or Ctrl beside what is selected, with Alt what is behind that. */
export function clickAt(
  { canvas, mirror, session, overlay, focusPicking }: ClickOptions,
  event: Click,
): void {
  const { store, state } = session;
  const box = canvas.getBoundingClientRect();
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  const [u, v] = [(x / box.width) * 2 - 1, 1 - (y / box.height) * 2];
  if (focusPicking.on) {
    focusPicking.at(u, v);
    return;
  }
  const light = overlay.lightAt(x, y);
  const use = (picked: readonly Picked[]) => select(session, light, picked, event);
  // What is behind a light's symbol matters only to who asks for it.
  if (light !== null && !event.altKey) use([]);
  else
    void whenPicked(
      mirror,
      rayAt(mirror, u, v),
      () => [store.document.objects, state.value.selected],
      use,
    ).catch(ignoreEnd);
}

function select(
  { store, state }: Session,
  light: string | null,
  picked: readonly Picked[],
  event: Click,
): void {
  const found: Entity[] = light === null ? [] : [{ kind: 'lights', id: light }];
  for (const { id } of picked) if (!store.document.objects[id]?.locked) found.push({ kind: 'objects', id });
  const entity = event.altKey ? behind(found, state.value.selection) : found[0];
  if (event.shiftKey || event.ctrlKey || event.metaKey) {
    if (entity) state.toggleSelected(entity);
  } else state.select(entity ?? null);
}

/** The one after what is selected, and after the last the first again. */
function behind(found: readonly Entity[], selection: Entity | null): Entity | undefined {
  const at = found.findIndex(({ kind, id }) => kind === selection?.kind && id === selection.id);
  return found[(at + 1) % found.length];
}

/** Clicks that nothing else has taken. */
export function installClicks(options: ClickOptions, onDoubleClick: () => void): void {
  const { canvas } = options;
  let down: { x: number; y: number } | null = null;
  canvas.addEventListener('pointerdown', (event) => {
    down = event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
    // Typing ends where the picture is touched.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  });
  canvas.addEventListener('pointerup', (event) => {
    const from = down;
    down = null;
    if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) <= CLICK_PX)
      clickAt(options, event);
  });
  canvas.addEventListener('dblclick', onDoubleClick);
  // A hand comes near: by the time it clicks, large meshes have their trees.
  canvas.addEventListener('pointerenter', () => void plantTrees(options.mirror).catch(ignoreEnd));
}
