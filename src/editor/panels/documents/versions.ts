/** The versions of a document: those with a name, and those that were kept every ten minutes of work. */

import { t } from '../../language/language.ts';
import type { KeptDocument, Version } from '../../storage/kept-documents.ts';
import { timeText } from '../../storage/workspace.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { toast } from '../../ui/toast.ts';
import { run } from './detail.ts';
import type { DocumentsContext } from './documents.ts';
import { agoText } from './format.ts';

export function createVersions(
  context: DocumentsContext,
  kept: KeptDocument,
  versions: readonly Version[],
): HTMLElement {
  const { session, storage, refresh } = context;
  const name = h('input', {
    type: 'text',
    class: 'text-field',
    placeholder: t('Name the present state'),
    maxlength: 200,
    'aria-label': t('Name of a new version'),
  });
  const keep = h('button', { type: 'submit', class: 'text-button' }, t('Keep version'));
  const form = h('form', { class: 'version-form' }, name, keep);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const title = name.value.trim();
    if (title === '') {
      name.focus();
      return;
    }
    void run(t('The version was not kept'), async () => {
      await storage.addVersion(kept.id, session.store.document, title);
      await refresh();
    });
  });
  const list = h('ul', { class: 'version-list' }, ...versions.map((version) => row(context, kept, version)));
  return h(
    'section',
    { class: 'versions' },
    h('h2', {}, t('Versions')),
    kept.id === session.workspace.kept?.id ? form : null,
    versions.length > 0
      ? list
      : h('p', { class: 'hint' }, t('One is kept by itself every ten minutes of work.')),
  );
}

function row(context: DocumentsContext, kept: KeptDocument, version: Version): HTMLElement {
  const { session, storage, refresh, close } = context;
  const { workspace } = session;
  const restore = h(
    'button',
    { type: 'button', class: 'text-button', tip: t('Go back to this version; undo leads back again') },
    t('Restore'),
  );
  restore.addEventListener('click', () => {
    void run(t('The version was not restored'), async () => {
      close();
      if (kept.id !== workspace.kept?.id && !(await workspace.openKept(kept))) return;
      await workspace.restore(version);
      toast('success', t('Restored {title}', { title: titleOf(version) }), undefined, {
        label: t('Undo'),
        run: () => session.store.undo(),
      });
    });
  });
  const remove = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-label': t('Delete {title}', { title: titleOf(version) }),
      tip: t('Delete this version'),
    },
    icon('trash'),
  );
  remove.addEventListener('click', () => {
    void run(t('The version was not deleted'), async () => {
      // What cannot be read anymore can still be deleted.
      const document = await storage.loadVersion(version).catch(() => null);
      await storage.deleteVersion(version);
      await refresh();
      const putBack = async () => {
        if (document) await storage.putVersion(version, document);
        await refresh();
      };
      toast(
        'info',
        t('Deleted {title}', { title: titleOf(version) }),
        undefined,
        document
          ? {
              label: t('Undo'),
              run: () => void run(t('{label} did not work', { label: t('Undo') }), putBack),
            }
          : undefined,
      );
    });
  });
  return h(
    'li',
    {},
    h(
      'span',
      { class: 'version-name', tip: timeText(version.time) },
      h('strong', { class: version.name === null ? 'automatic' : undefined }, version.name ?? t('Automatic')),
      h('span', {}, agoText(version.time)),
    ),
    restore,
    remove,
  );
}

function titleOf({ name, time }: Version): string {
  return name === null ? t('the version kept {time}', { time: timeText(time) }) : `“${name}”`;
}
