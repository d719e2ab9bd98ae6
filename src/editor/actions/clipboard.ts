/** The clipboard. */
import type { Clipboard } from '../clipboard.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { Action } from './action.ts';

export function clipboardActions({ state }: Session, clipboard: Clipboard): Action[] {
  const enabled = () => state.value.selected.length > 0;
  return [
    {
      id: 'edit.copy',
      title: t('Copy'),
      keys: ['Ctrl+C'],
      hasEvent: true,
      enabled,
      run: () => void clipboard.copy(),
    },
    {
      id: 'edit.cut',
      title: t('Cut'),
      keys: ['Ctrl+X'],
      hasEvent: true,
      enabled,
      run: () => void clipboard.cut(),
    },
    {
      id: 'edit.paste',
      title: t('Paste'),
      keys: ['Ctrl+V'],
      hasEvent: true,
      run: () => void clipboard.paste(),
    },
  ];
}
