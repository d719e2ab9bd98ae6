/** Aligns and distributes what is selected along an axis of the world, whole groups as one thing each. */
import { Box3, Vector3 } from 'three/webgpu';
import { membersOf, unitsOf } from '../../../scene/groups.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import { place } from '../../../scene/transform-commands.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { moversOf } from '../gizmo/movers.ts';
import { roundTo, type Triple } from '../gizmo/placed.ts';

export type Alignment = 'low' | 'middle' | 'high' | 'spread';

/** From where to where something reaches along an axis. */
export interface Extent {
  readonly low: number;
  readonly high: number;
}

/**
 * How far each has to go, in the order given: to the lowest end of all, to the middle between the outermost, to the highest
 * end; or, spread, so that the gaps between neighbours are alike and the outermost stay.
 */
export function alignedBy(extents: readonly Extent[], alignment: Alignment): number[] {
  const low = Math.min(...extents.map((extent) => extent.low));
  const high = Math.max(...extents.map((extent) => extent.high));
  const middle = (extent: Extent) => (extent.low + extent.high) / 2;
  switch (alignment) {
    case 'low':
      return extents.map((extent) => low - extent.low);
    case 'middle':
      return extents.map((extent) => (low + high) / 2 - middle(extent));
    case 'high':
      return extents.map((extent) => high - extent.high);
    case 'spread':
      return spread(extents, middle);
  }
}

function spread(extents: readonly Extent[], middle: (extent: Extent) => number): number[] {
  const order = extents
    .map((extent, i) => ({ extent, i }))
    .sort((a, b) => middle(a.extent) - middle(b.extent));
  const [first, last] = [order[0], order.at(-1)];
  const by = extents.map(() => 0);
  if (!first || !last || order.length < 3) return by;
  const filled = order.reduce((sum, { extent }) => sum + extent.high - extent.low, 0);
  const gap = (last.extent.high - first.extent.low - filled) / (order.length - 1);
  let at = first.extent.low;
  for (const { extent, i } of order) {
    by[i] = at - extent.low;
    at += extent.high - extent.low + gap;
  }
  return by;
}

/** A tenth of a millimetre. */
const STEP = 1e-4;

export function alignSelected(
  { store, state }: Session,
  mirror: SceneMirror,
  axis: 0 | 1 | 2,
  alignment: Alignment,
): void {
  const { document } = store;
  const { groups, loose: single } = unitsOf(document, state.value.selected);
  // Beside objects, lights are not what is meant.
  const objects = single.filter(({ kind }) => kind === 'objects');
  const loose = groups.length + objects.length > 0 ? objects : single;
  const units = [...groups.map((id) => membersOf(document, id)), ...loose.map((ref) => [ref])]
    .map((members) => moversOf(document, members))
    .filter((movers) => movers.length > 0);
  const extents = units.map((movers): Extent => {
    const box = new Box3();
    for (const { kind, id, placed } of movers) {
      const mesh = kind === 'objects' ? mirror.objectFor(id) : null;
      if (mesh) box.expandByObject(mesh);
      else box.expandByPoint(new Vector3(...placed.position));
    }
    return { low: box.min.getComponent(axis), high: box.max.getComponent(axis) };
  });
  const by = alignedBy(extents, alignment);
  const moved = units.flatMap((movers, i) =>
    movers.map(({ kind, id, placed: { position, target } }) => {
      const to = (point: Triple) =>
        point.map((x, k) => (k === axis ? roundTo(x + (by[i] ?? 0), STEP) : x)) as Triple;
      return { kind, id, placement: { position: to(position), ...(target && { target: to(target) }) } };
    }),
  );
  attempt(t('It stays where it was'), () =>
    place(store, alignment === 'spread' ? t('Distribute evenly') : t('Align'), moved),
  );
}
