/**
 * Save and Save as. Where the browser lets a page write files, Save writes the file that was saved or opened
 * last; elsewhere it hands over a download each time.
 */
import type { DocumentStore } from '../../scene/store.ts';
import { download, fileNameOf } from '../io/files.ts';
import { t } from '../language/language.ts';
import { toast, toastError } from '../ui/toast.ts';
import { fileOf } from './document-work.ts';
import type { Workspace } from './workspace.ts';

declare global {
  // Not yet in every browser, nor in TypeScript's declarations.
  interface Window {
    showSaveFilePicker?(options: {
      suggestedName: string;
      types: { description: string; accept: Record<string, string[]> }[];
    }): Promise<FileSystemFileHandle>;
  }
  interface FileSystemFileHandle {
    requestPermission?(options: { mode: 'readwrite' }): Promise<PermissionState>;
  }
}

export async function saveDocument(
  store: DocumentStore,
  workspace: Workspace,
  { as }: { as: boolean },
): Promise<void> {
  const { document } = store;
  const name = `${fileNameOf(document.name)}.json`;
  const content = fileOf(document);
  // Whoever thinks better of it need not hear that it would have failed.
  content.catch(() => {});
  try {
    if (!window.showSaveFilePicker) {
      download(name, await content);
      await workspace.savedTo(null);
      toast('success', t('Saved {name}', { name }));
      return;
    }
    const file = (as ? null : await permitted(workspace.file)) ?? (await chooseFile(name));
    if (!file) return;
    const writer = await file.createWritable();
    await writer.write(await content);
    await writer.close();
    await workspace.savedTo(file);
    toast('success', t('Saved {file}', { file: file.name }));
  } catch (error) {
    toastError(t('The document was not saved'), error);
  }
}

/** A file of an earlier visit has to be allowed again. */
async function permitted(file: FileSystemFileHandle | null): Promise<FileSystemFileHandle | null> {
  const answer = await file?.requestPermission?.({ mode: 'readwrite' });
  return answer === undefined || answer === 'granted' ? file : null;
}

/** Null when the person thinks better of it. */
async function chooseFile(suggestedName: string): Promise<FileSystemFileHandle | null> {
  const types = [{ description: t('Irradia document'), accept: { 'application/json': ['.json'] } }];
  try {
    return (await window.showSaveFilePicker?.({ suggestedName, types })) ?? null;
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return null;
    throw error;
  }
}
