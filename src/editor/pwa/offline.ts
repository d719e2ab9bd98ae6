/** Makes the page work without a network, and tells when a newer build is ready. */

import { t } from '../language/language.ts';
import { toast } from '../ui/toast.ts';

/** Between looks for a newer build, by a page that stays open. */
const LOOK_MS = 60 * 60_000;

/** `reload` loads the page anew with what is open. */
export async function installOffline(reload: () => Promise<void>): Promise<void> {
  // The development server has no build that could be stored.
  if (import.meta.hot || !navigator.serviceWorker) return;
  let registration: ServiceWorkerRegistration;
  try {
    registration = await navigator.serviceWorker.register('./service-worker.js');
  } catch {
    // Private windows and unsafe addresses have none of this; the page needs its network, nothing else.
    return;
  }
  if (registration?.waiting) void offer(registration.waiting, reload);
  registration?.addEventListener('updatefound', () => {
    const worker = registration.installing;
    worker?.addEventListener('statechange', () => {
      // The very first one has nothing to replace.
      if (worker.state === 'installed' && navigator.serviceWorker.controller) void offer(worker, reload);
    });
  });
  let looked = Date.now();
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden' || Date.now() - looked < LOOK_MS) return;
    looked = Date.now();
    void registration.update().catch(() => {});
  });
}

async function offer(worker: ServiceWorker, reload: () => Promise<void>): Promise<void> {
  // The page comes from the network and may be of that build already.
  if (await lists(worker, document.querySelector<HTMLScriptElement>('script[type=module]')?.src ?? ''))
    return;
  toast('info', t('A new version of Irradia is ready'), t('What you are doing is kept.'), {
    label: t('Reload'),
    run: () => {
      navigator.serviceWorker.addEventListener('controllerchange', () => void reload(), { once: true });
      worker.postMessage('take over');
    },
  });
}

function lists(worker: ServiceWorker, url: string): Promise<boolean> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => resolve(data === true);
    worker.postMessage({ lists: url }, [port2]);
  });
}
