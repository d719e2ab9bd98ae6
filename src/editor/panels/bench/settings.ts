/** What the bench shows; a part of the editor's state. */
import type { Turning } from '../../../analysis/plots/azimuth-slice.ts';
import { type Channel, channels } from '../../../analysis/plots/channel.ts';
import type { Document } from '../../../scene/schema.ts';

export const views = [
  'polar',
  'lobe',
  'thetaL',
  'thetaH',
  'thetaD',
  'phi',
  'azimuth',
  'albedo',
  'sweep',
  'image',
  'map',
  'sphere',
  'object',
  'fresnel',
  'verdict',
] as const;
export type BenchView = (typeof views)[number];

export const moving = ['light', 'viewer'] as const;
export type Moving = (typeof moving)[number];

/** A model that is not shipped but a document's own: of that document, what belongs to it. */
export type OwnModel = Pick<Document, 'models' | 'assets'>;

/** A copy of a model with its parameters, kept to compare with. */
export interface Pin {
  readonly id: string;
  readonly name: string;
  readonly model: string;
  /** The scene's own model of that name, as it was. */
  readonly source: OwnModel | null;
  readonly parameters: Readonly<Record<string, unknown>>;
  readonly color: string;
}

export interface BenchSettings {
  /** Those of the full page; the dock has the active one alone. */
  readonly panes: readonly BenchView[];
  readonly active: number;
  /** Degrees, all of them. */
  readonly thetaV: number;
  readonly phiV: number;
  readonly thetaL: number;
  readonly phiL: number;
  readonly thetaH: number;
  readonly thetaD: number;
  /** What moves in the slices through the plane of incidence. */
  readonly over: Moving;
  /** What goes round in the views over the azimuth. */
  readonly turns: Turning;
  /** The parameter of the view over a parameter; the model's first number if it has none of that name. */
  readonly parameter: string;
  /** Whose Fresnel reflectance is shown. */
  readonly substance: string;
  readonly channel: Channel | 'rgb';
  readonly log: boolean;
  readonly cosine: boolean;
  readonly term: string;
  /** The end of the axis of values; 0 finds it. */
  readonly range: number;
  /** Of pictures, which are looked at in colour more often than curves. */
  readonly tint: Channel | 'rgb';
  /** EV of pictures. */
  readonly brightness: number;
  /** Pictures show the colour alone, as bright as can be. */
  readonly chroma: boolean;
  /** theta_h on a square-root axis. */
  readonly squareRoot: boolean;
  readonly doubleTheta: boolean;
  /** Where one looks at the lobe from, degrees: about the normal, and above the surface. */
  readonly azimuth: number;
  readonly elevation: number;
  /** The scene's first directional light stands where l does, and the other way round. */
  readonly lightInStep: boolean;
  readonly pins: readonly Pin[];
  /** The only curve that is drawn: a pin's id or CURRENT. */
  readonly solo: string | null;
}

/** The largest angle to the normal that the viewer and the light can be given, degrees. */
export const STEEPEST = 89;

/** The settings as one pane has them. */
export interface PaneSettings extends BenchSettings {
  readonly view: BenchView;
}

export function paneSettings(bench: BenchSettings, pane: number): PaneSettings {
  return { ...bench, view: bench.panes[pane] ?? 'polar' };
}

/** The id of the curve that follows the selected material. */
export const CURRENT = 'current';
/** Of the theme (style/tokens.css). */
export const CURRENT_COLOR = 'var(--series-0)';
const PIN_COLORS = [1, 2, 3, 4, 5, 6, 7].map((i) => `var(--series-${i})`);

export const channelChoices = ['luminance', 'rgb', ...channels.slice(1)] as const;

export const initialSettings: BenchSettings = {
  panes: ['polar', 'lobe', 'sphere', 'thetaH', 'albedo', 'image'],
  active: 0,
  thetaV: 45,
  phiV: 0,
  thetaL: 20,
  phiL: 180,
  thetaH: 0,
  thetaD: 0,
  over: 'light',
  turns: 'light',
  parameter: 'roughness',
  substance: 'gold',
  channel: 'luminance',
  log: false,
  cosine: false,
  term: 'BRDF',
  range: 0,
  tint: 'rgb',
  brightness: 0,
  chroma: false,
  squareRoot: true,
  doubleTheta: false,
  azimuth: 62,
  elevation: 20,
  lightInStep: false,
  pins: [],
  solo: null,
};

/** A colour that no pin has, as long as there is one. */
export function freeColor(pins: readonly Pin[]): string {
  const free = PIN_COLORS.find((color) => pins.every((pin) => pin.color !== color));
  return free ?? (PIN_COLORS[pins.length % PIN_COLORS.length] as string);
}
