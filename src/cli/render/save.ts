/** Files that are either whole or not there. */
import { accessSync, constants, existsSync, realpathSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { CliError } from '../command.ts';
import { checkOutput, told } from '../files.ts';

/** Refuses what cannot be written, before hours of work are done for it. */
export function checkWritable(path: string, option: string): void {
  checkOutput(path, option);
  told(option, () => accessSync(existsSync(path) ? path : dirname(path), constants.W_OK));
}

/** Writes beside the place and then moves it there, so that a crash or a full disk leaves no half file. */
export function saveWhole(path: string, option: string, data: Uint8Array): void {
  // What a link points to is replaced, not the link.
  const place = existsSync(path) ? realpathSync(path) : path;
  const fresh = join(dirname(place), `.${basename(place)}.${process.pid}.part`);
  try {
    told(option, () => {
      writeFileSync(fresh, data);
      renameSync(fresh, place);
    });
  } catch (error) {
    rmSync(fresh, { force: true });
    throw error;
  }
}

/**
 * Writes a picture that took long to render; where its place has become impossible, into the system's temporary
 * folder.
 *
 * @throws CliError that says what is wrong, and where the picture is
 */
export function savePicture(path: string, option: string, data: Uint8Array): void {
  try {
    saveWhole(path, option, data);
  } catch (error) {
    const refuge = join(tmpdir(), `irradia-${process.pid}-${basename(path)}`);
    try {
      writeFileSync(refuge, data);
    } catch {
      rmSync(refuge, { force: true });
      throw error;
    }
    throw new CliError(`${(error as Error).message}; the picture is in ${refuge}`, { cause: error });
  }
}
