/** Documents, files and pictures. */
import { t } from '../language/language.ts';
import { openDocuments } from '../panels/documents/documents.ts';
import type { Session } from '../session.ts';
import { openShare } from '../share/share.ts';
import type { Action } from './action.ts';

export interface FileActions {
  open(): void;
  saveAs(): void;
  screenshot(): void;
}

export function fileActions(session: Session, { open, saveAs, screenshot }: FileActions): Action[] {
  return [
    { id: 'file.new', title: t('New'), run: session.newScene },
    { id: 'file.open', title: t('Open…'), keys: ['Ctrl+O'], run: open },
    {
      id: 'file.documents',
      title: t('Documents…'),
      keys: ['Ctrl+Shift+O'],
      run: () => void openDocuments(session),
    },
    { id: 'file.save', title: t('Save'), keys: ['Ctrl+S'], run: session.save },
    { id: 'file.saveAs', title: t('Save as…'), keys: ['Ctrl+Shift+S'], run: saveAs },
    { id: 'file.share', title: t('Share as a link…'), run: () => openShare(session) },
    { id: 'file.screenshot', title: t('Screenshot'), run: screenshot },
  ];
}
