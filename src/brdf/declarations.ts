import { BrdfError } from './error.ts';
import { clip } from './limits.ts';
import type {
  Declarations,
  FacetMasking,
  Parameter,
  ParameterValue,
  SourceLine,
  WaivedProperty,
} from './model.ts';

/**
 * What a model says about itself in its header comment, for `irradia brdf check` (docs/verdict.md):
 *
 *     # gives up: energy, reciprocity of sheenLobe
 *     # lobes: diffuseLobe, specularLobe
 *     # distributions: distribution
 *     # masking: viewMasking of distribution
 *     # multiple scattering: withMultipleScattering
 *     # lossless: albedo = 1 1 1; metallic = 1
 *
 * Each is one line of its own and stands at most once. Other programs read a comment.
 */

export const WAIVABLE = ['positivity', 'reciprocity', 'energy', 'continuity'] as const;

const KEYS = ['gives up', 'lobes', 'distributions', 'masking', 'multiple scattering', 'lossless'] as const;
type Key = (typeof KEYS)[number];

/** @throws BrdfError naming the line that is not as above */
export function parseDeclarations(
  header: readonly SourceLine[],
  parameters: readonly Parameter[],
): Declarations {
  const found = new Map<Key, { place: SourceLine; items: string[] }>();
  for (const place of header) {
    const match =
      /^\s*(gives up|lobes|distributions|masking|multiple scattering|lossless):\s*(.*?)\.?\s*$/.exec(
        place.text,
      );
    if (!match) continue;
    const key = match[1] as Key;
    if (found.has(key)) throw new BrdfError(place, `a second line '${key}:'`, 'one list of all of them');
    const items = (match[2] ?? '')
      .split(key === 'lossless' ? ';' : ',')
      .map((item) => item.trim())
      .filter((item) => item !== '');
    if (key === 'multiple scattering' && items.length > 1)
      throw new BrdfError(place, `'${key}:' names more than one term`, 'one');
    if (items.length === 0) throw new BrdfError(place, `'${key}:' names nothing`, 'a list');
    found.set(key, { place, items });
  }
  const list = <T>(key: Key, read: (item: string, place: SourceLine) => T): T[] => {
    const entry = found.get(key);
    return entry ? entry.items.map((item) => read(item, entry.place)) : [];
  };
  return {
    givesUp: list('gives up', readWaiver),
    lobes: list('lobes', readName),
    distributions: list('distributions', readName),
    maskings: list('masking', readMasking),
    multipleScattering: list('multiple scattering', readName)[0] ?? null,
    lossless: found.has('lossless')
      ? Object.fromEntries(list('lossless', (item, place) => readValue(item, place, parameters)))
      : null,
  };
}

function readWaiver(item: string, place: SourceLine): WaivedProperty {
  const match = /^([a-z]+)(?:\s+of\s+([A-Za-z_]\w*))?$/.exec(item);
  const property = WAIVABLE.find((name) => name === match?.[1]);
  if (!match || !property) {
    throw new BrdfError(
      place,
      `a model cannot give up '${clip(item)}'`,
      `${WAIVABLE.join(', ')}, or one of these 'of' a term`,
    );
  }
  return { property, term: match[2] ?? null };
}

function readName(item: string, place: SourceLine): string {
  if (/^[A-Za-z_]\w*$/.test(item)) return item;
  throw new BrdfError(place, `'${clip(item)}' is no name of a term`, 'names with commas between them');
}

function readMasking(item: string, place: SourceLine): FacetMasking {
  const match = /^([A-Za-z_]\w*)\s+of\s+([A-Za-z_]\w*)$/.exec(item);
  if (match) return { masking: match[1] as string, distribution: match[2] as string };
  throw new BrdfError(place, `'${clip(item)}' is no masking`, "a term 'of' the distribution that it masks");
}

function readValue(
  item: string,
  place: SourceLine,
  parameters: readonly Parameter[],
): readonly [string, ParameterValue] {
  const [name = '', text = ''] = item.split('=').map((part) => part.trim());
  const parameter = parameters.find((candidate) => candidate.name === name);
  if (!parameter) throw new BrdfError(place, `there is no parameter '${clip(name)}'`, 'NAME = VALUE');
  const numbers = text === '' ? [] : text.split(/\s+/).map(Number);
  const count = parameter.type === 'color' ? 3 : 1;
  if (numbers.length !== count || !numbers.every(Number.isFinite)) {
    throw new BrdfError(place, `${name} = '${clip(text)}'`, count === 3 ? 'three numbers' : 'a number');
  }
  const [x = 0, y = 0, z = 0] = numbers;
  if (parameter.type === 'color') return [name, [x, y, z]];
  return [name, parameter.type === 'bool' ? x !== 0 : x];
}
