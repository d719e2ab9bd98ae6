import { BrdfError } from './error.ts';
import { clip } from './limits.ts';
import type { Parameter, SourceLine, Transmission } from './model.ts';

/**
 * What a header says of light that passes through:
 *
 *     # transmits: ior
 *     # thin: thin
 *     # medium: transmissionColor, transmissionDepth, scatter, scatterAnisotropy
 *
 * Each names parameters of the model. The path tracer sets the first to the index of refraction of the far side over
 * that of the side of V, so the file's formula need not know which side that is; and it follows the medium.
 *
 * @returns null without a line `transmits:`
 * @throws BrdfError naming the line
 */
export function parseTransmission(
  header: readonly SourceLine[],
  parameters: readonly Parameter[],
): Transmission | null {
  const read = (key: string): { place: SourceLine; names: string[] } | null => {
    const pattern = new RegExp(`^\\s*${key}:\\s*(.*?)\\.?\\s*$`);
    const [place, second] = header.filter(({ text }) => pattern.test(text));
    if (second) throw new BrdfError(second, `a second line '${key}:'`, 'one of them');
    if (!place) return null;
    const names = (pattern.exec(place.text)?.[1] ?? '').split(',').map((name) => name.trim());
    return { place, names };
  };
  const need = (place: SourceLine, name: string | undefined, type: Parameter['type']): string => {
    const parameter = parameters.find((candidate) => candidate.name === name);
    if (parameter?.type === type) return parameter.name;
    throw new BrdfError(place, `'${clip(name ?? '')}' is no ${type} parameter`, `the name of one`);
  };

  const transmits = read('transmits');
  const thin = read('thin');
  const medium = read('medium');
  if (!transmits) {
    const stray = thin ?? medium;
    if (stray) throw new BrdfError(stray.place, `nothing passes through this surface`, "a line 'transmits:'");
    return null;
  }
  const [color, depth, scatter, anisotropy] = medium?.names ?? [];
  return {
    ior: need(transmits.place, transmits.names[0], 'float'),
    thin: thin && need(thin.place, thin.names[0], 'bool'),
    medium: medium && {
      color: need(medium.place, color, 'color'),
      depth: need(medium.place, depth, 'float'),
      scatter: scatter === undefined ? null : need(medium.place, scatter, 'color'),
      anisotropy: anisotropy === undefined ? null : need(medium.place, anisotropy, 'float'),
    },
  };
}
