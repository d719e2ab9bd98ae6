/**
 * The lab without a network. The first visit stores every file of the build; later ones take those files
 * from there. The page itself comes from the network when there is one, so that a new build is seen at once
 * and nothing else that is later served at this address is hidden.
 */

/** The build puts these two before this file: vite.config.ts. */
declare const FILES: readonly string[];
declare const BUILD: string;

/** What of a service worker's own declarations is needed; TypeScript has them only without those of pages. */
interface ExtendableEvent extends Event {
  waitUntil(promise: Promise<unknown>): void;
}
interface FetchEvent extends ExtendableEvent {
  readonly request: Request;
  respondWith(response: Promise<Response>): void;
}
interface Scope extends EventTarget {
  skipWaiting(): Promise<void>;
  readonly clients: { claim(): Promise<void> };
  readonly registration: ServiceWorkerRegistration;
}
const scope = self as unknown as Scope;

const CACHE = `irradia-${BUILD}`;
/** A network that does not answer by then is as good as none. */
const PATIENCE_MS = 3000;

const home = scope.registration.scope;
const listed = new Set(FILES.map((file) => new URL(file, home).href));

/** Files with a hash in their names are the same in every build that has them. */
const isHashed = (url: string) => url.startsWith(`${home}assets/`);

scope.addEventListener('install', (event) => (event as ExtendableEvent).waitUntil(store()));
scope.addEventListener('activate', (event) => (event as ExtendableEvent).waitUntil(takeOver()));
scope.addEventListener('fetch', (event) => answer(event as FetchEvent));
scope.addEventListener('message', (event) => {
  const { data, ports } = event as MessageEvent<{ lists: string } | 'take over'>;
  if (data === 'take over') void scope.skipWaiting();
  else ports[0]?.postMessage(listed.has(data.lists));
});

/** One after the other, so as not to be in the way of the page. */
async function store(): Promise<void> {
  const cache = await caches.open(CACHE);
  for (const url of listed) {
    const known = isHashed(url) ? await caches.match(url) : undefined;
    const response = known ?? (await fetch(url, { cache: 'no-cache' }));
    if (!response.ok) throw new Error(`${url}: ${response.status}`);
    await cache.put(url, response);
  }
}

/** The build before this one stays: other tabs may still have its page, and ask for parts of it. */
async function takeOver(): Promise<void> {
  const others = (await caches.keys()).filter((name) => name.startsWith('irradia-') && name !== CACHE);
  for (const name of others.slice(0, -1)) await caches.delete(name);
  await scope.clients.claim();
}

function answer(event: FetchEvent): void {
  const { request } = event;
  if (request.method !== 'GET') return;
  const url = new URL(request.url);
  url.hash = '';
  const isPage =
    request.mode === 'navigate' && [home, `${home}index.html`].includes(url.origin + url.pathname);
  if (isPage) event.respondWith(page(request));
  else if (listed.has(url.href) || isHashed(url.href)) event.respondWith(file(url.href));
}

async function page(request: Request): Promise<Response> {
  const stored = await stores(home);
  try {
    const response = await (stored ? hurried(request) : fetch(request));
    if (response.status < 500 || !stored) return isolated(response);
  } catch (error) {
    if (!stored) throw error;
  }
  return isolated(stored);
}

function hurried(request: Request): Promise<Response> {
  const late = new Promise<never>((_, reject) => {
    setTimeout(() => reject(new Error('The network does not answer.')), PATIENCE_MS);
  });
  return Promise.race([fetch(request), late]);
}

async function file(url: string): Promise<Response> {
  const stored = (await stores(url)) ?? (isHashed(url) ? await caches.match(url) : undefined);
  return isolated(stored ?? (await fetch(url)));
}

async function stores(url: string): Promise<Response | undefined> {
  return (await caches.open(CACHE)).match(url);
}

/** Also on a host that cannot send them, the answer has the headers that threads with shared memory ask for. */
function isolated(response: Response): Response {
  if (response.type !== 'basic' && response.type !== 'default') return response;
  const headers = new Headers(response.headers);
  headers.set('Cross-Origin-Opener-Policy', 'same-origin');
  headers.set('Cross-Origin-Embedder-Policy', 'require-corp');
  const { status, statusText } = response;
  return new Response(response.body, { status, statusText, headers });
}
