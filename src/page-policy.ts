/**
 * What the lab's page may do, for whoever builds or serves it. Documents, models and links come from
 * strangers: nothing in them can become script, and the page asks no other server for anything but the
 * models that a person names by address.
 */
const directives = [
  "default-src 'none'",
  // WebAssembly is what models are compiled to; it can do nothing that the page does not hand it.
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "font-src 'self'",
  // A document's own images and files are read from addresses of these two kinds.
  "img-src 'self' data: blob:",
  "connect-src 'self' data: blob: https:",
  "worker-src 'self' blob:",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
];

/** For a `meta` element, which holds wherever the page is put. */
export const contentSecurityPolicy = directives.join('; ');

/** The page alone with itself, which is what shared memory between its threads asks for. */
export const isolationHeaders = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
} as const;

/** What a server adds, for workers, too, which no `meta` element reaches, and against being framed. */
export const pageHeaders = {
  ...isolationHeaders,
  'Content-Security-Policy': `${contentSecurityPolicy}; frame-ancestors 'none'`,
  'Referrer-Policy': 'no-referrer',
} as const;
