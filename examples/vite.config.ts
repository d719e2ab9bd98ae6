import type { Alias } from 'vite';
import { defineConfig } from 'vite';
import { alias, packageAlias } from '../vite.shared.config.ts';

/** `npx vite examples`, after `npm run build`. */
export default defineConfig({ resolve: { alias: [...(alias as Alias[]), packageAlias] } });
