/**
 * Arrangements of soft boxes that are in use, for a camera that looks north (-z), as a new scene's does: the middle of the picture
 * faces south, azimuth 180; what is at the camera's left stands in the west, at 270. White paper that faces the key light has
 * some 0.5 to 1 nit.
 */
import { type SoftBox, type SourceOf, softBoxDefaults, studioDefaults } from './environment-schema.ts';

const box = (
  [azimuth, elevation]: readonly [number, number],
  [width, height]: readonly [number, number],
  luminance: number,
  more: Partial<SoftBox> = {},
): SoftBox => ({ ...softBoxDefaults, azimuth, elevation, width, height, luminance, ...more });

export interface Arrangement {
  readonly title: string;
  readonly description: string;
  readonly dome: number;
  readonly boxes: readonly SoftBox[];
}

export const arrangementNames = ['threePoint', 'clamshell', 'product', 'rim'] as const;
export type ArrangementName = (typeof arrangementNames)[number];

export const arrangements: Readonly<Record<ArrangementName, Arrangement>> = {
  threePoint: {
    title: 'Three lights',
    description: 'A key light from one side, a large weak fill from the other, a warm light from behind',
    dome: 0.03,
    boxes: [
      box([225, 38], [46, 46], 6),
      box([122, 14], [64, 54], 0.9, { softness: 0.6, temperature: 7500 }),
      box([35, 36], [26, 54], 12, { temperature: 4300 }),
    ],
  },
  clamshell: {
    title: 'Clamshell',
    description: 'A wide light above the camera and one below it, as for portraits; two strips for the edges',
    dome: 0.06,
    boxes: [
      box([180, 46], [84, 38], 4.5, { softness: 0.25 }),
      box([180, -34], [76, 26], 1.8, { softness: 0.5 }),
      box([68, 8], [12, 58], 4),
      box([292, 8], [12, 58], 4),
    ],
  },
  product: {
    title: 'Product',
    description: 'Tall strips at both sides draw long even highlights, under a large light from above',
    dome: 0.1,
    boxes: [
      box([256, 12], [13, 96], 9, { softness: 0.35 }),
      box([104, 12], [13, 96], 9, { softness: 0.35 }),
      box([180, 84], [84, 60], 2.2, { softness: 0.5 }),
    ],
  },
  rim: {
    title: 'Rim',
    description: 'Bright edges before darkness: strips behind the object, hardly any light from the front',
    dome: 0.008,
    boxes: [
      box([38, 16], [12, 84], 20),
      box([322, 16], [12, 84], 20, { temperature: 5200 }),
      box([0, 66], [70, 16], 7),
    ],
  },
};

export function studioOf(name: ArrangementName): SourceOf<'studio'> {
  const { dome, boxes } = arrangements[name];
  return { ...structuredClone(studioDefaults), dome, boxes: boxes.map((box) => structuredClone(box)) };
}

/** The arrangement that this is, untouched; null if it is one's own. */
export function arrangementOf({ dome, boxes }: SourceOf<'studio'>): ArrangementName | null {
  const same = (name: ArrangementName) =>
    arrangements[name].dome === dome && JSON.stringify(arrangements[name].boxes) === JSON.stringify(boxes);
  return arrangementNames.find(same) ?? null;
}
