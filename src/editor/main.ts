/** The page: puts the document, the panels and the viewport together and opens the first scene. */
import { modelStage } from '../io/stage.ts';
import { createRenderer, type RealtimeRenderer } from '../realtime/renderer.ts';
import { AssetLoader } from '../scene/assets.ts';
import { addLight, addObject } from '../scene/commands.ts';
import { createDocument } from '../scene/document.ts';
import { SceneMirror } from '../scene/mirror.ts';
import { pageAssets } from '../scene/page-assets.ts';
import type { Document } from '../scene/schema.ts';
import { DocumentStore } from '../scene/store.ts';
import { Actions } from './actions/action.ts';
import { addActions, sceneActions } from './actions/add.ts';
import { cameraActions } from './actions/camera.ts';
import { clipboardActions } from './actions/clipboard.ts';
import { editActions } from './actions/edit.ts';
import { fileActions } from './actions/file.ts';
import { keptKeymap } from './actions/keymap.ts';
import { learnActions, learning } from './actions/learn.ts';
import { loadMaterialTools, materialActions, materialTools } from './actions/material.ts';
import { pageActions } from './actions/page.ts';
import { selectionActions } from './actions/selection.ts';
import { installShortcuts } from './actions/shortcuts.ts';
import { toolActions } from './actions/tools.ts';
import { viewActions } from './actions/view.ts';
import { installClipboard } from './clipboard.ts';
import { installErrorReports, showStartFailure } from './errors.ts';
import { GpuTimesBoard } from './gpu-times.ts';
import { showComing } from './io/coming-environment.ts';
import { computedElsewhere } from './io/computed-environment.ts';
import { installDrop } from './io/drop.ts';
import { ANY_ACCEPT, chooseFiles, download, fileNameOf } from './io/files.ts';
import { environmentElsewhere, openElsewhere } from './io/importer/import-job.ts';
import { nameOfAddress, type OpenContext, openAddress, openFiles } from './io/open.ts';
import { chooseFilesToOpen } from './io/open-dialog.ts';
import { patternElsewhere } from './io/pattern.ts';
import { t } from './language/language.ts';
import { createBench } from './panels/bench/bench.ts';
import { exportActions } from './panels/export/entries.ts';
import { createInspector } from './panels/inspector/inspector.ts';
import type { MaterialContext } from './panels/library/tools.ts';
import { createOutliner } from './panels/outliner/outliner.ts';
import { createSheetTabs } from './panels/sheets.ts';
import { createSourcePanel } from './panels/source/source.ts';
import { FrameTimes } from './panels/status/frame-times.ts';
import { createStatus } from './panels/status/status.ts';
import { createTopbar } from './panels/topbar/topbar.ts';
import { installOffline } from './pwa/offline.ts';
import { isShipped, loadScene, shippedScenes } from './scenes.ts';
import type { Session } from './session.ts';
import { documentOfLink, isLink } from './share/link.ts';
import { EditorStateStore } from './state.ts';
import { recoverFromLoss } from './storage/device-loss.ts';
import { saveDocument } from './storage/save-file.ts';
import { Workspace } from './storage/workspace.ts';
import { followSystemTheme } from './theme/theme.ts';
import { inviteToTour } from './tour/invitation.ts';
import { h } from './ui/dom.ts';
import { onCancelledGesture } from './ui/gesture.ts';
import { installLongPress } from './ui/long-press.ts';
import type { MenuEntry } from './ui/menu.ts';
import { startProgress, toast, toastError } from './ui/toast.ts';
import { installTooltip } from './ui/tooltip.ts';
import { installTouchDrag } from './ui/touch-drag.ts';
import { PresetOfDevice } from './viewport/adopt-preset.ts';
import { Viewport } from './viewport/viewport.ts';

/** For the browser's console and for tests: `irradia.store.edit(...)`, `await irradia.ready`. */
export interface IrradiaConsole {
  readonly store: DocumentStore;
  readonly mirror: SceneMirror;
  /** Resolves when the first scene is complete and its first frame is on the screen. */
  readonly ready: Promise<void>;
  /** Null until the renderer has started, and where it could not. */
  renderer: RealtimeRenderer | null;
  viewport: Viewport | null;
}

declare global {
  interface Window {
    irradia: IrradiaConsole;
  }
}

/** How long the first frame waits for assets. */
const PATIENCE_MS = 400;

installErrorReports();
followSystemTheme();
installLongPress();
installTouchDrag();
installTooltip((action) => session.actions.shortcut(action));

const store = new DocumentStore(createDocument());
const state = new EditorStateStore();
const workspace = new Workspace({
  store,
  state,
  picture: (width, height) => window.irradia.viewport?.smallPicture(width, height) ?? null,
});
const assets = new AssetLoader({
  ...pageAssets,
  openGltf: openElsewhere,
  decodeEnvironment: environmentElsewhere,
  computeEnvironment: computedElsewhere,
  onPreset: showComing,
  drawPattern: patternElsewhere,
});
const mirror = new SceneMirror({
  assets,
  onError: (message) => toast('error', t('A part of the scene is missing'), message),
});

const opening: OpenContext = {
  store,
  state,
  assets,
  replaceDocument: (next, file) => workspace.replace(next, null, file),
  isNew: () => placeholder !== null && sameThings(store.document, placeholder),
  lookAtSelection: () => session.focusSelection(),
  openLesson: async (files) => (await learning(session)).openFiles(files),
};
const session: Session = {
  store,
  state,
  actions: new Actions(keptKeymap()),
  workspace,
  gpuTimes: new GpuTimesBoard(),
  newScene,
  save,
  openFiles: (files, as) => openFiles(opening, files, as),
  chooseFiles,
  renameSelected: () => void showOutliner().then(() => outliner.renameSelected()),
  findInScene: () => void showOutliner().then(() => outliner.search()),
  closeSheet: () => sheets.open(null),
  focusSelection: () => window.irradia.viewport?.hands.focusSelection(),
  pickFocus: () => window.irradia.viewport?.hands.pickFocus(),
  hands: () => window.irradia.viewport?.hands ?? null,
};

/** A scene that is nobody's work: it gets the effects that this device draws without effort. */
let fresh: Document | null = null;
/** What New has made last. */
let placeholder: Document | null = null;
let presetOfDevice: PresetOfDevice | null = null;

const outliner = createOutliner(session);
const sheets = createSheetTabs(session);
const inspector = createInspector(session);
const times = new FrameTimes();
const status = createStatus(state, times, session.gpuTimes);
const canvas = h('canvas', { tabindex: 0, role: 'application', 'aria-label': t('Viewport') });
const loading = h('div', { class: 'loading' }, t('Loading…'));
const emptyHint = h(
  'p',
  { class: 'empty-hint', hidden: true },
  t(
    'There is nothing here yet. Drop files on the page, or add something: by the menu, or a right click here.',
  ),
);
const view = h('main', { class: 'viewport' }, canvas, emptyHint, loading);

document.getElementById('app')?.replaceChildren(
  createTopbar(session, {
    openShipped,
    tracedPictures,
    shippedScenes,
  }),
  h('div', { class: 'panel-left' }, outliner.element),
  view,
  createSourcePanel(session),
  h('div', { class: 'panel-right' }, inspector),
  createBench(session, {
    geometryOf: (id) => mirror.objectFor(id)?.geometry,
    viewport: canvas,
    renderer: () => window.irradia.renderer,
  }),
  status.element,
  sheets.element,
);
store.subscribe(({ reason, document }) => {
  emptyHint.hidden = Object.keys(document.objects).length > 0;
  if (reason !== 'open') return;
  times.clear();
  // Once it is on the screen; at the page's start there is no viewport yet, and start() sees to it.
  if (document === fresh)
    void window.irradia.viewport
      ?.nextFrame()
      .then(() => mirror.settled())
      .then(adoptPreset, () => {
        // The viewport has told why nothing is drawn.
      });
});
const materials: MaterialContext = {
  session,
  mirror,
  assets,
  view,
  outliner: outliner.element,
  inspector,
  renderer: () => window.irradia.renderer,
  viewport: () => window.irradia.viewport,
};
installDrop(view, (files) => void session.openFiles(files));
session.actions.add(fileActions(session, { open, saveAs, screenshot }));
session.actions.add(
  exportActions({
    session,
    mirror,
    renderer: () => window.irradia.renderer,
    redraw: () => window.irradia.viewport?.refresh(),
    whole: async () => window.irradia.viewport?.whole(),
  }),
);
session.actions.add(materialActions(materials));
session.actions.add(editActions(session));
session.actions.add(clipboardActions(session, installClipboard(session)));
session.actions.add(selectionActions(session));
session.actions.add(addActions(session));
session.actions.add(sceneActions(shippedScenes, openShipped));
session.actions.add(viewActions(session));
session.actions.add(toolActions(session));
session.actions.add(cameraActions(session));
session.actions.add(learnActions(session));
session.actions.add(pageActions(session));
installShortcuts(session.actions);
onCancelledGesture((gesture) => store.abandon(gesture));

window.addEventListener('hashchange', () => void openLink());

window.irradia = { store, mirror, renderer: null, viewport: null, ready: start() };
window.irradia.ready
  .catch(() => {
    // start() has told the person; this keeps the browser from telling it again.
  })
  .then(() => installOffline(() => workspace.reload()));
void window.irradia.ready.catch(() => null).then(() => loadMaterialTools(materials));
// What is typed right after its keys is meant for it.
void window.irradia.ready
  .catch(() => null)
  .then(() => import('./panels/palette/palette.ts'))
  .catch(() => null);
// A page without a renderer takes files, too.
void window.irradia.ready.then(importAddressed, importAddressed);
void window.irradia.ready.then(openAddressedLesson, openAddressedLesson);

async function adoptPreset(): Promise<void> {
  if (presetOfDevice && fresh) await presetOfDevice.adopt(fresh);
}

/** What the page's address says: a document in its fragment, a scene by its name, or the first one. */
async function addressedDocument(): Promise<Document> {
  if (isLink(location.hash)) return documentOfLink(location.hash);
  const query = new URLSearchParams(location.search);
  const [scene, model, lesson] = [query.get('scene'), query.get('import'), query.get('lesson')];
  if (lesson !== null) return (await learning(session)).addressedDocument(lesson);
  // A model that is linked to is what the person wants to see, and nothing else.
  if (scene === null && model !== null)
    return modelStage(nameOfAddress(model).replace(/\.[A-Za-z0-9]+$/, ''));
  const document = await loadScene(scene ?? undefined);
  if (isShipped(scene)) fresh = document;
  return document;
}

/** The text of the lesson whose scene is open. */
async function openAddressedLesson(): Promise<void> {
  const lesson = new URLSearchParams(location.search).get('lesson');
  if (lesson !== null) await (await learning(session)).openAddressed(lesson);
}

/** What the page's address asks to bring into the scene. */
async function importAddressed(): Promise<void> {
  const query = new URLSearchParams(location.search);
  const address = query.get('import');
  if (address === null) return;
  // What did not come is asked for again by a reload; what did must not come once more.
  if (!(await openAddress(opening, address, { onStage: !query.has('scene') }))) return;
  const rest = new URL(location.href);
  rest.searchParams.delete('import');
  history.replaceState(history.state, '', rest);
}

/** A link that is pasted into the address bar of a page that is open loads no new page. */
async function openLink(): Promise<void> {
  if (!isLink(location.hash)) return;
  try {
    await workspace.replace(await documentOfLink(location.hash), location.hash);
  } catch (error) {
    toastError(t('The link was not opened; the scene is unchanged'), error);
  }
}

async function start(): Promise<void> {
  const [renderer] = await Promise.allSettled([
    createRenderer({
      canvas,
      onError: (message) => recoverFromLoss(workspace, message),
    }),
    workspace.start(addressedDocument),
  ]);
  mirror.apply(store.document);
  if (renderer.status === 'rejected') {
    showStartFailure(view, renderer.reason);
    throw renderer.reason;
  }
  window.irradia.renderer = renderer.value;
  // What comes at once is worth waiting for: a first frame without it would only be drawn again.
  let complete = false;
  const settled = mirror.settled().then(() => {
    complete = true;
  });
  await Promise.race([settled, new Promise((resolve) => setTimeout(resolve, PATIENCE_MS))]);
  // What comes while the first frame is drawn is not in it.
  const isWhole = complete;
  const viewport = new Viewport({
    element: view,
    canvas,
    session,
    mirror,
    renderer: renderer.value,
    times,
    onFigures: status.show,
  });
  window.irradia.viewport = viewport;
  presetOfDevice = new PresetOfDevice(session, renderer.value, viewport);
  await viewport.nextFrame().finally(() => loading.remove());
  if (!isWhole) {
    await settled;
    viewport.refresh();
    await viewport.nextFrame();
  }
  void adoptPreset();
  inviteToTour(view, () => session.actions.run('help.tour'));
}

/** It may be a sheet that is closed, or the library may have its place. */
async function showOutliner(): Promise<void> {
  if (outliner.element.checkVisibility()) return;
  sheets.open('panel-left');
  if (session.actions.get('material.library').on?.()) (await materialTools(materials)).library.close();
}

function newScene(): void {
  // Not an empty void: something to look at, and light to see it by.
  const made = new DocumentStore(createDocument());
  addLight(made, 'ambient');
  addLight(made, 'directional');
  addObject(made, 'sphere');
  fresh = made.document;
  placeholder = fresh;
  void workspace.replace(fresh, '');
}

/** Nothing was added, changed or taken away; documents share what they have in common. */
function sameThings(a: Document, b: Document): boolean {
  return (['lights', 'objects', 'materials', 'environment'] as const).every((part) => a[part] === b[part]);
}

async function openShipped(name: string): Promise<void> {
  const progress = startProgress(t('Opening {name}', { name }));
  progress.update(t('Opening {name}', { name }), null);
  try {
    fresh = await loadScene(name);
    await workspace.replace(fresh, `?scene=${encodeURIComponent(name)}`);
  } catch (error) {
    toastError(t('{name} could not be opened; the scene is unchanged', { name }), error);
  } finally {
    progress.done();
  }
}

async function open(): Promise<void> {
  await session.openFiles(await chooseFilesToOpen(ANY_ACCEPT));
}

function save(): void {
  void saveDocument(store, workspace, { as: false });
}

function saveAs(): void {
  void saveDocument(store, workspace, { as: true });
}

function screenshot(): Promise<void> {
  return savePicture('.png', (viewport) => viewport.screenshot());
}

function tracedPictures(): MenuEntry[] {
  if (!window.irradia.viewport?.tracing.texture) return [];
  return [
    {
      label: t('Path traced picture, PNG'),
      icon: 'image',
      tip: t('All of it, as the screen shows it'),
      run: () => savePicture('-path-traced.png', (viewport) => viewport.tracedScreenshot()),
    },
    {
      label: t('Path traced radiance, EXR'),
      icon: 'image',
      tip: t('Linear Rec. 709 before exposure and tone mapping; the header has the number of samples'),
      run: () => savePicture('-path-traced.exr', async ({ tracing }) => new Blob([await tracing.exr()])),
    },
  ];
}

async function savePicture(ending: string, picture: (viewport: Viewport) => Promise<Blob>): Promise<void> {
  const { viewport } = window.irradia;
  if (!viewport) return;
  try {
    download(`${fileNameOf(store.document.name)}${ending}`, await picture(viewport));
  } catch (error) {
    toastError(t('The picture was not saved'), error);
  }
}
