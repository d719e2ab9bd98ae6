/** Writes docs/document.schema.json, generated from src/scene/schema.ts: `node tools/document-schema.mjs`. */
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const { module } = await runnerImport(fileURLToPath(new URL('../src/scene/json-schema.ts', import.meta.url)));
writeFileSync(new URL('../docs/document.schema.json', import.meta.url), module.documentJsonSchemaText());
