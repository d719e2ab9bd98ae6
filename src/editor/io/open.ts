/**
 * Files into the scene, whichever way they come: dropped, opened, or handed over by the server.
 * What cannot be read changes nothing and says what is wrong with it.
 */
import type { AssetLoader } from '../../scene/assets.ts';
import { keepAsset } from '../../scene/commands.ts';
import { parseDocument } from '../../scene/document.ts';
import { measuredKinds } from '../../scene/measured.ts';
import type { Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import type { EditorStateStore } from '../state.ts';
import { startProgress, toast, toastError } from '../ui/toast.ts';
import { fileKind, pathOf, readAsset, readBytes } from './files.ts';
import { openBparam, openBrdf, openMeasured } from './open-model.ts';

export interface OpenContext {
  readonly store: DocumentStore;
  readonly state: EditorStateStore;
  readonly assets: AssetLoader;
  /** Replaces the scene, unless the person would lose work and decides against it. */
  replaceDocument(document: Document): Promise<boolean>;
}

export async function openFiles(context: OpenContext, files: readonly File[]): Promise<void> {
  const main = files.filter((file) => fileKind(file.name) !== 'unknown');
  const models = main.filter((file) => fileKind(file.name) === 'gltf');
  // The images and buffers that come with a .gltf are its parts, not files to open.
  const parts = models.some((file) => /\.gltf$/i.test(file.name));
  const toOpen = parts ? main.filter((file) => !['image'].includes(fileKind(file.name))) : main;
  if (toOpen.length === 0 && files[0]) {
    toast('error', `${files[0].name}: not a kind of file that Irradia opens`, FORMATS);
  }
  // Saved parameters come last: the model that they are for may be among the files.
  const order = (file: File) => (fileKind(file.name) === 'parameters' ? 1 : 0);
  for (const file of toOpen.toSorted((a, b) => order(a) - order(b))) await openFile(context, file, files);
}

const FORMATS =
  'It opens scenes (.json), models (.glb, .gltf), BRDFs (.brdf, .bparam), ' +
  `measured BRDFs: ${measuredKinds}, environments (.hdr, .exr) and images.`;

async function openFile(context: OpenContext, file: File, all: readonly File[]): Promise<void> {
  const progress = startProgress(`Reading ${file.name}`);
  progress.update(`Reading ${file.name}`, null);
  try {
    switch (fileKind(file.name)) {
      case 'document':
        await openDocument(context, file);
        break;
      case 'gltf':
        await openGltf(context, file, all, (text, fraction) => progress.update(text, fraction));
        break;
      case 'brdf':
        await openBrdf(context, file);
        break;
      case 'measured':
        await openMeasured(context, file, (text, fraction) => progress.update(text, fraction));
        break;
      case 'parameters':
        await openBparam(context, file);
        break;
      case 'environment':
        await openEnvironment(context, file);
        break;
      case 'image':
        toast(
          'info',
          `${file.name}: where should this image go?`,
          'Drop it on the square beside a value of a material.',
        );
        break;
      case 'unknown':
        break;
    }
  } catch (error) {
    toastError(`${file.name} was not opened; the scene is unchanged`, error);
  } finally {
    progress.done();
  }
}

async function openDocument({ replaceDocument }: OpenContext, file: File): Promise<void> {
  const document = parseDocument(await file.text(), file.name);
  if (await replaceDocument(document)) toast('success', `Opened ${document.name}`);
}

async function openEnvironment({ store, assets }: OpenContext, file: File): Promise<void> {
  const asset = await readAsset(file);
  // What cannot be decoded must not get into the document.
  (await assets.environment(asset)).dispose();
  store.edit(`Environment ${file.name}`, (draft) => {
    const id = keepAsset(draft, asset);
    draft.environment.source = { type: 'hdr', asset: id };
  });
  toast('success', `${file.name} lights the scene`);
}

/** Everything in the file, in one undo step; the reader is fetched only now. */
async function openGltf(
  { store, state, assets }: OpenContext,
  file: File,
  all: readonly File[],
  onProgress: (text: string, fraction: number | null) => void,
): Promise<void> {
  const read = (part: File) => readBytes(part, (fraction) => onProgress(`Reading ${part.name}`, fraction));
  const bytes = await read(file);
  const companions = new Map<string, Uint8Array>();
  if (/\.gltf$/i.test(file.name)) {
    for (const other of all) if (other !== file) companions.set(pathOf(other), await read(other));
  }
  onProgress(`Decoding ${file.name}`, null);
  const { addImported, importGltf } = await import('../../io/gltf.ts');
  const imported = await importGltf(bytes, file.name, assets, { companions });
  const { label, notes } = imported;
  let ids: string[] = [];
  store.edit(label, (draft) => {
    ids = addImported(draft, imported);
  });
  if (ids[0]) state.select({ kind: 'objects', id: ids[0] });
  toast('success', `Imported ${file.name}`);
  if (notes.length > 0) toast('info', `About ${file.name}`, notes.join('\n'));
}
