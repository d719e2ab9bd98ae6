/** From a reflectance over wavelength to a colour in linear Rec. 709. */
import { adaptation } from './adaptation.ts';
import { CIE_1931, WAVELENGTHS } from './cie-1931.ts';
import { lightSpectrum, type WhiteLight } from './light.ts';
import { type Triple, transform } from './matrix.ts';
import { XYZ_TO_RGB } from './rec709.ts';

/**
 * What each sample of a reflectance weighs in its colour: the colour is the sum of the samples times these. The
 * spectrum runs straight between its samples and stays level before the first and after the last.
 *
 * The light's white becomes RGB 1 1 1 by the Bradford adaptation, so that a reflectance of 1 everywhere is
 * 1 1 1 under every light. A renderer multiplies this colour by the light's own, whose 1 1 1 is D65: hence D65 is
 * the light for which a material's colour is right.
 *
 * @param wavelengths nm, ascending
 */
export function colorWeights(
  wavelengths: readonly number[],
  light: WhiteLight = 'D65',
): [number, number, number][] {
  const power = lightSpectrum(light);
  const white = CIE_1931.reduce<Triple>(
    ([X, Y, Z], [x, y, z], i) => [X + x * power[i]!, Y + y * power[i]!, Z + z * power[i]!],
    [0, 0, 0],
  );
  const adapt = adaptation([white[0] / white[1], 1, white[2] / white[1]]);
  const weights = wavelengths.map((): [number, number, number] => [0, 0, 0]);
  const add = (index: number, xyz: Triple, share: number) => {
    const weight = weights[index];
    if (weight) for (const c of [0, 1, 2] as const) weight[c] += xyz[c] * share;
  };
  let after = 0;
  for (const [i, nm] of WAVELENGTHS.entries()) {
    while (after < wavelengths.length && wavelengths[after]! <= nm) after++;
    const scale = power[i]! / white[1];
    const [x, y, z] = CIE_1931[i]!;
    const [before, next] = [wavelengths[after - 1], wavelengths[after]];
    const t = before === undefined ? 1 : next === undefined ? 0 : (nm - before) / (next - before);
    add(after - 1, [x, y, z], scale * (1 - t));
    add(after, [x, y, z], scale * t);
  }
  return weights.map((xyz) => transform(XYZ_TO_RGB, adapt(xyz)));
}

/** The colour of a reflectance by wavelength in nm; may leave 0..1, as colours outside Rec. 709 do. */
export function reflectanceColor(
  reflectance: (nm: number) => number,
  light: WhiteLight = 'D65',
): [number, number, number] {
  const rgb: [number, number, number] = [0, 0, 0];
  for (const [i, weight] of standardWeights(light).entries()) {
    const value = reflectance(WAVELENGTHS[i]!);
    for (const c of [0, 1, 2] as const) rgb[c] += weight[c] * value;
  }
  return rgb;
}

const known = new Map<WhiteLight, readonly Triple[]>();

function standardWeights(light: WhiteLight): readonly Triple[] {
  const weights = known.get(light) ?? colorWeights(WAVELENGTHS, light);
  known.set(light, weights);
  return weights;
}
