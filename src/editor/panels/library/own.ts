/** A person's own library: in the browser, and to and from files. */
import { isMaterialFile, readMaterialFile, writeMaterialFile } from '../../../io/material-file.ts';
import type { Document } from '../../../scene/schema.ts';
import { download, fileNameOf } from '../../io/files.ts';
import { t } from '../../language/language.ts';
import { explainFailure } from '../../storage/failure.ts';
import type { OwnEntry } from '../../storage/material-library.ts';
import { toast, toastError } from '../../ui/toast.ts';
import type { Thumbnails } from './thumbnails.ts';

/** Whether it was kept. */
export async function addOwn(thumbnails: Thumbnails, document: Document, id: string): Promise<boolean> {
  const title = document.materials[id]?.name ?? id;
  if (!(await put(thumbnails, title, writeMaterialFile(document, id)))) return false;
  toast('success', t('{name} is in My library', { name: title }));
  return true;
}

async function put(thumbnails: Thumbnails, title: string, text: string): Promise<boolean> {
  try {
    const storage = await thumbnails.storage();
    if (!storage) throw null;
    await storage.add(title, text);
    return true;
  } catch (error) {
    toast('error', t('{name} was not kept', { name: title }), explainFailure(error));
    return false;
  }
}

/** Whether any was. */
export async function importOwn(thumbnails: Thumbnails, files: readonly File[]): Promise<boolean> {
  let some = false;
  for (const file of files) {
    try {
      const json: unknown = JSON.parse(await file.text());
      if (!isMaterialFile(json)) throw new Error(t('It is not a material that Irradia has exported.'));
      const { material } = readMaterialFile(json, file.name);
      some = (await put(thumbnails, material.name, JSON.stringify(json))) || some;
    } catch (error) {
      toastError(t('{name} was not added to the library', { name: file.name }), error);
    }
  }
  return some;
}

export function exportOwn({ title, file }: OwnEntry): void {
  download(`${fileNameOf(title)}.material.json`, new Blob([file], { type: 'application/json' }));
}

export async function removeOwn(
  thumbnails: Thumbnails,
  entry: OwnEntry,
  refresh: () => Promise<void>,
): Promise<void> {
  const storage = await thumbnails.storage();
  await storage?.remove(entry.id);
  await refresh();
  toast('info', t('{name} is deleted', { name: entry.title }), undefined, {
    label: t('Undo'),
    run: () => void storage?.put(entry).then(refresh),
  });
}
