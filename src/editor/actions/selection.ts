/** What is selected, and what is done to all of it. */
import { groupOf } from '../../scene/groups.ts';
import { setLocked, setVisible } from '../../scene/selection-commands.ts';
import { attempt } from '../commands.ts';
import { t } from '../language/language.ts';
import {
  allMembers,
  assignLastMaterial,
  deleteSelected,
  duplicateSelected,
  forgetAlone,
  giveOwn,
  groupSelected,
  isAlone,
  selectEverything,
  selectedMembers,
  selectGroups,
  selectInverse,
  selectSameMaterial,
  shiftSelected,
  toggleAlone,
  toggleLocked,
  toggleVisible,
  ungroupSelected,
} from '../selection.ts';
import type { Session } from '../session.ts';
import type { Action } from './action.ts';

export function selectionActions(session: Session): Action[] {
  const { store, state } = session;
  const something = () => state.value.selected.length > 0;
  const members = () => selectedMembers(session);
  const someMembers = () => members().length > 0;
  const objects = () => state.value.selected.filter(({ kind }) => kind === 'objects').length;
  const grouped = () => members().some((ref) => groupOf(store.document, ref) !== null);
  store.subscribe(({ reason }) => {
    if (reason === 'open') forgetAlone();
  });
  return [
    {
      id: 'edit.rename',
      title: t('Rename'),
      keys: ['F2'],
      enabled: something,
      run: () => session.renameSelected(),
    },
    {
      id: 'edit.duplicate',
      title: t('Duplicate'),
      keys: ['Ctrl+D'],
      enabled: something,
      run: () => duplicateSelected(session),
    },
    {
      id: 'edit.delete',
      title: t('Delete'),
      keys: ['Delete', 'Backspace'],
      enabled: something,
      run: () => deleteSelected(session),
    },
    {
      id: 'edit.group',
      title: t('Group'),
      keys: ['Ctrl+G'],
      enabled: someMembers,
      run: () => groupSelected(session),
    },
    {
      id: 'edit.ungroup',
      title: t('Ungroup'),
      keys: ['Ctrl+Shift+G'],
      enabled: grouped,
      run: () => ungroupSelected(session),
    },
    {
      id: 'edit.orderUp',
      title: t('Up in the outliner'),
      keys: ['Alt+ArrowUp'],
      enabled: something,
      run: () => shiftSelected(session, -1),
    },
    {
      id: 'edit.orderDown',
      title: t('Down in the outliner'),
      keys: ['Alt+ArrowDown'],
      enabled: something,
      run: () => shiftSelected(session, 1),
    },
    {
      id: 'edit.hide',
      title: t('Hide or show'),
      keys: ['Shift+H'],
      enabled: someMembers,
      on: () => members().every(({ kind, id }) => store.document[kind][id]?.visible === false),
      run: () => toggleVisible(session),
    },
    {
      id: 'edit.showAll',
      title: t('Show everything that is hidden'),
      keys: ['Ctrl+Shift+H'],
      run: () =>
        attempt(t('Nothing was hidden or shown'), () => setVisible(store, allMembers(session), true)),
    },
    {
      id: 'edit.alone',
      title: t('Show it alone, or everything again'),
      keys: ['/'],
      enabled: () => someMembers() || isAlone(session),
      on: () => isAlone(session),
      run: () => toggleAlone(session),
    },
    {
      id: 'edit.lock',
      title: t('Lock or unlock'),
      keys: ['Shift+L'],
      enabled: someMembers,
      on: () => members().every(({ kind, id }) => store.document[kind][id]?.locked),
      run: () => toggleLocked(session),
    },
    {
      id: 'edit.unlockAll',
      title: t('Unlock everything'),
      keys: ['Ctrl+Shift+L'],
      run: () =>
        attempt(t('Nothing was locked or unlocked'), () => setLocked(store, allMembers(session), false)),
    },
    {
      id: 'edit.selectAll',
      title: t('Select everything'),
      keys: ['Ctrl+A'],
      run: () => selectEverything(session),
    },
    {
      id: 'edit.selectInverse',
      title: t('Select the others instead'),
      keys: ['Ctrl+I'],
      run: () => selectInverse(session),
    },
    {
      id: 'edit.selectGroup',
      title: t('Select all of its group'),
      keys: ['Shift+G'],
      enabled: grouped,
      run: () => selectGroups(session),
    },
    {
      id: 'edit.selectSameMaterial',
      title: t('Select all of the same material'),
      keys: ['Shift+M'],
      enabled: () => state.value.selected.some(({ kind }) => kind !== 'lights'),
      run: () => selectSameMaterial(session),
    },
    {
      id: 'edit.assignLastMaterial',
      title: t('Give all of them the material of the last one'),
      enabled: () => objects() > 1 && state.value.selection?.kind === 'objects',
      run: () => assignLastMaterial(session),
    },
    {
      id: 'edit.ownMaterial',
      title: t('A copy of the material for it alone'),
      enabled: () => objects() > 0,
      run: () => giveOwn(session),
    },
    {
      id: 'edit.align',
      title: t('Align…'),
      enabled: () => members().length > 1,
      run: () => session.hands()?.openAlignMenu(),
    },
    {
      id: 'edit.find',
      title: t('Search the scene'),
      keys: ['Ctrl+F'],
      run: () => session.findInScene(),
    },
    { id: 'edit.selectNothing', title: t('Select nothing'), keys: ['Escape'], run: () => state.select(null) },
  ];
}
