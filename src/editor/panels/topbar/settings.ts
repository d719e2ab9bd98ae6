/** How the page looks and works, in one menu behind a gear: for this browser, not of the document. */
import { actionEntry } from '../../actions/entry.ts';
import { t } from '../../language/language.ts';
import { languageEntries } from '../../language/menu.ts';
import type { Session } from '../../session.ts';
import { chooseTheme, chosenTheme, themeNames, themes } from '../../theme/theme.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { asMenuButton, type MenuEntry } from '../../ui/menu.ts';

export function createSettings(session: Session): HTMLButtonElement {
  const label = t('Settings');
  const button = h(
    'button',
    {
      type: 'button',
      class: 'icon-button settings',
      'aria-label': label,
      tip: t('Theme, language, shortcuts, help'),
    },
    icon('gear'),
  );
  return asMenuButton(button, label, () => settingsEntries(session));
}

function settingsEntries(session: Session): MenuEntry[] {
  const { actions } = session;
  const names = themeNames();
  return [
    { heading: t('Theme') },
    ...themes.map(
      (theme): MenuEntry => ({
        label: names[theme],
        checked: theme === chosenTheme(),
        run: () => chooseTheme(theme),
      }),
    ),
    'separator',
    ...languageEntries(session),
    'separator',
    actionEntry(actions, 'help.shortcuts', { icon: 'keyboard', label: t('Keyboard shortcuts…') }),
    actionEntry(actions, 'help.tour', { icon: 'eye' }),
    actionEntry(actions, 'help.about', { icon: 'info', label: t('About Irradia…') }),
  ];
}
