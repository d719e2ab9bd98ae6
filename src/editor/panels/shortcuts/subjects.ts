/** The actions of the page by their subjects, and the keys that belong to fields and menus. */

import type { Action } from '../../actions/action.ts';
import { keysText } from '../../actions/keys.ts';
import { t } from '../../language/language.ts';

/** What is before the point of an action's id. */
function titleOf(subject: string): string {
  switch (subject) {
    case 'file':
      return t('Documents, files and pictures');
    case 'edit':
      return t('Edit');
    case 'select':
      return t('Select');
    case 'add':
      return t('Add');
    case 'scene':
      return t('Scenes');
    case 'material':
      return t('Materials');
    case 'learn':
      return t('Lessons');
    case 'view':
      return t('What is seen');
    case 'tool':
    case 'viewport':
    case 'camera':
    case 'transform':
    case 'gizmo':
      return t('In the viewport');
    case 'page':
    case 'help':
      return t('The page and help');
    default:
      return t('More');
  }
}

export interface Subject {
  readonly title: string;
  readonly actions: readonly Action[];
}

/** In the order in which they first appear. */
export function subjectsOf(actions: readonly Action[]): Subject[] {
  const subjects = new Map<string, Action[]>();
  for (const action of actions) {
    const title = titleOf(action.id.split('.')[0] ?? '');
    subjects.set(title, [...(subjects.get(title) ?? []), action]);
  }
  return [...subjects].map(([title, list]) => ({ title, actions: list }));
}

/** Keys of what has the focus, which stay as they are; as the person's own keyboard has them. */
export function fixedKeys(): { readonly title: string; readonly keys: string }[] {
  return [
    { title: t('Number: a step more or less; Shift finer, Alt coarser'), keys: '↑ ↓' },
    { title: t('Drag over a number: Shift finer, Ctrl coarser, Esc as it was'), keys: '↔' },
    { title: t('During a drag: along an axis, with Shift across it'), keys: 'X Y Z' },
    {
      title: t('During a drag: how far, with arithmetic; a space before the next axis'),
      keys: '0–9 . - * /',
    },
    { title: t('Slider: a hundredth; Shift finer'), keys: '← → ↑ ↓' },
    {
      title: t('Slider: a tenth, and to either end'),
      keys: ['PageUp', 'PageDown', 'Home', 'End'].map((keys) => keysText(keys)).join(' '),
    },
    {
      title: t('Menus: entries, the menus beside, the entry that begins with a letter'),
      keys: '↑ ↓ ← → A–Z',
    },
    { title: t('Leave a menu, a dialog or a field as it was'), keys: 'Esc' },
    { title: t('The next control, or the one before'), keys: `Tab ${keysText('Shift+Tab')}` },
  ];
}
