/** What this page is, its version, and whose work it contains. */
import { version } from '../../../../package.json';
import { t } from '../../language/language.ts';
import { openDialog } from '../../ui/dialog.ts';
import { h } from '../../ui/dom.ts';

/** Made by the build (vite.config.ts) from the packages that are in it. */
const LICENCES = './licences.txt';

export function openAbout(): void {
  const text = h('pre', { class: 'licences', tabindex: 0, 'aria-label': t('Licences') }, t('Loading…'));
  openDialog(
    { title: t('About Irradia'), class: 'about' },
    h(
      'div',
      { class: 'about-body' },
      h('p', {}, h('strong', {}, 'Irradia'), ` ${version}`),
      h('p', {}, t('A lab for physically based lighting: a BRDF is one file.')),
      h('p', {}, t('Documents and files stay in this browser; nothing is uploaded.')),
      h('h2', {}, t('Licences of Irradia and of what is in it')),
      text,
    ),
  );
  void fetch(LICENCES)
    .then((response) => (response.ok ? response.text() : Promise.reject(new Error(response.statusText))))
    .then(
      (licences) => {
        text.textContent = licences;
      },
      () => {
        text.textContent = t('They are in the file licences.txt beside the page, which did not come.');
      },
    );
}
