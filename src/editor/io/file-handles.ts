/** Which file of the disk a dropped or chosen one is, in browsers that say so: Save writes there. */

declare global {
  // Not yet in every browser, nor in TypeScript's declarations.
  interface DataTransferItem {
    getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
  }
}

const handles = new WeakMap<File, Promise<FileSystemFileHandle | null>>();

/** To be called while the drop is being told: its items are gone afterwards. Folders keep no handles. */
export function noteHandles({ items, files }: DataTransfer): void {
  const own = [...items].filter(({ kind }) => kind === 'file');
  for (const [i, item] of own.entries()) {
    const file = files[i];
    const handle = item.getAsFileSystemHandle?.();
    if (!file || !handle) continue;
    const found = handle.then((found) => (found?.kind === 'file' ? (found as FileSystemFileHandle) : null));
    // Without it, Save asks where to.
    handles.set(
      file,
      found.catch(() => null),
    );
  }
}

export function keepHandle(file: File, handle: FileSystemFileHandle | null): void {
  handles.set(file, Promise.resolve(handle));
}

export async function handleOf(file: File): Promise<FileSystemFileHandle | null> {
  return (await handles.get(file)) ?? null;
}
