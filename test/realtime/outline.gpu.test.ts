/** Outlines against closed forms: a sphere's is an ellipse, a box's the hull of its corners. */
import {
  BoxGeometry,
  Color,
  Mesh,
  MeshBasicNodeMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  Vector3,
} from 'three/webgpu';
import { afterAll, describe, expect, it } from 'vitest';
import { type OutlineOptions, OutlinePass } from '../../src/realtime/outline/outline-pass.ts';
import { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { testRenderer } from '../support/gpu.ts';

const SIZE = { width: 150, height: 100 };
const { renderer: three, readCanvas } = await testRenderer(SIZE.width, SIZE.height);
const renderer = new RealtimeRenderer(three, { samples: 1 });
const pass = new OutlinePass();
afterAll(() => {
  pass.dispose();
  renderer.dispose();
});

type Rgb = readonly [number, number, number];
type Point = readonly [number, number];
/** Pixels from an edge, at the middle of a pixel; negative within. */
type Distance = (x: number, y: number) => number;

const FRONT = { color: '#f6a93b', rgb: [246, 169, 59], width: 2 } as const;
const BACK = { color: '#d8b98a', rgb: [216, 185, 138], width: 1.5 } as const;
const HALO = { width: 1.25, opacity: 0.45 };
/** Of a radiance of 1/4. */
const GROUND: Rgb = [137, 137, 137];

const view = { exposure: 0, toneMapping: 'none', resolutionScale: 1 } as const;
const camera = new PerspectiveCamera(50, SIZE.width / SIZE.height, 0.1, 100);
camera.position.set(0.4, 0.9, 5);
camera.lookAt(0, 0, 0);
camera.updateMatrixWorld();

const mesh = (geometry: Mesh['geometry'], place: readonly [number, number, number] = [0, 0, 0]) => {
  const made = new Mesh(geometry, new MeshBasicNodeMaterial({ color: new Color(0.25, 0.25, 0.25) }));
  made.position.set(...place);
  made.updateMatrixWorld();
  return made;
};

const toPixel = (point: Vector3): Point => {
  const { x, y } = point.clone().project(camera);
  return [((x + 1) / 2) * SIZE.width, ((1 - y) / 2) * SIZE.height];
};

/** From a closed line. */
function distanceTo(loop: readonly Point[]): Distance {
  const sides = loop.map(([ax, ay], i) => {
    const [bx, by] = loop[(i + 1) % loop.length]!;
    const [dx, dy] = [bx - ax, by - ay];
    return { ax, ay, by, dx, dy, square: dx * dx + dy * dy };
  });
  return (x, y) => {
    let leastSquare = Number.POSITIVE_INFINITY;
    let crossings = 0;
    for (const { ax, ay, by, dx, dy, square } of sides) {
      const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square));
      leastSquare = Math.min(leastSquare, (ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2);
      if (ay > y !== by > y && ax + ((y - ay) / dy) * dx > x) crossings++;
    }
    const least = Math.sqrt(leastSquare);
    return crossings % 2 === 1 ? -least : least;
  };
}

/** Lines of sight touch a sphere on a circle, nearer than its middle by r²/d. */
function sphereEdge(middle: Vector3, radius: number): Distance {
  const toMiddle = middle.clone().sub(camera.position);
  const d = toMiddle.length();
  const axis = toMiddle.normalize();
  const u = new Vector3(0, 1, 0).cross(axis).normalize();
  const v = axis.clone().cross(u);
  const circle = radius * Math.sqrt(1 - (radius / d) ** 2);
  return distanceTo(
    Array.from({ length: 120 }, (_, i) => {
      const angle = (i * Math.PI) / 60;
      return toPixel(
        middle
          .clone()
          .addScaledVector(axis, (-radius * radius) / d)
          .addScaledVector(u, circle * Math.cos(angle))
          .addScaledVector(v, circle * Math.sin(angle)),
      );
    }),
  );
}

/** The hull of the corners: A. M. Andrew's monotone chain. */
function boxEdge({ geometry, matrixWorld }: Mesh): Distance {
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  const corners = Array.from({ length: 8 }, (_, i) =>
    toPixel(
      new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).applyMatrix4(
        matrixWorld,
      ),
    ),
  ).sort(([ax, ay], [bx, by]) => ax - bx || ay - by);
  const half = (points: readonly Point[]) => {
    const line: Point[] = [];
    for (const point of points) {
      const turn = ([ax, ay]: Point, [bx, by]: Point) =>
        (bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax);
      while (line.length > 1 && turn(line.at(-2)!, line.at(-1)!) <= 0) line.pop();
      line.push(point);
    }
    return line.slice(0, -1);
  };
  return distanceTo([...half(corners), ...half([...corners].reverse())]);
}

const covered = (distance: number, width: number) => Math.min(1, Math.max(0, width + 0.5 - distance));

/** A line and its halo over a ground, with nothing within. */
function over(
  ground: Rgb,
  distance: number,
  { rgb, width }: { rgb: Rgb; width: number },
  ratio: number,
): Rgb {
  const line = covered(distance, width * ratio);
  const halo = HALO.opacity * covered(distance, (width + HALO.width) * ratio);
  const outside = covered(-distance, 0);
  return ground.map((c, i) => {
    const drawn = line * rgb[i]! + (1 - line) * (1 - halo) * c;
    return outside * drawn + (1 - outside) * c;
  }) as unknown as Rgb;
}

interface Case {
  readonly front?: readonly [Mesh, Distance][];
  readonly back?: readonly [Mesh, Distance][];
  readonly ratio?: number;
}

const options = ({ front = [], back = [], ratio = 1 }: Case): OutlineOptions => ({
  front: { meshes: front.map(([m]) => m), color: FRONT.color, width: FRONT.width * ratio },
  back: { meshes: back.map(([m]) => m), color: BACK.color, width: BACK.width * ratio },
  halo: { width: HALO.width * ratio, opacity: HALO.opacity },
});

function frame(): void {
  const scene = new Scene();
  scene.background = new Color(0.25, 0.25, 0.25);
  renderer.render({ scene, camera }, { view }, SIZE);
}

async function outlined(shown: Case): Promise<Uint8Array> {
  frame();
  pass.render(three, camera, options(shown));
  return readCanvas();
}

/** Of all pixels, and of those that no edge of a line goes through, where the picture must be just what is expected. */
async function errors(shown: Case): Promise<{ mean: number; clear: number; drawn: number }> {
  const { front = [], back = [], ratio = 1 } = shown;
  const image = await outlined(shown);
  const nearest = (all: readonly [Mesh, Distance][], x: number, y: number) =>
    Math.min(...all.map(([, distance]) => distance(x, y)), 1e3);
  let [sum, clear, drawn] = [0, 0, 0];
  for (let y = 0; y < SIZE.height; y++)
    for (let x = 0; x < SIZE.width; x++) {
      const [f, b] = [nearest(front, x + 0.5, y + 0.5), nearest(back, x + 0.5, y + 0.5)];
      const expected = over(over(GROUND, b, BACK, ratio), f, FRONT, ratio);
      const at = 4 * (y * SIZE.width + x);
      const error = Math.max(...expected.map((c, i) => Math.abs(c - image[at + i]!)));
      const edges = [f, f - FRONT.width * ratio, f - (FRONT.width + HALO.width) * ratio];
      edges.push(b, b - BACK.width * ratio, b - (BACK.width + HALO.width) * ratio);
      if (edges.every((edge) => Math.abs(edge) > 1)) clear = Math.max(clear, error);
      const isDrawn = Math.max(...expected.map((c, i) => Math.abs(c - GROUND[i]!))) > 1;
      if (isDrawn) {
        sum += error;
        drawn++;
      }
    }
  return { mean: sum / drawn, clear, drawn };
}

const sphereAt = (place: readonly [number, number, number], radius = 1): [Mesh, Distance] => [
  mesh(new SphereGeometry(radius, 192, 128), place),
  sphereEdge(new Vector3(...place), radius),
];

function boxAt(
  place: readonly [number, number, number],
  scale: readonly [number, number, number],
): [Mesh, Distance] {
  const box = mesh(new BoxGeometry(1, 1, 1), place);
  box.rotation.set(0.5, 0.7, 0.2);
  box.scale.set(...scale);
  box.updateMatrixWorld();
  return [box, boxEdge(box)];
}

/** A floor from behind the camera to before it, as far as it is before the camera; its back is what is seen. */
function floor(): [Mesh, Distance] {
  const [width, near, far, y] = [1.5, 30, -6, -0.8];
  const made = mesh(new PlaneGeometry(width, near - far), [0, y, (near + far) / 2]);
  made.rotation.x = Math.PI / 2;
  made.updateMatrixWorld();
  // A little before the lens, which is far below the picture.
  const start = new Vector3(0, y, 4.5);
  const ends = [-width / 2, width / 2].flatMap((x) => [new Vector3(x, y, far), new Vector3(x, y, start.z)]);
  const [a, b, c, d] = ends.map(toPixel) as [Point, Point, Point, Point];
  return [made, distanceTo([a, b, d, c])];
}

describe('an outline', () => {
  it.each<[string, Case]>([
    ['of a sphere', { front: [sphereAt([0.5, 0.2, 0])] }],
    ['of a box, stretched and mirrored', { front: [boxAt([0, 0, 0], [1.5, -1, 2])] }],
    ['twice as wide', { front: [sphereAt([0, 0, 0])], ratio: 2 }],
    ['of two together', { back: [sphereAt([0.6, 0, 0]), boxAt([-0.6, 0, -1], [1, 1, 1])] }],
    ['of one over another', { front: [sphereAt([0.6, 0, -1])], back: [boxAt([-0.4, 0, 0], [1, 2, 1])] }],
    [
      'and of both, wider',
      { front: [sphereAt([0.6, 0, -1])], back: [boxAt([-0.4, 0, 0], [1, 2, 1])], ratio: 2 },
    ],
    ['of what is partly out of view', { front: [sphereAt([-2.6, 0.3, 0])], back: [sphereAt([2, -1.5, 0])] }],
    ['of what is just out of view', { front: [sphereAt([-3.42, 0, 0])] }],
    ['of what reaches behind the camera', { back: [floor()] }],
  ])('%s', async (_, shown) => {
    const { drawn, clear, mean } = await errors(shown);
    expect(drawn).toBeGreaterThan(200);
    expect(clear).toBeLessThan(2);
    // Of 255, where edges are drawn a third of a pixel beside their place at most.
    expect(mean).toBeLessThan(9 / (shown.ratio ?? 1));
  });

  it('is not in what is read back, and gone with the next frame', async () => {
    frame();
    const [canvas, image, radiance] = [
      await readCanvas(),
      await renderer.readImage(view),
      await renderer.readRadiance(),
    ];
    expect(canvas).toEqual(image);
    expect(await outlined({ front: [sphereAt([0, 0, 0])] })).not.toEqual(image);
    expect(await renderer.readImage(view)).toEqual(image);
    expect(await renderer.readRadiance()).toEqual(radiance);
    renderer.renderAgain({ view });
    expect(await readCanvas()).toEqual(image);
  });

  it('of nothing, or of nothing in view, draws nothing; of what surrounds the camera there is none', async () => {
    const plain = await outlined({});
    const { calls } = three.info.render;
    const behind = mesh(new SphereGeometry(1), [0, 0, 9]);
    const beside = mesh(new SphereGeometry(1), [9, 0, 0]);
    for (const meshes of [[], [behind, beside]]) {
      pass.render(three, camera, { ...options({}), front: { ...options({}).front, meshes } });
      expect(three.info.render.calls).toBe(calls);
    }
    const room = mesh(new BoxGeometry(30, 30, 30));
    expect(await outlined({ front: [[room, () => -1]] })).toEqual(plain);
  });
});
