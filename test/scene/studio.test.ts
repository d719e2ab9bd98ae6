import { expect, it } from 'vitest';
import { softBoxDefaults, studioDefaults } from '../../src/scene/environment-schema.ts';
import { studioMap } from '../../src/scene/studio.ts';
import { arrangementNames, arrangementOf, studioOf } from '../../src/scene/studio-arrangements.ts';
import { irradiance } from './sky/quadrature.ts';

const studio = (dome: number, ...boxes: Partial<typeof softBoxDefaults>[]) => ({
  ...studioDefaults,
  dome,
  boxes: boxes.map((box) => ({ ...softBoxDefaults, softness: 0, temperature: null, ...box })),
});

/** What a rectangle of half angles w and h gives a plane that faces its middle: the contour integral of Lambert, 1760. */
function facing(w: number, h: number): number {
  const [a, b] = [Math.tan(w), Math.tan(h)];
  const [x, y] = [a / Math.hypot(1, a), b / Math.hypot(1, b)];
  return 2 * (x * Math.atan(b / Math.hypot(1, a)) + y * Math.atan(a / Math.hypot(1, b)));
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const towards = (azimuth: number, elevation: number) =>
  [
    Math.sin(radians(azimuth)) * Math.cos(radians(elevation)),
    Math.sin(radians(elevation)),
    -Math.cos(radians(azimuth)) * Math.cos(radians(elevation)),
  ] as const;

it('a soft box gives a plane that faces it what a luminous rectangle does, wherever it hangs and however it is turned', () => {
  for (const [azimuth, elevation, width, height, roll] of [
    [0, 0, 40, 20, 0],
    [90, 50, 60, 60, 30],
    [235, -35, 20, 90, -70],
    [180, 88, 90, 40, 10],
  ] as const) {
    const map = studioMap(
      studio(0, { azimuth, elevation, width, height, roll, luminance: 3, color: [1, 0.5, 0.25] }),
    );
    const found = irradiance(map, towards(azimuth, elevation));
    const expected = 3 * facing(radians(width / 2), radians(height / 2));
    for (const [c, color] of [1, 0.5, 0.25].entries())
      expect(Math.abs(found[c]! / (expected * color) - 1), `${azimuth} ${elevation}`).toBeLessThan(0.01);
  }
});

it('lies along its own axes: a tall box lights what faces up from the horizon less than a wide one lights its sides', () => {
  const tall = studioMap(studio(0, { azimuth: 90, elevation: 0, width: 10, height: 80, luminance: 1 }));
  const rolled = studioMap(
    studio(0, { azimuth: 90, elevation: 0, width: 10, height: 80, roll: 90, luminance: 1 }),
  );
  expect(irradiance(tall, [0, 1, 0])[0]).toBeGreaterThan(3 * irradiance(tall, [0, 0, 1])[0]);
  expect(irradiance(rolled, [0, 0, 1])[0]).toBeGreaterThan(3 * irradiance(rolled, [0, 1, 0])[0]);
});

it('the dome is everywhere where no box is, and a later box covers an earlier one', () => {
  const dome = irradiance(studioMap(studio(2)), [0, 1, 0]);
  expect(Math.abs(dome[0] / (2 * Math.PI) - 1)).toBeLessThan(1e-3);
  const at = { azimuth: 0, elevation: 0, width: 60, height: 60 };
  const covered = studioMap(
    studio(0, { ...at, width: 56, height: 56, luminance: 9 }, { ...at, luminance: 1 }),
  );
  const alone = studioMap(studio(0, { ...at, luminance: 1 }));
  const [a, b] = [irradiance(covered, [0, 0, -1])[0], irradiance(alone, [0, 0, -1])[0]];
  expect(Math.abs(a / b - 1)).toBeLessThan(1e-6);
});

it('arrangements are known as themselves until they are changed, and light what the camera sees', () => {
  for (const name of arrangementNames) {
    const source = studioOf(name);
    expect(arrangementOf(source)).toBe(name);
    source.boxes[0]!.roll += 1;
    expect(arrangementOf(source)).toBeNull();
    const key = irradiance(studioMap(studioOf(name)), towards(210, 35))[1] / Math.PI;
    expect(key).toBeGreaterThan(name === 'rim' ? 0.02 : 0.3);
    expect(key).toBeLessThan(1.2);
  }
});
