/** Which of many files, such as those of a folder, are opened; the others are parts of them. */
import { extensionOf, type FileKind, fileKind } from './files.ts';

/** The one that says most comes first: libraries offer the same model in several formats. */
const FORMATS = ['glb', 'gltf', 'obj', 'ply', 'stl'];
/** What lies beside models. */
const PARTS = ['bin', 'mtl', 'ktx2', 'tga', 'bmp', 'gif', 'tif', 'tiff', 'txt', 'md', 'html', 'pdf'];

const isLoose = (file: File): boolean => file.webkitRelativePath === '';
const isOf = (kind: FileKind) => (file: File) => fileKind(file.name) === kind;
const isModel = isOf('model');
const isImage = isOf('image');

/** In the order in which they are opened. Files that came by themselves are all meant. */
export function filesToOpen(files: readonly File[]): File[] {
  const known = files.filter((file) => !['unknown', 'archive'].includes(fileKind(file.name)));
  const models = known.filter(isModel);
  const isBesideScene = models.length > 0 || known.some(isOf('json'));
  const chosen = new Set(best(models));
  const isPart = (file: File): boolean => {
    if (isModel(file)) return !chosen.has(file);
    // Beside a model or a scene images are its textures; of a folder's several images nobody knows what they are for.
    if (isImage(file)) return isBesideScene || (!isLoose(file) && files.filter(isWorthSaying).length > 1);
    // .json files of a model's folder say things about it.
    return models.length > 0 && fileKind(file.name) === 'json' && !isLoose(file);
  };
  // Saved parameters come last: the model that they are for may be among the files.
  const late = (file: File) => (fileKind(file.name) === 'parameters' ? 1 : 0);
  return known.filter((file) => !isPart(file)).toSorted((a, b) => late(a) - late(b));
}

const isWorthSaying = (file: File): boolean => !PARTS.includes(extensionOf(file.name));

/** Those that came by themselves and are nothing that is known, nor a part of what is. */
export const strangers = (files: readonly File[]): File[] =>
  files.filter((file) => isLoose(file) && fileKind(file.name) === 'unknown' && isWorthSaying(file));

/** Of each model of a folder its best format, once. */
function best(models: readonly File[]): File[] {
  const chosen = models.filter(isLoose);
  const byName = new Map<string, File[]>();
  for (const file of models.filter((one) => !isLoose(one))) {
    const name = file.name.replace(/\.[^.]*$/, '').toLowerCase();
    byName.set(name, [...(byName.get(name) ?? []), file]);
  }
  const rank = (file: File) => FORMATS.indexOf(extensionOf(file.name));
  for (const alike of byName.values()) {
    const first = Math.min(...alike.map(rank));
    // Those of several folders are different models: "scene.gltf" is the name of thousands.
    const places = new Map<string, File>();
    for (const file of alike.filter((one) => rank(one) === first).toReversed())
      places.set(placeOf(file), file);
    chosen.push(...[...places.values()].toReversed());
  }
  return models.filter((file) => chosen.includes(file));
}

/** Its folder, but for one that is named after the format: Khronos's samples have `glTF`, `glTF-Draco` and more. */
const placeOf = ({ webkitRelativePath }: File): string =>
  webkitRelativePath
    .split('/')
    .slice(0, -1)
    .filter((folder) => !/^gltf([-_ ].*)?$/i.test(folder))
    .join('/');
