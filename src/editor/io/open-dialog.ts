/** The dialog of Open…: where the browser says which files of the disk were chosen, Save writes there. */
import { t } from '../language/language.ts';
import { keepHandle } from './file-handles.ts';
import { chooseFiles, mediaTypeOf } from './files.ts';

declare global {
  // Not yet in every browser, nor in TypeScript's declarations.
  interface Window {
    showOpenFilePicker?(options: {
      id: string;
      multiple: boolean;
      types: { description: string; accept: Record<string, string[]> }[];
    }): Promise<FileSystemFileHandle[]>;
  }
}

/** Nothing when it is cancelled. @param acceptList as an input has it: `.json,.glb` */
export async function chooseFilesToOpen(acceptList: string): Promise<readonly File[]> {
  const handles = await pick(acceptList);
  if (handles === 'elsewhere') return chooseFiles(acceptList, true);
  const files = await Promise.all(handles.map((handle) => handle.getFile()));
  for (const [i, file] of files.entries()) keepHandle(file, handles[i] ?? null);
  return files;
}

async function pick(acceptList: string): Promise<readonly FileSystemFileHandle[] | 'elsewhere'> {
  const accept: Record<string, string[]> = {};
  for (const extension of acceptList.split(',')) {
    const type = mediaTypeOf(extension);
    accept[type] = [...(accept[type] ?? []), extension];
  }
  const types = [{ description: t('Files that Irradia opens'), accept }];
  try {
    // The browser remembers the folder by this name.
    const options = { id: 'irradia-open', multiple: true, types };
    return (await window.showOpenFilePicker?.(options)) ?? 'elsewhere';
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return [];
    // Within another site's frame, for one, pages may not.
    return 'elsewhere';
  }
}
