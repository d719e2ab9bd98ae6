/** Lets what is selected fall, and moves it in small steps. */
import { Box3, type Mesh, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import type { DocumentStore } from '../../../scene/store.ts';
import { place } from '../../../scene/transform-commands.ts';
import { attempt } from '../../commands.ts';
import { plural, t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { ThreadEnded } from '../../threads/thread.ts';
import { type Progress, startProgress, toast, toastError } from '../../ui/toast.ts';
import { type Mover, moversOf } from '../gizmo/movers.ts';
import { roundTo, type Triple } from '../gizmo/placed.ts';
import { type Meshes, pageMeshes } from '../meshes/meshes.ts';

/** A tenth of a millimetre. */
const STEP = 1e-4;

/** What takes less than this is not worth a word. */
const PATIENCE_MS = 300;

/** The selected objects fall as one, straight down, onto what is below them, the ground that shows shadows, or to y = 0. */
export async function dropSelection(
  session: Session,
  mirror: SceneMirror,
  meshes: Meshes = pageMeshes,
): Promise<void> {
  const { store, state } = session;
  const { selected } = state.value;
  // What has been found out for a scene that has changed meanwhile is found out anew.
  for (;;) {
    const { objects } = store.document;
    const movers = moversOf(store.document, selected).filter(({ kind }) => kind === 'objects');
    const found = fallOfMovers(store.document, mirror, movers, meshes);
    const fall = found instanceof Promise ? await withProgress(found, meshes) : found;
    if (fall === undefined) return;
    if (store.document.objects !== objects) continue;
    drop(store, movers, fall);
    return;
  }
}

type Fall = number | null;

/** @returns undefined if the person gave it up */
async function withProgress(found: Promise<Fall>, meshes: Meshes): Promise<Fall | undefined> {
  const text = t('Looking for what is below');
  let progress: Progress | undefined;
  const timer = window.setTimeout(() => {
    progress = startProgress(text, () => meshes.cancel());
    progress.update(text, null);
  }, PATIENCE_MS);
  try {
    return await found;
  } catch (error) {
    if (!(error instanceof ThreadEnded)) toastError(t('It stays where it was'), error);
    return undefined;
  } finally {
    clearTimeout(timer);
    progress?.done();
  }
}

function fallOfMovers(
  document: Document,
  mirror: SceneMirror,
  movers: readonly Mover[],
  meshes: Meshes,
): Fall | Promise<Fall> {
  const falling = new Set(movers.map(({ id }) => id));
  const plan = new Box3();
  const bodies = movers.flatMap(({ id }) => {
    const mesh = mirror.objectFor(id);
    if (!mesh?.visible) return [];
    // It gives the mesh its present matrix, too.
    const box = new Box3().setFromObject(mesh);
    plan.union(box);
    return [{ mesh, middle: (box.min.y + box.max.y) / 2 }];
  });
  const highest = Math.max(...bodies.map(({ middle }) => middle));
  const obstacles = Object.keys(document.objects).flatMap((id): Mesh[] => {
    const mesh = falling.has(id) ? undefined : mirror.objectFor(id);
    if (!mesh?.visible) return [];
    const box = new Box3().setFromObject(mesh);
    const isBelow =
      box.min.y <= highest &&
      box.min.x <= plan.max.x &&
      box.max.x >= plan.min.x &&
      box.min.z <= plan.max.z &&
      box.max.z >= plan.min.z;
    return isBelow ? [mesh] : [];
  });
  return meshes.fall(bodies, obstacles, groundOf(document, falling, mirror));
}

/** The height of the ground that shows shadows; where it lies by itself, the others, which hold it. Null if there is none. */
function groundOf(
  { ground, objects }: Document,
  falling: ReadonlySet<string>,
  mirror: SceneMirror,
): number | Mesh[] | null {
  if (!ground.shadowCatcher) return null;
  if (ground.height !== null) return ground.height;
  return Object.keys(objects).flatMap((id) => {
    const mesh = falling.has(id) ? undefined : mirror.objectFor(id);
    mesh?.updateWorldMatrix(true, false);
    return mesh?.visible ? [mesh] : [];
  });
}

function drop(store: DocumentStore, movers: readonly Mover[], fall: Fall): void {
  if (fall === null) {
    toast('info', t('Nothing can fall'), t('Select objects that are shown and not locked.'));
    return;
  }
  if (Math.abs(fall) < STEP / 2) return;
  const label = plural(movers.length, 'Drop {name}', 'Drop {count} things', { name: movers[0]?.name ?? '' });
  attempt(t('It stays where it was'), () =>
    place(
      store,
      label,
      movers.map(({ kind, id, placed: { position } }) => {
        const [x, y, z] = position;
        return { kind, id, placement: { position: [x, roundTo(y - fall, STEP), z] } };
      }),
    ),
  );
}

/** Moves what is selected; steps in a row are one undo step. */
export function nudgeSelection({ store, state }: Session, offset: Vector3): void {
  const movers = moversOf(store.document, state.value.selected);
  if (movers.length === 0) return;
  const move = (point: Triple): Triple =>
    new Vector3(...point)
      .add(offset)
      .toArray()
      .map((x) => roundTo(x, STEP)) as Triple;
  const label = plural(movers.length, 'Move {name}', 'Move {count} things', { name: movers[0]?.name ?? '' });
  attempt(t('It stays where it was'), () =>
    place(
      store,
      label,
      movers.map(({ kind, id, placed: { position, target } }) => ({
        kind,
        id,
        placement: { position: move(position), ...(target && { target: move(target) }) },
      })),
      `nudge ${movers.map(({ kind, id }) => `${kind}/${id}`).join()}`,
    ),
  );
}
