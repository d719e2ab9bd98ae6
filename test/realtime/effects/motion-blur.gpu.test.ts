import { expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, meanRadiance, type Picture, shareThatDiffers } from './frames.ts';

const SIZE = { width: 120, height: 96 };
const maker = await frameMaker(SIZE);
const { renderer } = maker;

/** A square of light before the dark, 24 pixels wide, 4 m away where the picture is 4 m high. */
const square = (enabled: boolean, x: number, shutter = 1 / 60) =>
  scene({
    camera: { fov: 2 * (180 / Math.PI) * Math.atan(0.5), position: [0, 0, 4], target: [0, 0, 0], shutter },
    background: { type: 'color', color: [0.1, 0.1, 0.1] },
    objects: {
      square: {
        name: 's',
        material: 'm',
        position: [x, 0, 0],
        geometry: { type: 'plane', width: 1, height: 1 },
      },
    },
    materials: { m: material('lambert', {}, { emissive: [1, 1, 1], emissiveIntensity: 1 }) },
    effects: { motionBlur: { enabled, samples: 32 }, antialiasing: { method: 'none' } },
  });

/** The second frame of a square that goes to the middle from `from`, a sixtieth of a second after the first. */
async function moved(enabled: boolean, from: number, shutter?: number): Promise<Picture> {
  const mirror = await maker.mirror(square(enabled, from, shutter));
  renderer.cut();
  renderer.render(mirror, square(enabled, from, shutter), SIZE, 1 / 60);
  const document = square(enabled, 0, shutter);
  mirror.apply(document);
  renderer.render(mirror, document, SIZE, 1 / 60);
  const picture = await renderer.readRadiance();
  mirror.dispose();
  return picture;
}

const row =
  ({ pixels }: Picture) =>
  (x: number) =>
    pixels[4 * (48 * SIZE.width + x)]!;

test('what moves is spread over its way, and its light is kept', async () => {
  // 8 of the 96 pixels that show 4 m: 4 to either side.
  const way = (8 * 4) / 96;
  const [off, on] = [await moved(false, -way), await moved(true, -way)];
  const [sharp, blurred] = [row(off), row(on)];
  // The square is from 48 to 72.
  expect([sharp(46), sharp(50)]).toEqual([expect.closeTo(0.1), expect.closeTo(1)]);
  expect(blurred(60)).toBeCloseTo(1, 2);
  expect(blurred(40)).toBeCloseTo(0.1, 2);
  // It goes from 0 to 1 within 4 pixels to either side of where the edge is.
  expect(blurred(46)).toBeGreaterThan(0.15);
  expect(blurred(46)).toBeLessThan(0.6);
  expect(blurred(50)).toBeGreaterThan(0.5);
  expect(blurred(50)).toBeLessThan(0.99);
  expect(meanRadiance(on)[0] / meanRadiance(off)[0]).toBeCloseTo(1, 1);
});

test('a short shutter blurs less', async () => {
  const [off, short] = [await moved(false, -0.5), await moved(true, -0.5, 1 / 2000)];
  expect(shareThatDiffers(off, short)).toBe(0);
});

test('what stands still is as it is, after one more frame', async () => {
  const document = square(true, 0);
  const mirror = await maker.mirror(square(true, -0.3));
  renderer.cut();
  renderer.render(mirror, square(true, -0.3), SIZE, 1 / 60);
  mirror.apply(document);
  renderer.render(mirror, document, SIZE, 1 / 60);
  expect(renderer.unsettled).toBe(true);
  renderer.render(mirror, document, SIZE, 1 / 60);
  expect(renderer.unsettled).toBe(false);
  const { pixels } = await renderer.readRadiance();
  mirror.dispose();
  expect(pixels).toEqual((await maker.draw(square(false, 0))).pixels);
});

test('frames that follow one another at once, as those of a file, have their own motion', async () => {
  const document = square(true, 0);
  const mirror = await maker.mirror(document);
  const from = (x: number) => {
    mirror.camera.position.x = x;
    // Another object each time: the frames of a turntable have settings of their own.
    renderer.render(mirror, { ...document }, SIZE, 1 / 60);
  };
  renderer.cut();
  for (const x of [0, 0, -0.33, 0]) from(x);
  const blurred = row(await renderer.readRadiance());
  mirror.dispose();
  expect(blurred(46)).toBeGreaterThan(0.15);
  expect(blurred(50)).toBeLessThan(0.99);
});

test('a camera that turns blurs what is far away, too', async () => {
  const document = scene({
    ...square(true, 0),
    environment: { source: { type: 'preset', name: 'studio' } },
    background: { type: 'environment', blur: 0 },
  });
  const mirror = await maker.mirror(document);
  const turned = async (blur: boolean) => {
    const settings = {
      ...document,
      effects: { ...document.effects, motionBlur: { enabled: blur, samples: 32 } },
    };
    mirror.camera.rotation.set(0, 0.1, 0);
    renderer.cut();
    renderer.render(mirror, settings, SIZE, 1 / 60);
    mirror.camera.rotation.set(0, 0.04, 0);
    renderer.render(mirror, settings, SIZE, 1 / 60);
    return renderer.readRadiance();
  };
  const roughness = ({ pixels }: Picture) => {
    let sum = 0;
    for (let i = 4; i < 4 * SIZE.width * 30; i += 4) sum += Math.abs(pixels[i]! - pixels[i - 4]!);
    return sum;
  };
  const [off, on] = [await turned(false), await turned(true)];
  mirror.dispose();
  expect(roughness(on)).toBeLessThan(0.8 * roughness(off));
});
