/** Why the browser did not keep something, in words that say what to do. */

import { t } from '../language/language.ts';
import { messageOf } from '../ui/toast.ts';

export function explainFailure(error: unknown): string {
  const name = error instanceof DOMException ? error.name : '';
  if (name === 'QuotaExceededError')
    return t(
      'The browser’s storage is full. Delete documents or versions that are no longer needed (File, Documents), or save to a file.',
    );
  if (name === 'InvalidStateError' || name === 'VersionError')
    return t('Another tab has a newer Irradia. Save to a file, then reload this page.');
  const detail = error === null ? '' : ` (${messageOf(error)})`;
  return t('This browser or window gives pages no storage{detail}. Save to a file before you leave.', {
    detail,
  });
}
