/** What the page's menus, keys and rows do to whatever is selected, whichever kind it is. */
import { duplicate, removeLight, removeObjects, rename, setField } from '../scene/commands.ts';
import { removeMaterial } from '../scene/material-commands.ts';
import type { DocumentStore } from '../scene/store.ts';
import { copyShipped, isOwn, sourceOf } from './panels/source/edit-model.ts';
import { selectedMaterial } from './selected-material.ts';
import type { EditorStateStore, EntityKind } from './state.ts';
import { toast, toastError } from './ui/toast.ts';

/** Runs an edit; one that the document refuses changes nothing and says why. */
export function attempt<T>(what: string, run: () => T): T | undefined {
  try {
    return run();
  } catch (error) {
    toastError(what, error);
    return undefined;
  }
}

export function renameEntity(store: DocumentStore, kind: EntityKind, id: string, name: string): void {
  if (store.document[kind][id]?.name !== name) attempt('Not renamed', () => rename(store, kind, id, name));
}

export function setVisible(
  store: DocumentStore,
  kind: 'lights' | 'objects',
  id: string,
  visible: boolean,
): void {
  const name = store.document[kind][id]?.name ?? id;
  setField(store, [kind, id, 'visible'], visible, `${visible ? 'Show' : 'Hide'} ${name}`);
  store.endMerge();
}

export function deleteSelected(store: DocumentStore, state: EditorStateStore): void {
  const { selection } = state.value;
  if (!selection) return;
  const { kind, id } = selection;
  attempt('Not deleted', () => {
    if (kind === 'lights') removeLight(store, id);
    else if (kind === 'objects') removeObjects(store, [id]);
    else removeMaterial(store, id);
  });
}

export function duplicateSelected(store: DocumentStore, state: EditorStateStore): void {
  const { selection } = state.value;
  if (!selection) return;
  const copy = attempt('Not duplicated', () => duplicate(store, selection.kind, selection.id));
  if (copy) state.select({ kind: selection.kind, id: copy });
}

export function toggleHelpers(store: DocumentStore): void {
  const { helpers } = store.document.view;
  setField(store, ['view', 'helpers'], !helpers, `${helpers ? 'Hide' : 'Show'} light helpers`);
  store.endMerge();
}

export function toggleBench(state: EditorStateStore): void {
  state.set({ benchOpen: !state.value.benchOpen, benchPage: false });
}

/** The bench over the whole page, and back to where it was. */
export function toggleBenchPage(state: EditorStateStore): void {
  state.set({ benchOpen: true, benchPage: !state.value.benchPage });
}

/** Opens the source of the selected material's model; of a model that ships, a copy in the scene. */
export function editSource(store: DocumentStore, state: EditorStateStore): void {
  const id = selectedMaterial(store.document, state.value.selection);
  const model = id === undefined ? undefined : store.document.materials[id]?.model;
  if (id === undefined || model === undefined) return;
  const name = isOwn(store.document, model)
    ? model
    : attempt('No source to edit', () => copyShipped(store, id));
  if (name === undefined) return;
  if (sourceOf(store.document, name) === null)
    toast('info', `${name} is measured`, 'It has no source that could be edited.');
  else state.set({ source: name });
}

export function toggleSource(store: DocumentStore, state: EditorStateStore): void {
  if (state.value.source === null) editSource(store, state);
  else state.set({ source: null });
}
