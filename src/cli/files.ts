import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { CliError } from './command.ts';

/** What the system's codes mean to a person who named a file. */
const FAULTS: Readonly<Record<string, string>> = {
  ENOENT: 'there is no such file',
  ENOTDIR: 'a part of the path is no folder',
  EISDIR: 'is a folder; expected a file',
  EACCES: 'permission denied',
  EPERM: 'permission denied',
  EROFS: 'the file system is read-only',
  ENOSPC: 'no space left on the disk',
  ENAMETOOLONG: 'the name is too long',
};

/** Runs a file operation; what the system refuses becomes an error that names the argument. */
export function told<T>(argument: string, operation: () => T): T {
  try {
    return operation();
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    throw new CliError(`${argument}: ${FAULTS[code ?? ''] ?? message}`, { cause: error });
  }
}

/** @throws CliError that names the file, if it cannot be read */
export const readInput = (path: string): Buffer => told(path, () => readFileSync(path));

function isFolder(path: string): boolean {
  try {
    return statSync(path).isDirectory();
  } catch {
    return false;
  }
}

/**
 * Refuses what cannot be an output file, before any work is done for it.
 *
 * @param option as it was given, for the message: `-o a.png`
 */
export function checkOutput(path: string, option: string): void {
  const folder = dirname(path);
  if (!isFolder(folder)) throw new CliError(`${option}: there is no folder ${folder}`);
  if (isFolder(path)) throw new CliError(`${option}: ${FAULTS.EISDIR}`);
}

export const writeOutput = (path: string, option: string, data: Uint8Array): void =>
  told(option, () => writeFileSync(path, data));
