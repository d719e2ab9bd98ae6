import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';
import { contentSecurityPolicy, isolationHeaders } from './src/page-policy.ts';
import { licences, packagesOf } from './vite.licences.config.ts';
import { alias, repository, target } from './vite.shared.config.ts';

const editor = `${repository}src/editor/`;
const SERVICE_WORKER = 'service-worker';

/** The page may do only what src/page-policy.ts says, wherever it is put. */
const policy: Plugin = {
  name: 'irradia:policy',
  transformIndexHtml: () => [
    {
      tag: 'meta',
      attrs: { 'http-equiv': 'Content-Security-Policy', content: contentSecurityPolicy },
      injectTo: 'head-prepend',
    },
  ],
};

/** A plain script, which the page waits for: no module is so early. */
const FIRST_PAINT = 'theme/first-paint.js';
const firstPaint: Plugin = {
  name: 'irradia:first-paint',
  enforce: 'post',
  transformIndexHtml: {
    order: 'post',
    handler: () => [{ tag: 'script', attrs: { src: `./${FIRST_PAINT}` }, injectTo: 'head' }],
  },
  generateBundle() {
    this.emitFile({
      type: 'asset',
      fileName: FIRST_PAINT,
      source: readFileSync(`${editor}${FIRST_PAINT}`, 'utf8'),
    });
  },
};

/** Every browser that runs the page reads WOFF2: the other formats of the formulas' fonts are left out. */
const formulaFonts: Plugin = {
  name: 'irradia:formula-fonts',
  enforce: 'pre',
  transform(code, id) {
    if (!id.endsWith('katex.min.css')) return null;
    return { code: code.replace(/,url\([^)]*\.(?:woff|ttf)\) format\("[a-z]*"\)/g, ''), map: null };
  },
};

/** What makes the page installable, and the list of files that its service worker stores. */
const offline: Plugin = {
  name: 'irradia:offline',
  apply: 'build',
  enforce: 'post',
  transformIndexHtml: () => [
    { tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' }, injectTo: 'head' },
    { tag: 'link', attrs: { rel: 'apple-touch-icon', href: './icon-apple-180.png' }, injectTo: 'head' },
  ],
  generateBundle(_, bundle) {
    const emit = (fileName: string, source: Uint8Array | string) =>
      this.emitFile({ type: 'asset', fileName, source });
    for (const name of ['icon-192', 'icon-512', 'icon-maskable-512', 'icon-apple-180'])
      emit(`${name}.png`, readFileSync(`${editor}pwa/${name}.png`));
    emit('manifest.webmanifest', readFileSync(`${editor}pwa/manifest.json`, 'utf8'));

    const worker = bundle[`${SERVICE_WORKER}.js`];
    if (worker?.type !== 'chunk') throw new Error('the service worker was not built');
    const hash = createHash('sha256');
    const files: string[] = [];
    for (const [name, file] of Object.entries(bundle).sort(([a], [b]) => a.localeCompare(b))) {
      if (name.endsWith('.map')) continue;
      hash.update(name).update(file.type === 'chunk' ? file.code : file.source);
      // The page is asked for by its folder.
      if (file !== worker) files.push(name === 'index.html' ? './' : `./${name}`);
    }
    const build = hash.digest('hex').slice(0, 16);
    worker.code = `const FILES=${JSON.stringify(files)},BUILD=${JSON.stringify(build)};\n${worker.code}`;
  },
};

/** The lab: the page in src/editor, built into dist/lab. It may be served from any folder. */
export default defineConfig({
  root: editor,
  base: './',
  publicDir: false,
  cacheDir: `${repository}node_modules/.vite/lab`,
  resolve: { alias },
  // The last lists what the others have made.
  plugins: [policy, formulaFonts, licences, firstPaint, offline],
  server: {
    fs: { allow: [repository] },
    headers: isolationHeaders,
  },
  build: {
    target,
    // The first that have light-dark(), of which the themes are made: what stands in for it elsewhere is one theme for all.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
    outDir: `${repository}dist/lab`,
    emptyOutDir: true,
    sourcemap: true,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 2000,
    // The page's policy takes fonts from its own server alone.
    assetsInlineLimit: (file) => (file.endsWith('.woff2') ? false : undefined),
    rolldownOptions: {
      input: { index: `${editor}index.html`, [SERVICE_WORKER]: `${editor}pwa/service-worker.ts` },
      output: {
        // Its address must not change: it is how the browser finds a newer one.
        entryFileNames: ({ name }) =>
          name === SERVICE_WORKER ? `${SERVICE_WORKER}.js` : 'assets/[name]-[hash].js',
      },
    },
  },
  worker: { format: 'es', plugins: () => [packagesOf] },
});
