/** The top bar: files, what can be added, undo and redo, the term that is looked at, screenshot. */

import { actionEntry, type EntryLook } from '../../actions/entry.ts';
import { toggleBench, toggleHelpers } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { type MenuEntry, menuButton, openMenu } from '../../ui/menu.ts';
import { addEntries } from '../add-menu.ts';
import { createTitle } from '../documents/title.ts';
import { exportEntries } from '../export/entries.ts';
import { presetEntries } from '../inspector/preset.ts';
import { createLearnButton } from '../lesson/button.ts';
import { selectionEntries } from '../selection-menu.ts';
import { createSettings } from './settings.ts';
import { createTermSelect } from './term-select.ts';

export interface TopbarActions {
  openShipped(name: string): void;
  /** More pictures that can be saved; none while there is only the one that is shown. */
  tracedPictures(): MenuEntry[];
  shippedScenes: readonly { name: string; title: string }[];
}

export function createTopbar(session: Session, actions: TopbarActions): HTMLElement {
  const { store, state } = session;
  const undo = historyButton('undo', () => store.undo());
  const redo = historyButton('redo', () => store.redo());
  const shot = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Screenshot'),
      tip: t('Save the picture as PNG'),
    },
    icon('camera'),
  );
  shot.addEventListener('click', () => {
    const more = actions.tracedPictures();
    if (more.length === 0) session.actions.run('file.screenshot');
    else openMenu(shot, t('Screenshot'), [screenshotEntry(session), ...more]);
  });

  const helpers = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Light helpers'),
      tip: t('Show where the lights are'),
      keys: 'view.helpers',
    },
    icon('directional'),
  );
  helpers.addEventListener('click', () => toggleHelpers(store));

  const bench = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('BRDF bench'),
      tip: t('Plots of the selected material'),
      keys: 'view.bench',
    },
    icon('plot'),
  );
  bench.addEventListener('click', () => toggleBench(state));
  const showBench = () => {
    bench.classList.toggle('on', state.value.benchOpen);
    bench.setAttribute('aria-pressed', String(state.value.benchOpen));
  };
  state.subscribe(showBench);
  showBench();

  const update = () => {
    helpers.classList.toggle('on', store.document.view.helpers);
    helpers.setAttribute('aria-pressed', String(store.document.view.helpers));
    showHistory(undo, t('Undo'), store.canUndo, store.undoLabel);
    showHistory(redo, t('Redo'), store.canRedo, store.redoLabel);
  };
  store.subscribe(update);
  update();

  return h(
    'header',
    { class: 'topbar' },
    h('span', { class: 'brand' }, h('span', { class: 'brand-mark' }), 'Irradia'),
    menuButton(t('File'), () => fileEntries(session, actions)),
    menuButton(t('Edit'), () => editEntries(session)),
    menuButton(t('Add'), () => addEntries(session)),
    createLearnButton(session),
    h('span', { class: 'divider' }),
    undo,
    redo,
    h('span', { class: 'spacer' }),
    createTitle(session),
    h('span', { class: 'spacer' }),
    createTermSelect(session),
    bench,
    helpers,
    shot,
    createSettings(session),
  );
}

function screenshotEntry({ actions }: Session): MenuEntry {
  return actionEntry(actions, 'file.screenshot', {
    icon: 'camera',
    tip: t('The viewport as it is shown, as PNG'),
  });
}

function fileEntries(session: Session, actions: TopbarActions): MenuEntry[] {
  const entry = (id: string, look?: EntryLook) => actionEntry(session.actions, id, look);
  return [
    entry('file.new', { icon: 'file' }),
    entry('file.open', {
      icon: 'folder',
      tip: t('A scene, model, archive, .brdf, measured BRDF, HDR, EXR or image'),
    }),
    entry('file.documents', {
      icon: 'copy',
      tip: t('What this browser keeps: other documents, and versions of this one'),
    }),
    entry('file.save', { icon: 'save' }),
    entry('file.saveAs'),
    entry('file.share', {
      icon: 'link',
      tip: t('The link carries the whole document; nothing is uploaded'),
    }),
    screenshotEntry(session),
    ...actions.tracedPictures(),
    ...exportEntries(session),
    'separator',
    { heading: t('Scenes') },
    ...actions.shippedScenes.map(
      ({ name, title }): MenuEntry => ({
        label: translate(title),
        icon: 'scene',
        run: () => actions.openShipped(name),
      }),
    ),
  ];
}

function editEntries(session: Session): MenuEntry[] {
  const { store, actions } = session;
  const undo = store.undoLabel ? t('Undo: {label}', { label: translate(store.undoLabel) }) : t('Undo');
  const redo = store.redoLabel ? t('Redo: {label}', { label: translate(store.redoLabel) }) : t('Redo');
  return [
    actionEntry(actions, 'edit.undo', { icon: 'undo', label: undo }),
    actionEntry(actions, 'edit.redo', { icon: 'redo', label: redo }),
    actionEntry(actions, 'edit.history', { icon: 'list' }),
    'separator',
    ...selectionEntries(session),
    'separator',
    actionEntry(actions, 'edit.selectAll'),
    actionEntry(actions, 'edit.selectInverse'),
    actionEntry(actions, 'edit.showAll'),
    actionEntry(actions, 'edit.unlockAll'),
    actionEntry(actions, 'edit.find', { icon: 'search' }),
    actionEntry(actions, 'page.palette'),
    'separator',
    { heading: t('Preset of the effects') },
    ...presetEntries(session),
    'separator',
    actionEntry(actions, 'edit.removeUnused'),
  ];
}

function historyButton(name: 'undo' | 'redo', run: () => void): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'icon-button' }, icon(name));
  button.dataset.action = name;
  button.dataset.keys = `edit.${name}`;
  button.addEventListener('click', run);
  return button;
}

function showHistory(button: HTMLButtonElement, verb: string, possible: boolean, label: string | null): void {
  button.disabled = !possible;
  const text = label ? `${verb}: ${translate(label)}` : verb;
  button.setAttribute('aria-label', text);
  button.dataset.tip = text;
}
