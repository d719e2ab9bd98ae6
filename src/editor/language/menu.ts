/** The choice of the page's language, for the settings menu. A reload applies it: every text is made once. */
import type { Session } from '../session.ts';
import type { MenuEntry } from '../ui/menu.ts';
import { toast } from '../ui/toast.ts';
import { languageNames, languages, preferredLanguage, storedLanguage, storeLanguage } from './choice.ts';
import { t } from './language.ts';

export function languageEntries({ workspace }: Session): MenuEntry[] {
  const stored = storedLanguage();
  const byBrowser = languageNames[preferredLanguage(navigator.languages)];
  return [
    { heading: t('Language') },
    {
      label: t('As the browser: {language}', { language: byBrowser }),
      checked: stored === null,
      run: () => choose(null),
    },
    ...languages.map(
      (name): MenuEntry => ({
        label: languageNames[name],
        checked: stored === name,
        run: () => choose(name),
      }),
    ),
  ];

  function choose(name: typeof stored): void {
    if (name === stored) return;
    if (storeLanguage(name)) void workspace.reload();
    else
      toast('error', t('The language stays as it was'), t('This browser or window keeps nothing for pages.'));
  }
}
