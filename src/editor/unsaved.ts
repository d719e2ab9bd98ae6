/** Whether leaving the page would lose work: a look around with the camera is not work. */
import type { Document } from '../scene/schema.ts';
import type { DocumentStore } from '../scene/store.ts';
import { onlyTheCameraDiffers } from './storage/autosave.ts';

export interface Unsaved {
  /** The document has work that is in no file. */
  readonly value: boolean;
  /** The document as it is now is safe: saved, or just opened. */
  mark(): void;
}

/** `keep` keeps the document in the browser at once; false if that cannot be. */
export function trackUnsaved(store: DocumentStore, keep: () => boolean): Unsaved {
  let safe: Document = store.document;
  const differs = () => !onlyTheCameraDiffers(store.document, safe);
  store.subscribe(({ reason, document }) => {
    if (reason === 'open') safe = document;
  });
  window.addEventListener('beforeunload', (event) => {
    if (!keep() && differs()) event.preventDefault();
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
