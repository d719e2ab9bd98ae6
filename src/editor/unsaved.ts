/** Whether the person would lose work: a look around with the camera is not work. */
import type { Document } from '../scene/schema.ts';
import type { DocumentStore } from '../scene/store.ts';

export interface Unsaved {
  readonly value: boolean;
  /** The document as it is now is safe: saved, or just opened. */
  mark(): void;
}

export function trackUnsaved(store: DocumentStore): Unsaved {
  let safe: Document = store.document;
  const differs = () => {
    const { document } = store;
    const parts = Object.keys(document) as (keyof Document)[];
    return parts.some((part) => part !== 'camera' && part !== 'view' && document[part] !== safe[part]);
  };
  store.subscribe(({ reason, document }) => {
    if (reason === 'open') safe = document;
  });
  window.addEventListener('beforeunload', (event) => {
    if (differs()) event.preventDefault();
  });
  return {
    get value() {
      return differs();
    },
    mark() {
      safe = store.document;
    },
  };
}
