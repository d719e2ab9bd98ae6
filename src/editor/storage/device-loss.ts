/** A GPU that is lost takes the picture along but nothing else: a new page opens with the same document. */

import { t, translate } from '../language/language.ts';
import { toast } from '../ui/toast.ts';
import type { Workspace } from './workspace.ts';

const KEY = 'irradia.reloaded';
/** A second loss so soon is the scene's or the driver's doing, and would only come again. */
const PATIENCE_MS = 60_000;

let reloading = false;

export function recoverFromLoss(workspace: Workspace, message: string): void {
  if (reloading) return;
  const lost = message.startsWith('the GPU was lost');
  if (lost && Date.now() - lastReload() > PATIENCE_MS && workspace.storage) {
    reloading = true;
    rememberReload();
    void workspace.reload();
    return;
  }
  toast('error', lost ? t('The GPU was lost') : t('The GPU reported an error'), translate(message), {
    label: t('Reload'),
    run: () => void workspace.reload(),
  });
}

function lastReload(): number {
  try {
    return Number(sessionStorage.getItem(KEY) ?? 0);
  } catch {
    return 0;
  }
}

function rememberReload(): void {
  try {
    sessionStorage.setItem(KEY, String(Date.now()));
  } catch {
    // Without it a second loss would reload the page again, which does no harm.
  }
}
