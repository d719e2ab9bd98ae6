#!/usr/bin/env node
const entry = new URL('../dist/cli/main.js', import.meta.url);
try {
  await import(entry.href);
} catch (error) {
  if (error.code !== 'ERR_MODULE_NOT_FOUND' || error.url !== entry.href) throw error;
  console.error('irradia: the command line is not built yet; run `npm run build` first');
  process.exit(1);
}
