/** The scenes that ship: every document in `scenes/`, found by the build, fetched when asked for. */
import { parseDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';

const files = import.meta.glob<unknown>('../../scenes/*.json', { import: 'default' });

const nameOf = (path: string) => path.replace(/^.*\/|\.json$/g, '');

const DEFAULT = 'thesis';

export const shippedScenes = Object.keys(files)
  .map((path) => ({ name: nameOf(path), title: titleOf(nameOf(path)) }))
  .sort((a, b) => Number(b.name === DEFAULT) - Number(a.name === DEFAULT) || a.name.localeCompare(b.name));

function titleOf(name: string): string {
  const words = name.replace(/-/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** A shipped scene by its name, or any document at an address of this server. */
export async function loadScene(name: string = DEFAULT): Promise<Document> {
  const load = Object.entries(files).find(([path]) => nameOf(path) === name)?.[1];
  if (load) return parseDocument(await load(), `${name}.json`);
  if (!name.includes('/')) {
    const known = shippedScenes.map((scene) => scene.name).join(', ');
    throw new Error(`There is no scene "${name}". These ship: ${known}.`);
  }
  const response = await fetch(new URL(name, location.href));
  if (!response.ok) throw new Error(`${name}: the server answered ${response.status} ${response.statusText}`);
  return parseDocument(await response.text(), name);
}
