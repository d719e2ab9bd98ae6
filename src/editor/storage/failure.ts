/** Why the browser did not keep something, in words that say what to do. */

import { t } from '../language/language.ts';
import { messageOf } from '../ui/toast.ts';
import { DatabaseLost } from './connection.ts';

export function explainFailure(error: unknown): string {
  const name = error instanceof DOMException ? error.name : '';
  if (name === 'QuotaExceededError')
    return t(
      'The browser’s storage is full. Delete documents or versions that are no longer needed (File, Documents), or save to a file.',
    );
  if (error instanceof DatabaseLost)
    return t(
      '{reason} It is opened again as soon as the browser lets it, and everything is then written. Save to a file to be sure.',
      { reason: error.message },
    );
  if (name === 'InvalidStateError' || name === 'VersionError')
    return t('Another tab has a newer Irradia. Save to a file, then reload this page.');
  // Where there is no database at all, the error is of the page's own words for it.
  const detail = error === null || error instanceof TypeError ? '' : ` (${messageOf(error)})`;
  return t('This browser or window gives pages no storage{detail}. Save to a file before you leave.', {
    detail,
  });
}
