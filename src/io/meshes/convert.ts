/** OBJ, PLY and STL as a GLB: each part an object under its own name, or under the file's. */
import type { Material } from '../../scene/schema.ts';
import type { Notes } from '../gltf/notes.ts';
import { GltfWriter } from '../gltf/writer.ts';
import { type Companions, findCompanion } from './companions.ts';
import type { Converted } from './converted.ts';
import { type MeshData, writePrimitive } from './mesh.ts';
import { mtlMaterial, readMtl } from './mtl.ts';
import { type ObjPart, readObj } from './obj.ts';
import { readPly } from './ply.ts';
import { librariesIn, materialFileOf } from './references.ts';
import { readStl } from './stl.ts';
import { TextureWriter } from './textures.ts';
import { withoutComment } from './words.ts';

const baseName = (file: string): string => file.replace(/^.*[/\\]/, '').replace(/\.[A-Za-z0-9]+$/, '');

function converted(writer: GltfWriter, materials: Material[] = []): Converted {
  return { glb: writer.finish(), materials, lights: [], primitives: [], camera: null };
}

function addObject(
  writer: GltfWriter,
  name: string,
  parts: readonly { mesh: MeshData; material?: number | undefined }[],
): number {
  const primitives = parts.map(({ mesh, material }) => writePrimitive(writer, mesh, material));
  return writer.add('nodes', { name, mesh: writer.add('meshes', { primitives }) });
}

export function convertStl(bytes: Uint8Array, file: string): Converted {
  const writer = new GltfWriter();
  for (const solid of readStl(bytes, file))
    addObject(writer, solid.name || baseName(file), [{ mesh: solid }]);
  return converted(writer);
}

export function convertPly(bytes: Uint8Array, file: string, notes: Notes): Converted {
  const mesh = readPly(bytes, file);
  if (mesh.hasColors) notes.add('its vertex colours are not read');
  const writer = new GltfWriter();
  addObject(writer, baseName(file), [{ mesh }]);
  return converted(writer);
}

/** Those that it names, else the one that is named as it is: people rename files, and not what is in them. */
function materialFiles(
  file: string,
  libraries: readonly string[],
  companions: Companions,
  notes: Notes,
): { path: string; content: Uint8Array }[] {
  const own = findCompanion(companions, materialFileOf(file));
  const found = libraries.flatMap(librariesIn).flatMap((library) => {
    const there = findCompanion(companions, library);
    if (there === null && own === null)
      notes.add(
        `its materials in ${library.slice(0, 200)} did not come along: drop both files, the folder, or a zip of it`,
      );
    return there ?? [];
  });
  return found.length > 0 || own === null ? found : [own];
}

export function convertObj(bytes: Uint8Array, file: string, companions: Companions, notes: Notes): Converted {
  const { parts, libraries } = readObj(bytes, file, notes);
  const writer = new GltfWriter();
  const textures = new TextureWriter(writer, companions, notes);
  const sources = materialFiles(file, libraries, companions, notes).flatMap(({ path, content }) =>
    readMtl(content, path),
  );
  const materials: Material[] = [];
  const indices = new Map<string, number | undefined>();
  const materialOf = (name: string | null): number | undefined => {
    if (name === null || indices.has(name)) return name === null ? undefined : indices.get(name);
    const source =
      sources.find((material) => material.name === name) ??
      sources.find((material) => withoutComment(material.name) === withoutComment(name));
    if (source === undefined && sources.length > 0)
      notes.add(`there is no material ${name} in its .mtl file`);
    const index = source && materials.push(mtlMaterial(source, textures, notes)) - 1;
    if (source) writer.add('materials', { name: name.slice(0, 200) });
    indices.set(name, index);
    return index;
  };
  const objects = new Map<string, Map<string, ObjPart[]>>();
  for (const part of parts) {
    const groups = objects.get(part.object) ?? new Map<string, ObjPart[]>();
    objects.set(part.object, groups.set(part.group, [...(groups.get(part.group) ?? []), part]));
  }
  for (const [object, groups] of objects) {
    const children = [...groups].map(([group, own]) =>
      addObject(
        writer,
        (group || object).slice(0, 180) || baseName(file),
        own.map((part) => ({ mesh: part, material: materialOf(part.material) })),
      ),
    );
    // Groups within an object are parts of it; without one they are the objects themselves.
    if (object !== '' && children.length > 1) writer.add('nodes', { name: object.slice(0, 180), children });
  }
  return converted(writer, materials);
}
