/** Where objects and lights stand: many at once, as one undo step. */
import { entity } from './entity.ts';
import type { DocumentStore } from './store.ts';

type Triple = [number, number, number];

/** What may be given of an object (position, rotation, scale) or of a light (position, target, width, height). */
export interface Placement {
  readonly position?: Triple;
  readonly rotation?: Triple;
  readonly scale?: Triple;
  readonly target?: Triple;
  readonly width?: number;
  readonly height?: number;
}

export interface PlacedEntity {
  readonly kind: 'objects' | 'lights';
  readonly id: string;
  readonly placement: Placement;
}

/** @param merge edits in a row with the same key are one undo step: a drag */
export function place(
  store: DocumentStore,
  label: string,
  entities: readonly PlacedEntity[],
  merge?: string,
): void {
  store.edit(
    label,
    (draft) => {
      for (const { kind, id, placement } of entities) {
        const found: object = entity(draft, kind, id);
        for (const [field, value] of Object.entries(placement))
          if (field in found) Object.assign(found, { [field]: value });
      }
    },
    merge === undefined ? {} : { merge },
  );
}
