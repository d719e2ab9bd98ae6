import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { parseDocument } from '../../../src/scene/document.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { frameMaker, type Picture } from './frames.ts';
import { meanError, reduced, traced } from './reference.ts';

/** The scenes that ship, by their lamps alone: direct light with shadows is the path tracer's within 2 % in the mean. */

const SIZE = { width: 96, height: 64 };
/** Pixels of the frame beside each of the path traced picture's, whose pixels are means over their area. */
const FINER = 4;
/** Squares of pixels whose means are compared: less of the path tracer's noise. */
const SQUARE = 4;
const maker = await frameMaker({ width: SIZE.width * FINER, height: SIZE.height * FINER });

function byLamps(name: string): Document {
  const document = parseDocument(readFileSync(`scenes/${name}.json`, 'utf8'), name);
  const lamps = Object.entries(document.lights).filter(([, light]) => 'castShadow' in light);
  return {
    ...document,
    lights: Object.fromEntries(lamps),
    environment: { ...document.environment, source: { type: 'none' } },
    view: { ...document.view, resolutionScale: 1 },
    effects: {
      ...document.effects,
      shadows: { ...document.effects.shadows, enabled: true, samples: 16, resolution: 512 },
    },
  };
}

/** Highlights of mirrors, far brighter than white, are smaller than pixels: neither has them but by chance. */
const shownWhite = (picture: Picture): Picture => ({
  ...picture,
  pixels: picture.pixels.map((x) => Math.min(x, 1)),
});

test.each(['thesis', 'thesis-demo02', 'parameters'])('%s', async (name) => {
  const document = byLamps(name);
  const shown = reduced(shownWhite(reduced(await maker.draw(document), FINER)), SQUARE);
  const film = reduced(shownWhite(await traced(document, SIZE, 96, 1)), SQUARE);
  const { error, bias } = meanError(shown, film);
  expect(error).toBeLessThan(0.02);
  expect(Math.abs(bias)).toBeLessThan(0.01);
});
