/** What the bench shows; a part of the editor's state. */
import { type Channel, channels } from '../../../analysis/plots/channel.ts';
import type { Document } from '../../../scene/schema.ts';

export const views = ['polar', 'thetaL', 'thetaH', 'thetaD', 'albedo', 'image'] as const;
export type BenchView = (typeof views)[number];

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
  readonly view: BenchView;
  /** Degrees, all of them. */
  readonly thetaV: number;
  readonly phiV: number;
  readonly thetaH: number;
  readonly thetaD: number;
  readonly channel: Channel | 'rgb';
  readonly log: boolean;
  readonly cosine: boolean;
  readonly term: string;
  /** The end of the axis of values; 0 finds it. */
  readonly range: number;
  /** EV of the image slice. */
  readonly brightness: number;
  readonly pins: readonly Pin[];
  /** The only curve that is drawn: a pin's id or CURRENT. */
  readonly solo: string | null;
}

/** The id of the curve that follows the selected material. */
export const CURRENT = 'current';
export const CURRENT_COLOR = '#eaa54b';
const PIN_COLORS = ['#6b9fe6', '#85bd6b', '#d98bd0', '#5fc4c0', '#e5766f', '#b9a8f0', '#c9c46a'];

export const channelChoices = ['luminance', 'rgb', ...channels.slice(1)] as const;

export const initialSettings: BenchSettings = {
  view: 'polar',
  thetaV: 45,
  phiV: 0,
  thetaH: 0,
  thetaD: 0,
  channel: 'luminance',
  log: false,
  cosine: false,
  term: 'BRDF',
  range: 0,
  brightness: 0,
  pins: [],
  solo: null,
};

/** A colour that no pin has, as long as there is one. */
export function freeColor(pins: readonly Pin[]): string {
  const free = PIN_COLORS.find((color) => pins.every((pin) => pin.color !== color));
  return free ?? (PIN_COLORS[pins.length % PIN_COLORS.length] as string);
}
