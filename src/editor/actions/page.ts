/** The page itself: its regions, its keys, and what it is. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { focusRegion } from '../ui/regions.ts';
import { toastError } from '../ui/toast.ts';
import type { Action } from './action.ts';

export function pageActions(session: Session): Action[] {
  return [
    {
      id: 'page.nextRegion',
      title: t('Go to the next part of the page'),
      keys: ['F6'],
      whileTyping: true,
      run: () => focusRegion(1),
    },
    {
      id: 'page.previousRegion',
      title: t('Go to the part of the page before'),
      keys: ['Shift+F6'],
      whileTyping: true,
      run: () => focusRegion(-1),
    },
    {
      id: 'page.palette',
      title: t('Command palette…'),
      keys: ['Ctrl+K', 'Ctrl+Shift+P'],
      whileTyping: true,
      run: () => load(async () => (await import('../panels/palette/palette.ts')).openPalette(session)),
    },
    {
      id: 'help.shortcuts',
      title: t('Keyboard shortcuts'),
      keys: ['?', 'F1'],
      run: () => load(async () => (await import('../panels/shortcuts/shortcuts.ts')).openShortcuts(session)),
    },
    {
      id: 'help.tour',
      title: t('Tour of the page'),
      run: () => load(async () => (await import('../tour/tour.ts')).startTour(session)),
    },
    {
      id: 'help.about',
      title: t('About Irradia'),
      run: () => load(async () => (await import('../panels/about/about.ts')).openAbout()),
    },
  ];
}

/** Parts of the page that come only when they are asked for. */
function load(open: () => Promise<void>): void {
  open().catch((error: unknown) => toastError(t('This part of the page did not come'), error));
}
