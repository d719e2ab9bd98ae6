import type { EditorStateStore } from '../state.ts';

/** Ends a comparison; the document is as it was. */
export function endComparison(state: EditorStateStore): void {
  state.set({ comparison: null });
}
