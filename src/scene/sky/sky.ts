/** A document's sky as an image: what does not depend on the sun is computed once. */
import type { EnvironmentMap } from '../environment-map.ts';
import type { SourceOf } from '../environment-schema.ts';
import { type Atmosphere, createAtmosphere } from './atmosphere.ts';
import { type ScatteredLight, scatteredLight } from './multiple-scattering.ts';
import { skyImage } from './sky-map.ts';
import { sunAngles } from './sun.ts';

let last: { key: string; air: Atmosphere; scattered: ScatteredLight } | null = null;

export function skyMap({ turbidity, groundColor, sun }: SourceOf<'sky'>): EnvironmentMap {
  const key = JSON.stringify([turbidity, groundColor]);
  if (last?.key !== key) {
    const air = createAtmosphere(turbidity, groundColor);
    last = { key, air, scattered: scatteredLight(air) };
  }
  const { azimuth, elevation } = sunAngles(sun);
  return skyImage(last.air, last.scattered, elevation, azimuth);
}
