/**
 * Files into the scene, whichever way they come: dropped, opened, in an archive, from an address, or handed over by the
 * server. What cannot be read changes nothing and says what is wrong with it.
 */
import type { AssetLoader } from '../../scene/assets.ts';
import { keepAsset } from '../../scene/commands.ts';
import { measuredKinds } from '../../scene/measured.ts';
import type { Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import { plural, t } from '../language/language.ts';
import type { EditorStateStore } from '../state.ts';
import { confirm } from '../ui/confirm.ts';
import { startProgress, toast, toastError } from '../ui/toast.ts';
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
    if (fileKind(file.name) === 'archive') files.push(...(await unpacked(file)));
    else files.push(file);
  if (files.some((file) => isLessonFile(file.name))) {
    await context.openLesson(files);
    return;
  }
  const toOpen = filesToOpen(files);
  if (toOpen.length === 0) {
    if (given[0] && fileKind(given[0].name) !== 'archive')
      toast('error', t('{name}: not a kind of file that Irradia opens', { name: given[0].name }), FORMATS);
    else if (given[0] && files.length > 0)
      toast(
        'error',
        t('{name}: nothing in it is a kind of file that Irradia opens', { name: given[0].name }),
        FORMATS,
      );
    return;
  }
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

/** A file, and others that it refers to, from an address. */
export async function openAddress(
  context: OpenContext,
  address: string,
  options: OpenOptions = {},
): Promise<void> {
  const name = address.replace(/[?#].*$/, '').replace(/^.*\//, '') || address;
  try {
    const { result } = await runImport(t('Fetching {name}', { name }), {
      kind: 'fetch',
      url: new URL(address, location.href).href,
    });
    if (result.kind === 'files') await openFiles(context, result.files.map(placedFile), options);
  } catch (error) {
    if (!(error instanceof ImportCancelled))
      toastError(t('{name} was not opened; the scene is unchanged', { name }), error);
  }
}

/** Those that are opened; the others are parts of them, or of no kind that is known. */
function filesToOpen(files: readonly File[]): File[] {
  const known = files.filter((file) => fileKind(file.name) !== 'unknown');
  const models = known.filter((file) => fileKind(file.name) === 'model');
  // Libraries offer the same model in several formats; the one that says most comes first.
  const order = ['glb', 'gltf', 'obj', 'ply', 'stl'];
  const rank = (file: File) => order.indexOf(file.name.replace(/^.*\./, '').toLowerCase());
  const stem = (file: File) => file.name.replace(/\.[^.]*$/, '').toLowerCase();
  const best = new Map<string, File>();
  for (const file of models.toSorted((a, b) => rank(a) - rank(b)))
    if (file.webkitRelativePath === '' || !best.has(stem(file))) best.set(pathKey(file, stem(file)), file);
  const isPart = (file: File): boolean => {
    const kind = fileKind(file.name);
    // Beside a model, images are its textures, and .json files of its folder say things about it.
    if (models.length > 0) return kind === 'image' || (kind === 'json' && file.webkitRelativePath !== '');
    // Beside a scene, too.
    return kind === 'image' && known.some((other) => fileKind(other.name) === 'json');
  };
  // Saved parameters come last: the model that they are for may be among the files.
  const late = (file: File) => (fileKind(file.name) === 'parameters' ? 1 : 0);
  const chosen = new Set(best.values());
  return known
    .filter((file) => (fileKind(file.name) === 'model' ? chosen.has(file) : !isPart(file)))
    .toSorted((a, b) => late(a) - late(b));
}

/** Files that were dropped by themselves are all meant. */
const pathKey = (file: File, stem: string): string =>
  file.webkitRelativePath === '' ? `${stem} ${file.name} ${file.lastModified} ${file.size}` : stem;

function placedFile({ path, bytes }: { path: string; bytes: Uint8Array<ArrayBuffer> }): File {
  const file = new File([bytes], path.replace(/^.*\//, ''));
  // Where it lay, as a folder chosen in a dialog would say it.
  if (path.includes('/')) Object.defineProperty(file, 'webkitRelativePath', { value: path });
  return file;
}

async function unpacked(archive: File): Promise<File[]> {
  try {
    const { result } = await runImport(t('Reading {file}', { file: archive.name }), {
      kind: 'unzip',
      archive: { path: pathOf(archive), file: archive },
    });
    // An archive is a folder, whether it has folders or not.
    return result.kind === 'files'
      ? result.files.map(({ path, bytes }) => placedFile({ path: `${archive.name}/${path}`, bytes }))
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
