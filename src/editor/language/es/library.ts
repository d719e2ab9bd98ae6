/** The library of materials. */
import type { Catalogue } from '../catalogue.ts';

export const library: Catalogue = {
  'The objects keep their material': 'Los objetos conservan su material',
  '{material} for {object}': '{material} para {object}',
};
