import { isGlb, readGlb } from '../gltf/glb.ts';
import { isAddress } from './companions.ts';

const isRelative = (reference: unknown): reference is string =>
  typeof reference === 'string' && reference !== '' && !isAddress(reference);

/** The materials of an OBJ file that has their name. */
export const materialFileOf = (obj: string): string => obj.replace(/\.[^./\\]*$/, '.mtl');

/** What a line names: one file, whose name may have spaces, or several. */
export const librariesIn = (text: string): string[] =>
  /\.mtl\s+\S/i.test(text) ? text.split(/(?<=\.mtl)\s+/i) : [text];

/** The files beside it that a model file asks for, as it names them. What is wrong with it the import will say. */
export function referencesOf(path: string, bytes: Uint8Array): string[] {
  const text = () => new TextDecoder().decode(bytes);
  if (/\.(gltf|glb|json)$/i.test(path)) {
    try {
      const json = isGlb(bytes) ? new TextDecoder().decode(readGlb(bytes, path).json) : text();
      const { buffers, images, scene } = JSON.parse(json) as Record<string, unknown>;
      // A project of three.js's editor has its scene within.
      const inScene = typeof scene === 'object' && scene !== null && 'images' in scene ? scene.images : [];
      return [buffers, images, inScene]
        .flatMap((list) => (Array.isArray(list) ? (list as Record<string, unknown>[]) : []))
        .map(({ uri, url }) => uri ?? url)
        .filter(isRelative);
    } catch {
      return [];
    }
  }
  if (/\.obj$/i.test(path))
    return [...text().matchAll(/^\s*mtllib\s+(.+?)\s*$/gm)]
      .flatMap(([, name = '']) => librariesIn(name))
      .filter(isRelative);
  if (/\.mtl$/i.test(path))
    return [
      ...text().matchAll(/^\s*(?:map_\w+|norm|bump)\s+(?:-\w+\s+(?:(?:on|off|[-\d.]+)\s+)*)*(.+?)\s*$/gim),
    ]
      .map(([, name]) => name ?? '')
      .filter(isRelative);
  return [];
}
