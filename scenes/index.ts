/** The scenes that ship: every document in this folder, loaded on demand. Nobody registers one. */
import { parseDocument } from '../src/scene/document.ts';
import type { Document } from '../src/scene/schema.ts';

const files = import.meta.glob<unknown>('./*.json', { import: 'default' });

const nameOf = (path: string): string => path.replace(/^\.\/|\.json$/g, '');

export const defaultScene = 'thesis';

/** The names of the scenes, the default one first. */
export const sceneNames: readonly string[] = Object.keys(files)
  .map(nameOf)
  .sort((a, b) => Number(b === defaultScene) - Number(a === defaultScene) || a.localeCompare(b));

/** Throws an Error that names the scenes there are, if there is no such one. */
export async function loadScene(name = defaultScene): Promise<Document> {
  const load = files[`./${name}.json`];
  if (load === undefined)
    throw new Error(`There is no scene "${name}". These ship: ${sceneNames.join(', ')}.`);
  return parseDocument(await load(), `${name}.json`);
}
