/** Where the page's first scene comes from: one that ships, or one that the server hands over. */
import { loadScene as loadShipped, sceneNames } from '../../scenes/index.ts';
import { parseDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';
import { t } from './language/language.ts';

export const shippedScenes = sceneNames.map((name) => ({ name, title: titleOf(name) }));

function titleOf(name: string): string {
  const words = name.replace(/-/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Whether an address's word for a scene, null for none, means one that ships. */
export const isShipped = (name: string | null): boolean => !name?.includes('/');

/** A shipped scene by its name (the default one without), or a document at an address of this server. */
export async function loadScene(name?: string): Promise<Document> {
  if (!name?.includes('/')) return loadShipped(name);
  const response = await fetch(new URL(name, location.href));
  if (!response.ok)
    throw new Error(
      t('{name}: the server answered {status} {statusText}', {
        name,
        status: response.status,
        statusText: response.statusText,
      }),
    );
  return parseDocument(await response.text(), name);
}
