/** Commands that give a place of a material a pattern, and that change one. */
import { keepAsset } from './commands.ts';
import { entity } from './entity.ts';
import { materialMaps, textureRef } from './material-schema.ts';
import { findModel } from './models.ts';
import { COLOR, isPattern, NORMALS, type PatternName, SURFACE } from './pattern/asset.ts';
import { MEAN_ROUGHNESS } from './pattern/draw.ts';
import { defaultPattern, type Pattern, patternAsset, readPatternAsset } from './pattern/pattern.ts';
import type { Material, MaterialMap, TextureRef } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';
import { assetsOf } from './validate.ts';

export type TexturePlace = { readonly parameter: string } | { readonly map: MaterialMap };

const refsOf = (material: Material): TextureRef[] => [
  ...Object.values(material.textures),
  ...materialMaps.map((map) => material[map]).filter((ref) => ref !== null),
];

/**
 * The mean of what the place shows stays: a colour becomes the pattern's, a roughness makes up for the pattern's mean. A
 * material has one pattern of a kind: what another of its places shows of it is shown here, too.
 */
export function givePattern(
  store: DocumentStore,
  id: string,
  place: TexturePlace,
  name: PatternName,
  label: string,
): void {
  store.edit(label, (draft) => {
    const material = entity(draft, 'materials', id) as Material;
    const other = refsOf(material).find(
      ({ asset }) =>
        isPattern(draft.assets[asset]) && readPatternAsset(entity(draft, 'assets', asset)).pattern === name,
    );
    const pattern = other ? readPatternAsset(entity(draft, 'assets', other.asset)) : defaultPattern(name);
    const { repeat, offset, rotation, wrap, uv } = other ?? textureRef('');
    const ref = (asset: string, values: Partial<TextureRef>) =>
      textureRef(asset, { repeat: [...repeat], offset: [...offset], rotation, wrap, uv, ...values });
    if ('map' in place) {
      const asset = other?.asset ?? keepAsset(draft, patternAsset(pattern));
      const pictures: Partial<Record<MaterialMap, Partial<TextureRef>>> = {
        normalMap: { texture: NORMALS },
        bumpMap: { texture: SURFACE, channel: 'r' },
        occlusionMap: { texture: SURFACE, channel: 'r' },
        emissiveMap: { texture: COLOR, colorSpace: 'srgb' },
        opacityMap: { texture: SURFACE, channel: 'r' },
      };
      material[place.map] = { ...ref(asset, pictures[place.map] ?? {}), scale: 1 };
      return;
    }
    const { parameter } = place;
    const known = findModel(draft, material.model)?.parameters.find((each) => each.name === parameter);
    const value = material.parameters[parameter] ?? known?.default;
    // Another pattern that was here has made up for its mean already.
    const before = material.textures[parameter]?.asset ?? '';
    const had = isPattern(draft.assets[before]) ? readPatternAsset(entity(draft, 'assets', before)) : null;
    if (known?.type === 'color') {
      const tint = had?.color ?? [1, 1, 1];
      const [r, g, b] = value as [number, number, number];
      const color = [r * tint[0], g * tint[1], b * tint[2]] as const;
      const asset = putPattern(draft, id, other?.asset, { ...pattern, color });
      material.parameters[parameter] = [1, 1, 1];
      material.textures[parameter] = ref(asset, { texture: COLOR, colorSpace: 'srgb' });
      return;
    }
    const asset = other?.asset ?? keepAsset(draft, patternAsset(pattern));
    const isRoughness = /roughness/i.test(parameter);
    if (isRoughness && known?.type === 'float' && !had)
      material.parameters[parameter] = Math.min(known.max, Number(value) / MEAN_ROUGHNESS);
    material.textures[parameter] = ref(asset, { texture: SURFACE, channel: isRoughness ? 'g' : 'r' });
  });
}

/** Changes a pattern wherever this material shows it. Other materials with the same one keep theirs. */
export function setPattern(
  store: DocumentStore,
  id: string,
  asset: string,
  pattern: Pattern,
  label: string,
  merge?: string,
): void {
  store.edit(label, (draft) => void putPattern(draft, id, asset, pattern), {
    ...(merge !== undefined && { merge }),
  });
}

/** @param old where the material has the pattern that this one replaces @returns the asset's id */
function putPattern(draft: Draft, id: string, old: string | undefined, pattern: Pattern): string {
  const made = patternAsset(pattern);
  if (old === undefined) return keepAsset(draft, made);
  const isShared = Object.entries(draft.materials).some(
    ([other, material]) => other !== id && assetsOf(material).some(([, asset]) => asset === old),
  );
  if (!isShared) {
    draft.assets[old] = made;
    return old;
  }
  const asset = keepAsset(draft, made);
  for (const ref of refsOf(entity(draft, 'materials', id) as Material))
    if (ref.asset === old) ref.asset = asset;
  return asset;
}
