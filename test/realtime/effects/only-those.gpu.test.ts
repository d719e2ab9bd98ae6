import { expect, test } from 'vitest';
import { evenLight, material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker } from './frames.ts';

/**
 * Each effect changes the pixels that it should, and only those: by what each pixel shows of a ball on a floor, worked out here.
 * Fog, depth of field, motion blur, bloom and the lens, which by their nature change most of a picture, have their own tests.
 */

const [WIDTH, HEIGHT] = [96, 64];
const SIZE = { width: WIDTH, height: HEIGHT };
const maker = await frameMaker(SIZE);

type V3 = readonly [number, number, number];
const plus = (a: V3, b: V3, t = 1): V3 => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
const dot = (a: V3, b: V3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (v: V3): V3 => plus([0, 0, 0], v, 1 / Math.sqrt(dot(v, v)));
const cross = (a: V3, b: V3): V3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

const [FOV, EYE, TARGET]: [number, V3, V3] = [40, [0, 1.2, 4], [0, 0.45, 0]];
const [RADIUS, CENTER]: [number, V3] = [0.5, [0, 0.5, 0]];
const SUN: V3 = [3, 4, 1];

interface Hit {
  readonly of: 'ball' | 'floor' | 'nothing';
  readonly P: V3;
  readonly N: V3;
  /** The way of the camera's ray. */
  readonly D: V3;
}

/** How near a ray comes to the ball's middle, ahead. */
function missedBy(P: V3, D: V3): number {
  const to = plus(CENTER, P, -1);
  const along = Math.max(0, dot(to, D));
  const off = plus(to, D, -along);
  return Math.sqrt(dot(off, off));
}

function hitAt(x: number, y: number): Hit {
  const forward = unit(plus(TARGET, EYE, -1));
  const right = unit(cross(forward, [0, 1, 0]));
  const up = cross(right, forward);
  const half = Math.tan((FOV * Math.PI) / 360);
  const [u, v] = [
    ((2 * (x + 0.5)) / WIDTH - 1) * half * (WIDTH / HEIGHT),
    (1 - (2 * (y + 0.5)) / HEIGHT) * half,
  ];
  const D = unit(plus(plus(forward, right, u), up, v));
  const to = plus(CENTER, EYE, -1);
  const along = dot(to, D);
  const inside = RADIUS ** 2 - (dot(to, to) - along ** 2);
  if (inside > 0) {
    const P = plus(EYE, D, along - Math.sqrt(inside));
    return { of: 'ball', P, N: unit(plus(P, CENTER, -1)), D };
  }
  if (D[1] < 0) {
    const P = plus(EYE, D, -EYE[1] / D[1]);
    if (Math.max(Math.abs(P[0]), Math.abs(P[2])) < 4) return { of: 'floor', P, N: [0, 1, 0], D };
  }
  return { of: 'nothing', P: EYE, N: [0, 1, 0], D };
}

const HITS = Array.from({ length: WIDTH * HEIGHT }, (_, i) => hitAt(i % WIDTH, Math.floor(i / WIDTH)));

/** Whether another thing is seen within so many pixels. */
const nearEdge = (i: number, pixels: number): boolean => {
  const [x, y] = [i % WIDTH, Math.floor(i / WIDTH)];
  for (let v = Math.max(0, y - pixels); v <= Math.min(HEIGHT - 1, y + pixels); v++)
    for (let u = Math.max(0, x - pixels); u <= Math.min(WIDTH - 1, x + pixels); u++)
      if (HITS[v * WIDTH + u]!.of !== HITS[i]!.of) return true;
  return false;
};

/** What becomes of a pixel: it changes, it stays as it is, or either. */
type Fate = 'changes' | 'stays' | 'either';
const fate = (changes: boolean, stays: boolean): Fate => (changes ? 'changes' : stays ? 'stays' : 'either');

const toSun = unit(SUN);
const shadowed = ({ of, P, N }: Hit): Fate => {
  if (of === 'nothing') return 'stays';
  if (of === 'ball') return fate(false, dot(N, toSun) > 0.15);
  const miss = missedBy(P, toSun);
  return fate(miss < RADIUS - 0.06, miss > RADIUS + 0.06);
};
const fromBall = (P: V3): number => Math.sqrt(dot(plus(P, CENTER, -1), plus(P, CENTER, -1))) - RADIUS;
/** Neither at a silhouette nor where the ball's own shadow begins. */
const isEven = ({ of, N }: Hit, i: number) =>
  !nearEdge(i, 3) && (of !== 'ball' || Math.abs(dot(N, toSun)) > 0.3);
const mirrored = ({ D, N }: Hit): V3 => plus(D, N, -2 * dot(D, N));

const clay = material('lambert', { albedo: [0.6, 0.6, 0.6] });
const red = material('lambert', { albedo: [0.8, 0.1, 0.1] });
const rough = material('principled', { baseColor: [0.9, 0.6, 0.3], metallic: 1, roughness: 1 });
const mirror = material('principled', { baseColor: [0.9, 0.9, 0.9], metallic: 1, roughness: 0.1 });

const stage = (
  effects: object,
  { ball = red, floor = clay, sky = false }: { ball?: object; floor?: object; sky?: boolean },
) =>
  scene({
    ...(sky ? evenLight : { background: { type: 'color', color: [0.2, 0.25, 0.3] } }),
    camera: { fov: FOV, position: EYE, target: TARGET },
    materials: { ball, floor },
    objects: {
      floor: {
        name: 'f',
        material: 'floor',
        rotation: [-90, 0, 0],
        geometry: { type: 'plane', width: 8, height: 8 },
      },
      ball: {
        name: 'b',
        material: 'ball',
        position: CENTER,
        geometry: { type: 'sphere', radius: RADIUS, widthSegments: 128, heightSegments: 64 },
      },
    },
    lights: sky ? {} : { sun: { type: 'directional', illuminance: 3, position: SUN } },
    effects: { antialiasing: { method: 'none' }, shadows: { enabled: false }, ...effects },
    view: { toneMapping: 'none' },
  });

interface Case {
  readonly on: object;
  readonly look?: Parameters<typeof stage>[1];
  readonly changed?: Parameters<typeof stage>[1];
  readonly frames?: number;
  /** By how much what stays may be off, and what changes must: radiance, or parts of white. */
  readonly tolerance?: number;
  /** The finished picture, not its radiance. */
  readonly finished?: boolean;
  /** How many of the pixels that are to change do. */
  readonly share?: number;
  readonly where: (hit: Hit, i: number) => Fate;
}

const CASES: Readonly<Record<string, Case>> = {
  shadows: { on: { shadows: { enabled: true, resolution: 1024, samples: 16 } }, where: shadowed },
  'contact shadows': {
    on: { contactShadows: { enabled: true, length: 0.3, thickness: 0.3, steps: 32 } },
    // What is cast on the floor beside the ball, of which the march sees the near side.
    share: 0.7,
    where: (hit) => {
      const cast = shadowed(hit);
      return cast === 'changes' && fromBall(hit.P) > 0.15 ? 'either' : cast;
    },
  },
  'ambient occlusion': {
    on: { ambientOcclusion: { enabled: true, radius: 0.4, steps: 12 } },
    tolerance: 3e-3,
    look: { sky: true },
    where: ({ of, P }, i) =>
      fate(
        of === 'floor' && fromBall(P) < 0.2 && !nearEdge(i, 1),
        of === 'nothing' || ((of === 'floor' ? fromBall(P) > 0.9 : P[1] > 0.75) && !nearEdge(i, 3)),
      ),
  },
  reflections: {
    on: { reflections: { enabled: true } },
    look: { sky: true, floor: mirror },
    frames: 6,
    tolerance: 0.02,
    where: (hit, i) => {
      if (hit.of !== 'floor') return fate(false, !nearEdge(i, 2));
      const miss = missedBy(hit.P, mirrored(hit));
      return fate(miss < 0.7 * RADIUS && !nearEdge(i, 2), miss > 1.7 * RADIUS);
    },
  },
  'indirect light': {
    on: { indirectLight: { enabled: true } },
    look: { sky: true },
    frames: 4,
    tolerance: 0.04,
    where: ({ of, P }, i) =>
      fate(
        of === 'floor' && fromBall(P) < 0.2 && !nearEdge(i, 2),
        of === 'nothing' || (of === 'floor' && fromBall(P) > 2 && !nearEdge(i, 3)),
      ),
  },
  'temporal anti-aliasing': {
    on: { antialiasing: { method: 'temporal' } },
    frames: 16,
    tolerance: 0.02,
    share: 0.2,
    where: (hit, i) => fate(nearEdge(i, 1), isEven(hit, i)),
  },
  FXAA: {
    on: { antialiasing: { method: 'fxaa' } },
    finished: true,
    tolerance: 0.02,
    share: 0.2,
    where: (hit, i) => fate(nearEdge(i, 1), isEven(hit, i)),
  },
  SMAA: {
    on: { antialiasing: { method: 'smaa' } },
    finished: true,
    tolerance: 0.02,
    share: 0.2,
    where: (hit, i) => fate(nearEdge(i, 1), isEven(hit, i)),
  },
  'multiple scattering': {
    on: {},
    look: { ball: rough },
    changed: { ball: { ...rough, multipleScattering: true } },
    where: ({ of, N }, i) => fate(of === 'ball' && dot(N, toSun) > 0.2 && !nearEdge(i, 1), of !== 'ball'),
  },
};

async function drawn(
  document: ReturnType<typeof stage>,
  { frames = 1, finished = false }: Case,
): Promise<ArrayLike<number>> {
  const { pixels } = await maker.draw(document, frames);
  if (!finished) return pixels;
  return Float32Array.from(await maker.renderer.readImage(document.view), (byte) => byte / 255);
}

test.each(Object.entries(CASES))('%s', async (_, one) => {
  const { on, look = {}, changed = look, tolerance = 1e-3, share = 0.9, where } = one;
  const before = await drawn(stage({}, look), one);
  const after = await drawn(stage(on, { ...look, ...changed }), one);
  let [toChange, changes] = [0, 0];
  const strays: string[] = [];
  for (const [i, hit] of HITS.entries()) {
    const differences = [0, 1, 2].map((c) => Math.abs(after[4 * i + c]! - before[4 * i + c]!));
    const differs = Math.max(...differences) > tolerance;
    const what = where(hit, i);
    if (what === 'changes') {
      toChange++;
      if (differs) changes++;
    } else if (what === 'stays' && differs)
      strays.push(`${i % WIDTH}, ${Math.floor(i / WIDTH)} (${hit.of}) by ${Math.max(...differences)}`);
  }
  expect(strays).toEqual([]);
  expect(toChange).toBeGreaterThan(10);
  expect(changes / toChange).toBeGreaterThan(share);
});
