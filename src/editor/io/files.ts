/** Files that a person gives the page: what they are, and their bytes as a document's asset. */
import { modelExtensions } from '../../io/model-extensions.ts';
import { measuredExtensions } from '../../scene/measured.ts';
import type { Asset, Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';

const MEDIA_TYPES: Readonly<Record<string, string>> = {
  png: 'image/png',
  jpg: 'image/jpeg',
  jpeg: 'image/jpeg',
  webp: 'image/webp',
  avif: 'image/avif',
  hdr: 'image/vnd.radiance',
  exr: 'image/x-exr',
  glb: 'model/gltf-binary',
  gltf: 'model/gltf+json',
};

const MODELS: readonly string[] = modelExtensions;

const IMAGES = ['png', 'jpg', 'jpeg', 'webp', 'avif'];
const ENVIRONMENTS = ['hdr', 'exr'];

const accept = (extensions: readonly string[]) => extensions.map((extension) => `.${extension}`).join(',');

export const IMAGE_ACCEPT = accept(IMAGES);
/** Ordinary images light a scene, too, though nothing in them is brighter than white. */
export const ENVIRONMENT_ACCEPT = accept([...ENVIRONMENTS, ...IMAGES]);
export const ANY_ACCEPT = accept([
  ...['json', 'zip', 'bin', 'mtl', 'brdf', 'bparam', 'md'],
  ...MODELS,
  ...measuredExtensions,
  ...ENVIRONMENTS,
  ...IMAGES,
]);

export type FileKind =
  /** A document, a scene of three.js or a material: what is inside tells. */
  'json' | 'model' | 'archive' | 'brdf' | 'measured' | 'parameters' | 'environment' | 'image' | 'unknown';

/** The text of a lesson: `lesson.en.md`, or `lesson.md` for all languages. */
export const lessonFile = /^lesson(?:\.([a-z]{2}))?\.md$/i;
export const isLessonFile = (name: string): boolean => lessonFile.test(name);

export function extensionOf(name: string): string {
  return /\.([a-z0-9]+)$/i.exec(name)?.[1]?.toLowerCase() ?? '';
}

export function fileKind(name: string): FileKind {
  const extension = extensionOf(name);
  if (extension === 'json') return 'json';
  if (extension === 'zip') return 'archive';
  if (MODELS.includes(extension)) return 'model';
  if (extension === 'brdf') return 'brdf';
  if (measuredExtensions.includes(extension)) return 'measured';
  if (extension === 'bparam') return 'parameters';
  if (ENVIRONMENTS.includes(extension)) return 'environment';
  return IMAGES.includes(extension) ? 'image' : 'unknown';
}

export const isImageFile = (file: File) => fileKind(file.name) === 'image';
export const isEnvironmentAsset = (asset: Asset) =>
  fileKind(asset.name) === 'environment' || /radiance|exr/.test(asset.mediaType);

export function mediaTypeOf(name: string): string {
  return MEDIA_TYPES[extensionOf(name)] ?? 'application/octet-stream';
}

/** A file as the document keeps it. The browser encodes base64 off this thread and fast. */
export async function readAsset(file: File): Promise<Asset> {
  const url = await new Promise<string>((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error ?? new Error(t('The browser could not read the file.')));
    reader.readAsDataURL(file);
  });
  return { name: file.name, mediaType: mediaTypeOf(file.name), data: url.slice(url.indexOf(',') + 1) };
}

/** Where a file lay in the folder that was dropped or chosen; its name where it came alone. */
export function pathOf(file: File): string {
  return file.webkitRelativePath || file.name;
}

/** An address at which the page can show an image asset, or null if it is no image a browser shows. */
export function assetUrl(document: Document, id: string): string | null {
  const asset = document.assets[id];
  const shown =
    asset &&
    Object.values(MEDIA_TYPES).includes(asset.mediaType) &&
    IMAGES.includes(asset.mediaType.replace('image/', ''));
  return shown ? `data:${asset.mediaType};base64,${asset.data}` : null;
}

/** Opens the browser's file dialog; resolves to nothing when it is cancelled. */
export function chooseFiles(acceptList: string, multiple = false): Promise<readonly File[]> {
  return new Promise((resolve) => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = acceptList;
    input.multiple = multiple;
    input.addEventListener('change', () => resolve([...(input.files ?? [])]));
    input.addEventListener('cancel', () => resolve([]));
    input.click();
  });
}

/** Hands a file to the person. */
export function download(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser needs the address until the download has begun.
  window.setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

export function fileNameOf(sceneName: string): string {
  const safe = sceneName
    .trim()
    .replace(/[^\p{L}\p{N} ._-]+/gu, '')
    .replace(/\s+/g, '-');
  return safe || 'scene';
}
