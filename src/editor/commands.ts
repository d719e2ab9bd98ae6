/** What the page's menus, keys and rows do. */
import { rename, setField } from '../scene/commands.ts';
import type { DocumentStore } from '../scene/store.ts';
import { t } from './language/language.ts';
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
  if (store.document[kind][id]?.name !== name) attempt(t('Not renamed'), () => rename(store, kind, id, name));
}

export function toggleHelpers(store: DocumentStore): void {
  const { helpers } = store.document.view;
  setField(store, ['view', 'helpers'], !helpers, helpers ? t('Hide light helpers') : t('Show light helpers'));
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
    : attempt(t('No source to edit'), () => copyShipped(store, id));
  if (name === undefined) return;
  if (sourceOf(store.document, name) === null)
    toast('info', t('{name} is measured', { name }), t('It has no source that could be edited.'));
  else state.set({ source: name });
}

export function toggleSource(store: DocumentStore, state: EditorStateStore): void {
  if (state.value.source === null) editSource(store, state);
  else state.set({ source: null });
}
