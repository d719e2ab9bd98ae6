/** What a person can do to the ground that shows shadows, each as one undo step. */
import type { DocumentStore } from './store.ts';

/** Shows shadows on the ground, or none; lamps then cast them. */
export function setShadowCatcher(store: DocumentStore, isShown: boolean): void {
  store.edit(isShown ? 'Show shadows on the ground' : 'Hide shadows on the ground', (draft) => {
    draft.ground.shadowCatcher = isShown;
    if (isShown) draft.effects.shadows.enabled = true;
  });
}
