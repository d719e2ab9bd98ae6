import type { ParameterValues } from '../../src/brdf/model.ts';

type Materials = Readonly<Record<string, readonly ParameterValues[]>>;

/** Materials of the shipped models that between them use every lobe, at widths that a histogram's cells can hold. */
export const DULL: Materials = {
  lambert: [{}],
  'cook-torrance': [
    {},
    { kd: 0, roughness: 0.15 },
    { metallic: 1, roughness: 0.6 },
    { kd: 1 },
    { albedo: [0, 0, 0], ior: 1, kd: 0.3 },
  ],
  principled: [
    {},
    { metallic: 1, roughness: 0.3 },
    { metallic: 1, roughness: 0.5, anisotropic: 1 },
    { metallic: 0.5, roughness: 1, anisotropic: 0.6 },
    { baseColor: [0, 0, 0], specular: 0, clearcoat: 1, clearcoatGloss: 0 },
    { baseColor: [0.02, 0.02, 0.02], sheen: 1, clearcoat: 1, clearcoatGloss: 0.3 },
    { baseColor: [0, 0, 0], specular: 0, roughness: 0.4 },
  ],
  'principled-thesis': [
    {},
    { metallic: 1, roughness: 0.4, anisotropic: 0.8 },
    { baseColor: [0, 0, 0], metallic: 1 },
    { subsurface: 1, clearcoat: 1, clearcoatGloss: 0 },
  ],
  // An index below 1 is a body seen from inside.
  dielectric: [{ roughness: 0.5 }, { roughness: 0.6, ior: 1 / 1.5 }],
  'principled-bsdf': [
    {},
    { specTrans: 0.6, roughness: 0.5, clearcoat: 1, clearcoatGloss: 0 },
    { specTrans: 1, roughness: 0.6, ior: 1 / 1.4 },
    { thin: true, specTrans: 0.3, diffTrans: 0.4, roughness: 0.6, sheen: 1 },
  ],
};

/** And mirrors, varnish and clear glass. */
export const SHARP: Materials = {
  principled: [{ roughness: 0 }, { roughness: 0.2 }, { metallic: 1, roughness: 0.05 }],
  'principled-thesis': [{ metallic: 1, roughness: 0.1 }, { clearcoat: 1 }],
  dielectric: [{}, { roughness: 0.2, ior: 1 / 1.5 }],
  'principled-bsdf': [
    { specTrans: 1, roughness: 0.1 },
    { thin: true, specTrans: 1, roughness: 0.1 },
  ],
};

export interface Case {
  readonly name: string;
  readonly parameters: ParameterValues;
}

export function casesOf(materials: Materials): Case[] {
  return Object.entries(materials).flatMap(([name, list]) =>
    list.map((parameters) => ({ name, parameters })),
  );
}
