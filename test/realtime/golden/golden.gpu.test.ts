/**
 * Pictures as they were when somebody last looked at them and found them right, beside what is drawn now. What has
 * changed on purpose is drawn anew with IRRADIA_DRAW_GOLDEN=1, and to be looked at before it is committed.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { flip } from '../../../src/analysis/flip/flip.ts';
import { decodeImage } from '../../../src/cli/node-image.ts';
import { encodePng } from '../../../src/io/png.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { frameMaker } from '../effects/frames.ts';
import { goldenDocuments } from './stage.ts';

const SIZE = { width: 160, height: 90 };
/** What is gathered over time has a past to look at. */
const FRAMES = 2;
/**
 * The mean of FLIP over the picture: 0 where nobody sees a difference. Another driver's rounding stays below; an
 * effect that is off, or a light that is a fiftieth brighter, does not.
 */
const TOLERANCE = 0.002;

const maker = await frameMaker(SIZE);
/** One for all: what pictures have in common is compiled once. */
const mirror = await maker.mirror(await goldenDocuments.plain!());
const fileOf = (name: string) => fileURLToPath(new URL(`${name.replace(/\W+/g, '-')}.png`, import.meta.url));

async function draw(document: Document, isMoving: boolean): Promise<Uint8Array> {
  mirror.apply(document);
  await mirror.settled();
  maker.renderer.cut();
  for (let frame = 0; frame < FRAMES; frame++) {
    const [x, y, z] = document.camera.position;
    const shift = isMoving ? 0.2 * (frame - FRAMES + 1) : 0;
    const now: Document = { ...document, camera: { ...document.camera, position: [x + shift, y, z] } };
    mirror.apply(now);
    maker.renderer.render(mirror, now, SIZE, 1 / 60);
  }
  return maker.renderer.readImage(document.view);
}

test.each(Object.keys(goldenDocuments))('%s looks as it did', async (name) => {
  const pixels = await draw(await goldenDocuments[name]!(), name.endsWith('moving'));
  const file = fileOf(name);
  if (process.env.IRRADIA_DRAW_GOLDEN) writeFileSync(file, encodePng(pixels, SIZE.width, SIZE.height));
  expect(existsSync(file), `there is no ${file}: draw it with IRRADIA_DRAW_GOLDEN=1`).toBe(true);
  const golden = await decodeImage(readFileSync(file));
  const { mean } = flip({ ...SIZE, pixels: golden.data }, { ...SIZE, pixels });
  expect(mean).toBeLessThan(TOLERANCE);
});

test('no effect could be off, or the light a fiftieth brighter, and nobody see it', async () => {
  const read = async (name: string) => ({
    ...SIZE,
    pixels: (await decodeImage(readFileSync(fileOf(name)))).data,
  });
  const plain = await read('plain');
  for (const name of Object.keys(goldenDocuments)) {
    if (name === 'plain') continue;
    expect(flip(plain, await read(name)).mean, name).toBeGreaterThan(1.5 * TOLERANCE);
  }
  const document = (await goldenDocuments.plain!()) as Document;
  const exposure = document.view.exposure + Math.log2(1.02);
  const pixels = await draw({ ...document, view: { ...document.view, exposure } }, false);
  expect(flip(plain, { ...SIZE, pixels }).mean).toBeGreaterThan(TOLERANCE);
});
