/** All substances that are known here, by name. */
import { CONDUCTORS } from './conductors.ts';
import { DIELECTRICS } from './dielectrics.ts';
import type { Substance } from './substance.ts';

export const substances: ReadonlyMap<string, Substance> = new Map(
  [...CONDUCTORS, ...DIELECTRICS].map((substance): [string, Substance] => [substance.name, substance]),
);
