/** Lets what is selected fall, and moves it in small steps. */
import { Box3, type Mesh, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import { place } from '../../../scene/transform-commands.ts';
import { attempt } from '../../commands.ts';
import { plural, t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { toast } from '../../ui/toast.ts';
import { moversOf } from '../gizmo/movers.ts';
import { roundTo, type Triple } from '../gizmo/placed.ts';
import { type Body, fallOf, type Triangles } from './fall.ts';

/** A tenth of a millimetre. */
const STEP = 1e-4;

/** The selected objects fall as one, straight down, onto what is below them, the ground that shows shadows, or to y = 0. */
export function dropSelection(session: Session, mirror: SceneMirror): void {
  const { store, state } = session;
  const movers = moversOf(store.document, state.value.selected).filter(({ kind }) => kind === 'objects');
  const falling = new Set(movers.map(({ id }) => id));
  const plan = new Box3();
  const bodies = movers.flatMap(({ id }): Body[] => {
    const mesh = mirror.objectFor(id);
    if (!mesh?.visible) return [];
    const box = new Box3().setFromObject(mesh);
    plan.union(box);
    return [{ triangles: trianglesOf(mesh), middle: (box.min.y + box.max.y) / 2 }];
  });
  const highest = Math.max(...bodies.map(({ middle }) => middle));
  const obstacles = Object.keys(store.document.objects).flatMap((id): Triangles[] => {
    const mesh = falling.has(id) ? undefined : mirror.objectFor(id);
    if (!mesh?.visible) return [];
    const box = new Box3().setFromObject(mesh);
    const isBelow =
      box.min.y <= highest &&
      box.min.x <= plan.max.x &&
      box.max.x >= plan.min.x &&
      box.min.z <= plan.max.z &&
      box.max.z >= plan.min.z;
    return isBelow ? [trianglesOf(mesh)] : [];
  });
  const fall = fallOf(bodies, obstacles, groundOf(store.document, falling, mirror));
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

/** The height of the ground that shows shadows; where it lies by itself, the others hold it. Null if there is none. */
function groundOf(
  { ground, objects }: Document,
  falling: ReadonlySet<string>,
  mirror: SceneMirror,
): number | null {
  if (!ground.shadowCatcher) return null;
  if (ground.height !== null) return ground.height;
  const others = Object.keys(objects).flatMap((id) => {
    const mesh = falling.has(id) ? undefined : mirror.objectFor(id);
    return mesh?.visible ? [new Box3().setFromObject(mesh, true).min.y] : [];
  });
  return others.length > 0 ? Math.min(...others) : null;
}

/** In world space. */
function trianglesOf(mesh: Mesh): Triangles {
  mesh.updateWorldMatrix(true, false);
  const { index, attributes } = mesh.geometry;
  const position = attributes.position;
  const count = index?.count ?? position?.count ?? 0;
  const triangles = new Float64Array(3 * count);
  const point = new Vector3();
  for (let i = 0; position && i < count; i++) {
    point.fromBufferAttribute(position, index ? index.getX(i) : i).applyMatrix4(mesh.matrixWorld);
    triangles.set([point.x, point.y, point.z], 3 * i);
  }
  return triangles;
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
