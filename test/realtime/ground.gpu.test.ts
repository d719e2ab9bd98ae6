import { Vector3 } from 'three/webgpu';
import { expect, test, vi } from 'vitest';
import { boundsOf } from '../../src/editor/viewport/navigation/bounds.ts';
import { pickAlong, rayAt } from '../../src/editor/viewport/selecting/picking.ts';
import { CatcherMaterial } from '../../src/realtime/ground/catcher-material.ts';
import type { Document } from '../../src/scene/schema.ts';
import { SHOWN } from '../../src/scene/stage-schema.ts';
import { material, scene } from '../pathtracer/scenes.ts';
import { trace } from '../pathtracer/tracer.ts';
import { frameMaker } from './effects/frames.ts';
import { reduced } from './effects/reference.ts';

/** Shadows on the ground that is not seen: the interactive picture against the path tracer's. */

const SIZE = { width: 48, height: 32 };
/** Pixels of the frame beside each of the path traced picture's. */
const FINER = 3;
/** The sky's map is gathered over frames; the shadows of lamps are there at once. */
const SKY_FRAMES = 6;
const maker = await frameMaker({
  width: SIZE.width * FINER,
  height: SIZE.height * FINER,
});

function stage(parts: Record<string, unknown>): Document {
  return scene({
    camera: { fov: 40, position: [0.5, 3, 5], target: [0.2, 0, 0] },
    ground: { shadowCatcher: true },
    background: { type: 'color', color: [1, 1, 1] },
    effects: { shadows: { enabled: true, samples: 16, resolution: 512 } },
    objects: {
      ball: {
        name: 'ball',
        material: 'm',
        position: [-0.7, 0.5, 0],
        geometry: { type: 'sphere', radius: 0.5, widthSegments: 64, heightSegments: 48 },
      },
      box: {
        name: 'box',
        material: 'm',
        position: [0.9, 0.5, 0.2],
        rotation: [0, 30, 0],
        geometry: { type: 'box', width: 0.6, height: 1, depth: 0.6 },
      },
    },
    materials: { m: material('lambert') },
    ...parts,
  });
}

/** Of the pixels that show nothing but ground, the mean distance of what is kept off the background, and of the pictures. */
async function compare(document: Document, samples: number, frames: number, channel = 0) {
  const shown = reduced(await maker.draw(document, frames), FINER);
  const film = await trace(document, { ...SIZE, samples, maxDepth: 1 });
  const [traced, alpha] = [film.mean(), film.meanAlpha()];
  let [error, bias, worst, kept, sum, count] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < SIZE.width * SIZE.height; i++) {
    if (film.alpha[i]! > 0) continue;
    const reference = channel === 3 ? 1 - alpha[i]! : traced[3 * i + channel]!;
    const found = channel === 3 ? 1 - shown.pixels[4 * i + 3]! : shown.pixels[4 * i + channel]!;
    error += Math.abs(found - reference);
    bias += found - reference;
    worst = Math.max(worst, Math.abs(found - reference));
    kept += 1 - reference;
    sum += reference;
    count += 1;
  }
  return { error: error / sum, bias: bias / kept, worst, kept: kept / count };
}

const lamps = {
  sun: { type: 'directional', illuminance: 3, position: [2, 4, 1], angularDiameter: 3 },
  point: { type: 'point', intensity: 10, position: [-2, 3, 1], radius: 0.1 },
  spot: { type: 'spot', intensity: 20, position: [0, 4, 2], target: [0, 0, 0], cutoff: 35, penumbra: 0.4 },
  rectangle: {
    type: 'rectangle',
    luminance: 5,
    position: [-2, 2, 2],
    target: [0, 0.3, 0],
    width: 1,
    height: 1,
  },
};

test.each(Object.keys(lamps))('the shadow of a %s', async (name) => {
  const document = stage({ lights: { lamp: lamps[name as keyof typeof lamps] } });
  const { error, kept } = await compare(document, 64, 1);
  expect(kept).toBeGreaterThan(0.004);
  expect(error).toBeLessThan(0.01);
});

test('its sliders compile nothing', async () => {
  const { renderer } = maker;
  const document = stage({ lights: { lamp: lamps.point } });
  const mirror = await maker.mirror(document);
  const size = { width: 32, height: 16 };
  renderer.render(mirror, document, size);
  const setUp = vi.spyOn(CatcherMaterial.prototype, 'setupLightingModel');
  for (const change of [{ strength: 0.3 }, { radius: 2, fade: 0.1 }, { height: -0.2 }]) {
    const ground = { ...document.ground, ...change };
    renderer.render(mirror, { ...document, ground }, size);
  }
  expect(setUp).not.toHaveBeenCalled();
  mirror.dispose();
});

test('a click on it meets nothing, what is framed does not reach it', async () => {
  const { renderer } = maker;
  const { ball, box } = stage({}).objects;
  // Of few triangles: larger meshes are looked at by a worker of the page.
  const objects = {
    box,
    ball: { ...ball, geometry: { ...ball!.geometry, widthSegments: 16, heightSegments: 8 } },
  };
  const document = stage({ objects, ground: { shadowCatcher: true, height: -3 } });
  const mirror = await maker.mirror(document);
  renderer.render(mirror, document, { width: 32, height: 16 });
  expect(pickAlong(mirror, rayAt(mirror, -0.9, -0.9))).toEqual([]);
  const onBall = new Vector3(-0.7, 0.5, 0).project(mirror.camera);
  expect(pickAlong(mirror, rayAt(mirror, onBall.x, onBall.y))).toMatchObject([{ id: 'ball' }]);
  const framed = boundsOf(document, mirror, []);
  expect(framed.min.y).toBeCloseTo(0, 5);
  expect(framed.getSize(new Vector3()).length()).toBeLessThan(5);
  mirror.dispose();
});

test('every view of what is behind the picture is finite; of them luminance alone has the shadows', async () => {
  const { renderer } = maker;
  const size = { width: 48, height: 32 };
  const document = stage({ lights: { lamp: lamps.sun } });
  const mirror = await maker.mirror(document);
  const draw = async (show: (typeof SHOWN)[number], shadowCatcher: boolean) => {
    const view = { ...document.view, show };
    renderer.render(mirror, { ...document, view, ground: { ...document.ground, shadowCatcher } }, size);
    return { radiance: (await renderer.readRadiance()).pixels, image: await renderer.readImage(view) };
  };
  for (const show of SHOWN) {
    const [withGround, without] = [await draw(show, true), await draw(show, false)];
    expect(withGround.radiance.every(Number.isFinite), show).toBe(true);
    const differs = withGround.image.some((value, i) => value !== without.image[i]);
    expect(differs, show).toBe(show === 'picture' || show === 'luminance');
  }
  mirror.dispose();
});

test('an even sky', async () => {
  const document = stage({ environment: { source: { type: 'constant', color: [1, 1, 1] } } });
  const found = await compare(document, 128, SKY_FRAMES);
  expect(found.error).toBeLessThan(0.01);
});

test('where all light is kept off nothing is left of any colour', async () => {
  const box = { azimuth: 60, elevation: 50, width: 90, height: 70, luminance: 8, color: [1, 0.93, 0.55] };
  const document = stage({
    environment: { source: { type: 'studio', dome: 0.3, boxes: [box] } },
    camera: { fov: 20, position: [0, 1.5, 0.3], target: [0, 0, 0] },
    ground: { shadowCatcher: true, height: 0.5 },
    objects: {
      room: {
        name: 'room',
        material: 'm',
        position: [0, 1, 0],
        geometry: { type: 'box', width: 2, height: 2, depth: 2 },
      },
    },
  });
  const { pixels } = await maker.draw(document, SKY_FRAMES);
  expect(Math.max(...pixels.filter((_, i) => i % 4 < 3))).toBeLessThan(0.003);
});

test('a studio with a lamp, in a transparent picture', async () => {
  const box = { azimuth: 60, elevation: 40, width: 50, height: 50, luminance: 8, color: [1, 0.6, 0.3] };
  const document = stage({
    environment: { source: { type: 'studio', dome: 0.3, boxes: [box] }, rotation: 40 },
    lights: { lamp: lamps.point },
    background: { type: 'transparent' },
    ground: { shadowCatcher: true, strength: 0.8, radius: 2.5 },
  });
  const found = await compare(document, 128, SKY_FRAMES, 3);
  expect(found.error).toBeLessThan(0.015);
});
