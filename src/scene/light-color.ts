import { temperatureColor } from '../lights/units.ts';
import type { Light } from './schema.ts';

/** The colour of a light with its temperature, linear Rec. 709. */
export function lightColor({ color, temperature }: Light): [number, number, number] {
  if (temperature === null) return [...color];
  const warmth = temperatureColor(temperature);
  return color.map((value, c) => value * warmth[c]!) as [number, number, number];
}
