/**
 * Materials of an OBJ file (.mtl) as `principled`. Phong's exponent becomes the roughness whose highlight is as wide; the
 * fields for physically based shading that Blender and others write (Pr, Pm, Ps, Pc, Pcr, aniso, norm) are taken as they
 * are. Formats: Alias|Wavefront, "Advanced Visualizer Manual", appendix B1; Clara.io, "Extending Wavefront MTL", 2012.
 */
import { materialDefaults } from '../../scene/material-schema.ts';
import type { Material, ScaledTextureRef, TextureRef } from '../../scene/schema.ts';
import type { Notes } from '../gltf/notes.ts';
import { applyLayers, noLayers } from '../material-layers.ts';
import { ModelFileError } from './error.ts';
import { phongRoughness } from './phong.ts';
import type { TextureWriter } from './textures.ts';
import { wordsOf } from './words.ts';

/** What a line of the file says, and which line it is. */
interface Statement {
  words: string[];
  line: number;
}
export interface MtlMaterial {
  name: string;
  file: string;
  statements: Map<string, Statement>;
}

/** @throws ModelFileError with the line that is wrong */
export function readMtl(bytes: Uint8Array, file: string): MtlMaterial[] {
  const materials: MtlMaterial[] = [];
  for (const [i, text] of new TextDecoder()
    .decode(bytes)
    .split(/\r\n|\r|\n/)
    .entries()) {
    const [word = '', ...words] = wordsOf(text.trim());
    if (word === '') continue;
    if (word === 'newmtl') {
      materials.push({ name: words.join(' '), file, statements: new Map() });
      continue;
    }
    const material = materials.at(-1);
    if (!material)
      throw new ModelFileError(file, `line ${i + 1}`, `"${word.slice(0, 40)}" before the first newmtl`);
    material.statements.set(word.toLowerCase(), { words, line: i + 1 });
  }
  return materials;
}

type Rgb = [number, number, number];
const clamp = (x: number, min = 0, max = 1): number => Math.min(max, Math.max(min, x));

export function mtlMaterial(source: MtlMaterial, textures: TextureWriter, notes: Notes): Material {
  const { statements, file } = source;
  const name = source.name.slice(0, 180) || 'Material';
  const numbers = (key: string, count: number): number[] | undefined => {
    const found = statements.get(key);
    if (!found) return undefined;
    if (found.words[0] === 'spectral' || found.words[0] === 'xyz') {
      notes.add(`${name}: ${key} is given as ${found.words[0]}, which is not read`);
      return undefined;
    }
    const values = found.words.slice(0, count).map(Number);
    // One value stands for all three.
    while (values.length < count && values[0] !== undefined) values.push(values[0]);
    if (values.length === 0 || !values.every(Number.isFinite))
      throw new ModelFileError(file, `line ${found.line}`, `expected ${count} numbers after "${key}"`);
    return values;
  };
  const one = (key: string) => numbers(key, 1)?.[0];
  const color = (key: string) => numbers(key, 3)?.map((value) => clamp(value)) as Rgb | undefined;
  const map = (keys: readonly string[], values: Partial<TextureRef>): ScaledTextureRef | null => {
    const found = keys.map((key) => statements.get(key)).find((statement) => statement !== undefined);
    return found ? textureOf(found, textures, values) : null;
  };

  const exponent = one('ns');
  const opacity = clamp(one('d') ?? 1 - (one('tr') ?? 0));
  const material: Material = { ...structuredClone(materialDefaults), name, model: 'principled' };
  const base = map(['map_kd'], { colorSpace: 'srgb' });
  const diffuse = color('kd') ?? [1, 1, 1];
  material.parameters = {
    // Some programs write black beside a map, which they take instead of it.
    baseColor: base && Math.max(...diffuse) === 0 ? [1, 1, 1] : diffuse,
    metallic: clamp(one('pm') ?? 0),
    roughness: clamp(one('pr') ?? (exponent === undefined ? 1 : phongRoughness(exponent))),
  };
  const put = (parameter: string, texture: ScaledTextureRef | null): void => {
    if (texture === null) return;
    const { scale: _, ...ref } = texture;
    material.textures[parameter] = ref;
    // A map of a value that the file leaves at nothing is that value.
    if (material.parameters[parameter] === 0) material.parameters[parameter] = 1;
  };
  put('baseColor', base);
  put('roughness', map(['map_pr'], { channel: 'g' }));
  put('metallic', map(['map_pm'], { channel: 'b' }));
  // Ks without fields for physically based shading: as strong as that value of principled, .5 being 4 % head-on.
  const specular = color('ks');
  const isPhysical = statements.has('pr') || statements.has('pm');
  applyLayers(
    material,
    {
      ...noLayers,
      specular: { ...noLayers.specular, ior: Math.max(1, one('ni') ?? 1.5) },
      clearcoat: { ...noLayers.clearcoat, factor: clamp(one('pc') ?? 0), roughness: clamp(one('pcr') ?? 0) },
      sheen: {
        ...noLayers.sheen,
        color: (numbers('ps', 3)?.map((value) => clamp(value)) as Rgb | undefined) ?? [0, 0, 0],
      },
      anisotropy: { ...noLayers.anisotropy, strength: clamp(one('aniso') ?? 0) },
    },
    notes,
  );
  if (!isPhysical && specular)
    material.parameters.specular = specular.reduce((sum, value) => sum + value, 0) / 3;

  material.normalMap = map(['norm', 'map_kn'], {});
  material.bumpMap = map(['map_bump', 'bump'], { channel: 'r' });
  material.emissiveMap = map(['map_ke'], { colorSpace: 'srgb' });
  const emissive = numbers('ke', 3) ?? (material.emissiveMap ? [1, 1, 1] : [0, 0, 0]);
  const brightest = Math.max(...emissive);
  if (brightest > 0) {
    material.emissive = emissive.map((value) => clamp(value / brightest)) as Rgb;
    material.emissiveIntensity = clamp(brightest, 0, 1e9);
  }
  // Beside the colours of the same image its opacity is what is left of it, its alpha.
  const isOfColors = fileOf(statements.get('map_d')) === fileOf(statements.get('map_kd'));
  material.opacityMap = map(['map_d'], { channel: isOfColors ? 'a' : 'r' });
  material.opacity = opacity;
  if (opacity < 1 || material.opacityMap) material.alphaMode = 'blend';
  for (const [key, what] of unread) if (statements.has(key)) notes.add(`${name}: ${what} is not read`);
  return material;
}

const unread: readonly (readonly [string, string])[] = [
  ['map_ks', 'the map of its specular colour'],
  ['map_ns', 'the map of its shininess'],
  ['refl', 'its reflection map'],
  ['disp', 'its displacement'],
];

/** The last word of its name, however it is given. */
const fileOf = (statement: Statement | undefined): string | undefined =>
  statement?.words
    .at(-1)
    ?.replace(/^.*[\\/]/, '')
    .toLowerCase();

/** A texture statement: options first, then the file's name, which may have spaces. */
function textureOf(
  { words }: Statement,
  textures: TextureWriter,
  values: Partial<TextureRef>,
): ScaledTextureRef | null {
  const repeat: [number, number] = [1, 1];
  const offset: [number, number] = [0, 0];
  let wrap: TextureRef['wrap'] = 'repeat';
  let scale = 1;
  let i = 0;
  /** One to three numbers follow some options; the first two count. */
  const pair = (to: [number, number]): void => {
    for (let axis = 0; axis < 3; axis++) {
      const value = Number(words[i + 1]);
      if (words[i + 1] === undefined || !Number.isFinite(value)) break;
      if (axis < 2) to[axis] = clamp(value, -1e4, 1e4);
      i += 1;
    }
  };
  for (; i < words.length && /^-[a-z]+$/i.test(words[i] as string); i++) {
    const option = words[i]?.toLowerCase();
    if (option === '-s') pair(repeat);
    else if (option === '-o') pair(offset);
    else if (option === '-t') pair([0, 0]);
    else if (option === '-bm') scale = clamp(Number(words[++i]) || 1, -100, 100);
    else if (option === '-clamp') wrap = words[++i] === 'on' ? 'clamp' : 'repeat';
    else if (option === '-mm') i += 2;
    else i += 1;
  }
  const name = words.slice(i).join(' ');
  const ref = name === '' ? null : textures.file(name, { ...values, wrap, repeat, offset });
  return ref && { ...ref, scale };
}
