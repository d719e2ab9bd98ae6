/**
 * Files into the scene, whichever way they come: dropped, opened, in an archive, from an address, or handed over by the
 * server. What cannot be read changes nothing and says what is wrong with it.
 */
import { unescaped } from '../../io/meshes/companions.ts';
import type { AssetLoader } from '../../scene/assets.ts';
import { keepAsset } from '../../scene/commands.ts';
import { measuredKinds } from '../../scene/measured.ts';
import type { Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import { plural, t } from '../language/language.ts';
import type { EditorStateStore } from '../state.ts';
import { confirm } from '../ui/confirm.ts';
import { startProgress, toast, toastError } from '../ui/toast.ts';
import { filesToOpen, strangers } from './chosen-files.ts';
import { fileKind, isLessonFile, pathOf, readAsset } from './files.ts';
import { ImportCancelled } from './importer/import-job.ts';
import { importFile, runImport } from './open-import.ts';
import { openBparam, openBrdf, openMeasured } from './open-model.ts';

export interface OpenContext {
  readonly store: DocumentStore;
  readonly state: EditorStateStore;
  readonly assets: AssetLoader;
  /** Replaces the scene, unless the person would lose work and decides against it. Save then writes to `file`. */
  replaceDocument(document: Document, file: FileSystemFileHandle | null): Promise<boolean>;
  /** There is nothing in the scene but what a new one begins with. */
  isNew(): boolean;
  /** Brings what is selected into view. */
  lookAtSelection(): void;
  /** A lesson's text, its scene and what lies beside them. */
  openLesson(files: readonly File[]): Promise<void>;
}

const FORMATS = t(
  'It opens scenes (.json, those of three.js too), models (.glb, .gltf, .obj, .ply, .stl), folders and .zip archives of them, BRDFs (.brdf, .bparam), measured BRDFs: {measured}, environments (.hdr, .exr) and images.',
  { measured: measuredKinds },
);

const isArchive = (file: File): boolean => fileKind(file.name) === 'archive';

/** Bytes of the archives inside an archive. */
const MOST_INSIDE = 1024 * 1024 * 1024;

/** More models than this at once are asked about: an archive may be a whole library. */
const MANY_MODELS = 12;

export interface OpenOptions {
  /** Images are for the environment: that is what the person was asked for. */
  readonly environment?: boolean;
  /** The scene is the stage that was put up for what is opened. */
  readonly onStage?: boolean;
}

export async function openFiles(
  context: OpenContext,
  given: readonly File[],
  options: OpenOptions = {},
): Promise<void> {
  const files: File[] = [];
  for (const file of given)
    if (isArchive(file)) files.push(...(await unpacked(file)));
    else files.push(file);
  if (files.some((file) => isLessonFile(file.name))) {
    await context.openLesson(files);
    return;
  }
  const toOpen = filesToOpen(files);
  const odd = strangers(files);
  if (odd.length > 0 || toOpen.length === 0) tellUnopened(odd.length > 0 ? odd : given, files.length > 0);
  if (toOpen.length === 0) return;
  const models = toOpen.filter((file) => fileKind(file.name) === 'model').length;
  if (models > MANY_MODELS) {
    const detail = t('They come with all that lies beside them. Each is an undo step of its own.');
    if (
      !(await confirm(plural(models, 'Import {count} model?', 'Import {count} models?'), detail, t('Import')))
    )
      return;
  }
  for (const file of toOpen) if (!(await openFile(context, file, files, options))) return;
}

/** @param isUnpacked false where an archive could not be read, which has been told */
function tellUnopened(files: readonly File[], isUnpacked: boolean): void {
  const [first] = files;
  if (first === undefined) return;
  const folder = first.webkitRelativePath.split('/')[0] || (isArchive(first) ? first.name : '');
  if (folder === '') {
    const name = files.map((file) => file.name).join(', ');
    toast('error', t('{name}: not a kind of file that Irradia opens', { name }), FORMATS);
  } else if (isUnpacked)
    toast(
      'error',
      t('{name}: nothing in it is a kind of file that Irradia opens', { name: folder }),
      FORMATS,
    );
}

/** The last part of an address, to be read. */
export function nameOfAddress(address: string): string {
  const last = address
    .replace(/[?#].*$/, '')
    .replace(/\/+$/, '')
    .replace(/^.*\//, '');
  return unescaped(last) || address;
}

/** A file, and others that it refers to, from an address. @returns whether it could be fetched */
export async function openAddress(
  context: OpenContext,
  address: string,
  options: OpenOptions = {},
): Promise<boolean> {
  const name = nameOfAddress(address);
  try {
    if (!URL.canParse(address, location.href)) throw new Error(t('{address} is not an address', { address }));
    const { result } = await runImport(t('Fetching {name}', { name }), {
      kind: 'fetch',
      url: new URL(address, location.href).href,
    });
    if (result.kind === 'files') await openFiles(context, result.files.map(placedFile), options);
    return true;
  } catch (error) {
    if (!(error instanceof ImportCancelled))
      toastError(t('{name} was not opened; the scene is unchanged', { name }), error);
    return false;
  }
}

function placedFile({ path, bytes }: { path: string; bytes: Uint8Array<ArrayBuffer> }): File {
  const file = new File([bytes], path.replace(/^.*\//, ''));
  // Where it lay, as a folder chosen in a dialog would say it.
  if (path.includes('/')) Object.defineProperty(file, 'webkitRelativePath', { value: path });
  return file;
}

/** The files of an archive, and of the archives in it: model libraries put the author's own into theirs. */
async function unpacked(archive: File): Promise<File[]> {
  const files: File[] = [];
  const inside: File[] = [];
  for (const file of await filesOf(archive)) (isArchive(file) ? inside : files).push(file);
  let size = 0;
  for (const inner of inside) {
    const found = await filesOf(inner);
    for (const file of found) size += file.size;
    files.push(...found.filter((file) => !isArchive(file)));
    // A few bytes of an archive can be many archives of a gigabyte each.
    if (size > MOST_INSIDE) break;
  }
  return files;
}

async function filesOf(archive: File): Promise<File[]> {
  try {
    const { result } = await runImport(t('Reading {file}', { file: archive.name }), {
      kind: 'unzip',
      archive: { path: pathOf(archive), file: archive },
    });
    // An archive is a folder, whether it has folders or not.
    return result.kind === 'files'
      ? result.files.map(({ path, bytes }) => placedFile({ path: `${pathOf(archive)}/${path}`, bytes }))
      : [];
  } catch (error) {
    if (!(error instanceof ImportCancelled))
      toastError(t('{file} was not opened; the scene is unchanged', { file: archive.name }), error);
    return [];
  }
}

/** False where the person gave up: what follows is not wanted, either. */
async function openFile(
  context: OpenContext,
  file: File,
  all: readonly File[],
  options: OpenOptions,
): Promise<boolean> {
  const kind = fileKind(file.name);
  const progress =
    kind === 'json' || kind === 'model' ? null : startProgress(t('Reading {file}', { file: file.name }));
  progress?.update(t('Reading {file}', { file: file.name }), null);
  try {
    switch (kind) {
      case 'json':
      case 'model':
        await importFile(context, file, all, options);
        break;
      case 'brdf':
        await openBrdf(context, file);
        break;
      case 'measured':
        await openMeasured(context, file, (text, fraction) => progress?.update(text, fraction));
        break;
      case 'parameters':
        await openBparam(context, file);
        break;
      case 'environment':
        await openEnvironment(context, file);
        break;
      case 'image':
        await openImage(context, file, options.environment === true);
        break;
      case 'archive':
      case 'unknown':
        break;
    }
  } catch (error) {
    if (error instanceof ImportCancelled) return false;
    toastError(t('{file} was not opened; the scene is unchanged', { file: file.name }), error);
  } finally {
    progress?.done();
  }
  return true;
}

async function openEnvironment({ store, assets }: OpenContext, file: File): Promise<void> {
  const asset = await readAsset(file);
  // What cannot be decoded must not get into the document.
  (await assets.environment(asset)).dispose();
  store.edit(t('Environment {file}', { file: file.name }), (draft) => {
    const id = keepAsset(draft, asset);
    draft.environment.source = { type: 'hdr', asset: id };
  });
  toast('success', t('{file} lights the scene', { file: file.name }));
}

/** An image twice as wide as high shows all directions; of any other nobody knows where it should go. */
async function openImage(context: OpenContext, file: File, environment: boolean): Promise<void> {
  const bitmap = await createImageBitmap(file).catch(() => null);
  if (bitmap === null) throw new Error(t('It is not an image that this browser can read.'));
  const { width, height } = bitmap;
  bitmap.close();
  if (environment || (width === 2 * height && width >= 256)) {
    await openEnvironment(context, file);
    const detail = t(
      'It has 8 bits: nothing in it is brighter than white, so the sun is not. HDR and EXR images have it.',
    );
    toast('info', t('About {file}', { file: file.name }), detail);
    return;
  }
  toast(
    'info',
    t('{file}: where should this image go?', { file: file.name }),
    t('Drop it on the square beside a value of a material, or choose it as the environment of the scene.'),
  );
}
