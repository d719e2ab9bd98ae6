/** Metals, and semiconductors that look like them: their colour is F0 of measured n and k through CIE XYZ. */
import type { LibraryEntry } from './entry.ts';
import { metal } from './values.ts';

export const METALS: readonly LibraryEntry[] = [
  metal('gold-polished', 'Gold, polished', 'gold', { roughness: 0.12 }),
  metal('gold-satin', 'Gold, satin', 'gold', { roughness: 0.38 }),
  metal('silver-polished', 'Silver, polished', 'silver', { roughness: 0.1 }),
  metal('silver-brushed', 'Silver, brushed', 'silver', { roughness: 0.36, anisotropic: 0.8 }),
  metal('copper-polished', 'Copper, polished', 'copper', { roughness: 0.14 }),
  metal('copper-hammered', 'Copper, matte', 'copper', { roughness: 0.46 }),
  metal('brass-polished', 'Brass, polished', 'brass', { roughness: 0.16 }),
  metal('brass-brushed', 'Brass, brushed', 'brass', { roughness: 0.4, anisotropic: 0.85 }),
  metal('aluminium-polished', 'Aluminium, polished', 'aluminium', { roughness: 0.12 }),
  metal('aluminium-brushed', 'Aluminium, brushed', 'aluminium', { roughness: 0.42, anisotropic: 0.9 }),
  metal('aluminium-blasted', 'Aluminium, bead blasted', 'aluminium', { roughness: 0.52 }),
  metal('chromium', 'Chromium plate', 'chromium', { roughness: 0.05 }),
  metal('nickel', 'Nickel plate', 'nickel', { roughness: 0.18 }),
  metal('iron-ground', 'Iron, ground', 'iron', { roughness: 0.34, anisotropic: 0.5 }),
  metal('iron-cast', 'Iron, cast', 'iron', { roughness: 0.56 }),
  metal('steel', 'Stainless steel', 'stainless-steel', { roughness: 0.2 }),
  metal('steel-brushed', 'Stainless steel, brushed', 'stainless-steel', {
    roughness: 0.4,
    anisotropic: 0.85,
  }),
  metal('titanium', 'Titanium, satin', 'titanium', { roughness: 0.4 }),
  metal('tungsten', 'Tungsten', 'tungsten', { roughness: 0.3 }),
  metal('platinum', 'Platinum', 'platinum', { roughness: 0.2 }),
  metal('palladium', 'Palladium', 'palladium', { roughness: 0.24 }),
  metal('rhodium', 'Rhodium plate', 'rhodium', { roughness: 0.08 }),
  metal('cobalt', 'Cobalt', 'cobalt', { roughness: 0.32 }),
  metal('mercury', 'Mercury', 'mercury', { roughness: 0 }),
  metal('silicon', 'Silicon wafer', 'silicon', { roughness: 0.04 }),
  metal('germanium', 'Germanium', 'germanium', { roughness: 0.1 }),
];
