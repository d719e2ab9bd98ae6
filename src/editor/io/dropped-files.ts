/** The files of a drop, those inside dropped folders too: a .gltf comes with its buffers and images. */

import { noteHandles } from './file-handles.ts';

/** Enough for any model; a dropped home directory ends here. */
const MOST_FILES = 1000;

export async function droppedFiles(transfer: DataTransfer): Promise<File[]> {
  // Both lists are emptied as soon as the event is over, so they are read before the first await.
  const entries = [...transfer.items]
    .map((item) => item.webkitGetAsEntry())
    .filter((entry) => entry !== null);
  noteHandles(transfer);
  const plain = [...transfer.files];
  if (!entries.some((entry) => entry.isDirectory)) return plain;
  const files: File[] = [];
  for (const entry of entries) await collect(entry, '', files);
  return files;
}

async function collect(entry: FileSystemEntry, folder: string, files: File[]): Promise<void> {
  if (files.length >= MOST_FILES) return;
  const path = folder ? `${folder}/${entry.name}` : entry.name;
  if (isFile(entry)) {
    const file = await new Promise<File>((resolve, reject) => entry.file(resolve, reject));
    // Where it lay, as a folder chosen in a dialog would say it.
    Object.defineProperty(file, 'webkitRelativePath', { value: path });
    files.push(file);
    return;
  }
  if (!isDirectory(entry)) return;
  const reader = entry.createReader();
  // A reader gives a part of the folder at a time, and nothing when it is through.
  for (;;) {
    const part = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (part.length === 0) return;
    for (const child of part) await collect(child, path, files);
  }
}

const isFile = (entry: FileSystemEntry): entry is FileSystemFileEntry => entry.isFile;
const isDirectory = (entry: FileSystemEntry): entry is FileSystemDirectoryEntry => entry.isDirectory;
