/** Every view of the bench: its name, what draws it, and which settings it has. */

import { t } from '../../language/language.ts';
import { azimuthView } from './azimuth.ts';
import { cartesianView } from './cartesian.ts';
import type { View } from './frame.ts';
import { lobeView } from './lobe.ts';
import { polarView } from './polar.ts';
import type { BenchView } from './settings.ts';
import { imageView, mapView, objectView, sphereView } from './tiles.ts';

export type ControlKey =
  | 'thetaV'
  | 'phiV'
  | 'thetaL'
  | 'phiL'
  | 'thetaH'
  | 'thetaD'
  | 'over'
  | 'turns'
  | 'parameter'
  | 'substance'
  | 'term'
  | 'channel'
  | 'tint'
  | 'log'
  | 'cosine'
  | 'range'
  | 'brightness'
  | 'chroma'
  | 'squareRoot'
  | 'doubleTheta'
  | 'light';

export interface ViewInfo {
  readonly label: string;
  readonly tip: string;
  /** null: a panel of its own, not a drawing. */
  readonly view: View | null;
  readonly controls: readonly ControlKey[];
}

const curve = ['term', 'channel', 'log', 'cosine', 'range'] as const;
const albedo = ['phiV', 'term', 'channel', 'log', 'range'] as const;
const picture = ['term', 'tint', 'log', 'brightness', 'chroma'] as const;
const incidence = ['over', 'thetaV', 'phiV', 'thetaL', 'phiL', 'light', ...curve] as const;
const lit = ['thetaV', 'phiV', 'thetaL', 'phiL', 'light', 'doubleTheta', ...picture] as const;
const azimuth = ['turns', 'thetaV', 'phiV', 'thetaL', 'thetaH', 'thetaD'] as const;

export const viewInfo: Readonly<Record<BenchView, ViewInfo>> = {
  polar: {
    label: t('Polar'),
    tip: t('The plane of incidence from the side'),
    view: polarView,
    controls: incidence,
  },
  lobe: {
    label: '3D',
    tip: t('The lobe over the whole hemisphere; drag to turn it, drag v and l to move them'),
    view: lobeView,
    controls: ['thetaV', 'phiV', 'thetaL', 'phiL', 'light', ...curve],
  },
  thetaL: {
    label: 'θl θv',
    tip: t('Over the angle of the light or of the viewer, in the plane of incidence'),
    view: cartesianView,
    controls: incidence,
  },
  thetaH: {
    label: 'θh',
    tip: t('Over the angle of the half vector: the highlight'),
    view: cartesianView,
    controls: ['thetaD', 'phiV', ...curve],
  },
  thetaD: {
    label: 'θd',
    tip: t('Over the difference angle: Fresnel, grazing light'),
    view: cartesianView,
    controls: ['thetaH', 'phiV', ...curve],
  },
  phi: {
    label: 'φ',
    tip: t('Over the azimuth of the light or the half vector: flat, unless the model is anisotropic'),
    view: cartesianView,
    controls: [...azimuth, ...curve],
  },
  azimuth: {
    label: t('φ polar'),
    tip: t('The same over the azimuth, from above: round, unless the model is anisotropic'),
    view: azimuthView,
    controls: [...azimuth, ...curve],
  },
  albedo: {
    label: t('Albedo'),
    tip: t('The share of light that is reflected, over the angle of the viewer'),
    view: cartesianView,
    controls: albedo,
  },
  sweep: {
    label: t('Sweep'),
    tip: t('The share of light that is reflected, over one parameter of the model'),
    view: cartesianView,
    controls: ['parameter', ...albedo],
  },
  image: {
    label: t('Image'),
    tip: t('All of θh and θd at once'),
    view: imageView,
    controls: ['cosine', 'squareRoot', ...picture],
  },
  map: {
    label: t('Map φ'),
    tip: t('All of φ and θ of the light or the half vector at once: anisotropy'),
    view: mapView,
    controls: [...azimuth, 'cosine', ...picture],
  },
  sphere: {
    label: t('Sphere'),
    tip: t('A sphere under one light; drag to move the light'),
    view: sphereView,
    controls: lit,
  },
  object: {
    label: t('Object'),
    tip: t('The selected object under one light; drag to move the light'),
    view: objectView,
    controls: lit,
  },
  fresnel: {
    label: t('Fresnel'),
    tip: t('The reflectance of a real substance over the angle of incidence: exact, and as Schlick has it'),
    view: cartesianView,
    controls: ['substance', 'channel', 'log', 'range'],
  },
  verdict: {
    label: t('Verdict'),
    tip: t('The model held to physics, over all its parameters and directions'),
    view: null,
    controls: [],
  },
};
