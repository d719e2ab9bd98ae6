/** What the panels share: the document, the editor's state, and the ways into the scene for files. */
import type { DocumentStore } from '../scene/store.ts';
import type { Actions } from './actions/action.ts';
import type { GpuTimesBoard } from './gpu-times.ts';
import type { EditorStateStore } from './state.ts';
import type { Workspace } from './storage/workspace.ts';
import type { Hands } from './viewport/hands.ts';

export interface Session {
  readonly store: DocumentStore;
  readonly state: EditorStateStore;
  /** What a person can do, by id. */
  readonly actions: Actions;
  /** What is kept in the browser, and which document is open. */
  readonly workspace: Workspace;
  /** What the GPU spends on the parts of a frame. */
  readonly gpuTimes: GpuTimesBoard;
  /** Something to look at, and light to see it by, in place of the present scene. */
  newScene(): void;
  /** Into a file of the person's own. */
  save(): void;
  /** Opens the name of what is selected for typing. */
  renameSelected(): void;
  /** On a narrow page: the panel that lies under the picture makes way. */
  closeSheet(): void;
  /** Puts the cursor into the outliner's search field. */
  findInScene(): void;
  /** The next click on the picture says what the lens is focused on. */
  pickFocus(): void;
  /** What is done by hand in the picture; null until there is one. */
  hands(): Hands | null;
  /** Turns the camera to what is selected, or to everything. */
  focusSelection(): void;
  /** Puts files into the scene, as a drop on the page does; images as its environment where that is what was asked for. */
  openFiles(files: readonly File[], as?: { readonly environment: boolean }): Promise<void>;
  /** Asks for files of the given kinds (`accept` of a file input). */
  chooseFiles(accept: string, multiple?: boolean): Promise<readonly File[]>;
}
