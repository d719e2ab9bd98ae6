/** What a gizmo's handles mean, against closed forms and at random. */
import { Matrix4, PerspectiveCamera, Quaternion, Ray, Raycaster, Vector2, Vector3 } from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import type { Entity } from '../../../src/editor/state.ts';
import { gizmoView } from '../../../src/editor/viewport/gizmo/camera-view.ts';
import { type Pointer, startDrag } from '../../../src/editor/viewport/gizmo/drag.ts';
import {
  aimedAxes,
  axesOf,
  type Frame,
  turnOf,
  worldAxes,
} from '../../../src/editor/viewport/gizmo/frame.ts';
import {
  type GizmoTool,
  type Handle,
  type HandleId,
  handleAt,
  handlesOf,
  SIZES,
} from '../../../src/editor/viewport/gizmo/handles.ts';
import { canBe, frameOf, moversOf } from '../../../src/editor/viewport/gizmo/movers.ts';
import {
  changed,
  handStep,
  type Placed,
  roundTo,
  type Triple,
} from '../../../src/editor/viewport/gizmo/placed.ts';
import { alongLine, angleAbout, onPlane, unwrapped } from '../../../src/editor/viewport/gizmo/rays.ts';
import { readout } from '../../../src/editor/viewport/gizmo/readout.ts';
import { nearestRotation } from '../../../src/editor/viewport/gizmo/rotation.ts';
import type { Pixel } from '../../../src/editor/viewport/projector.ts';
import { addLight, addObject } from '../../../src/scene/commands.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

const STEPS = { move: 0.1, rotate: 15, scale: 0.1 };

const random = createRandom(7);
const between = (low: number, high: number) => low + (high - low) * random();
const anyVector = (size = 3) => new Vector3(between(-size, size), between(-size, size), between(-size, size));
const anyTurn = () =>
  new Quaternion(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)).normalize();
const times = (count: number, run: () => void) => {
  for (let i = 0; i < count; i++) run();
};

const [WIDTH, HEIGHT] = [900, 600];

function cameraAt(position: Vector3, target: Vector3): PerspectiveCamera {
  const camera = new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 100);
  camera.position.copy(position);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return camera;
}

/** The pointer over a point of the world. */
function over(camera: PerspectiveCamera, point: Vector3): Pointer {
  const { x, y } = point.clone().project(camera);
  const raycaster = new Raycaster();
  raycaster.setFromCamera(new Vector2(x, y), camera);
  return { at: { x: ((x + 1) / 2) * WIDTH, y: ((1 - y) / 2) * HEIGHT }, ray: raycaster.ray };
}

function scene(frame: Frame, from = new Vector3(2, 3, 6)) {
  const camera = cameraAt(frame.pivot.clone().add(from), frame.pivot);
  return { camera, view: gizmoView(camera, WIDTH, HEIGHT, frame.pivot) };
}

const level: Frame = { pivot: new Vector3(1, 0.5, -2), axes: worldAxes() };

describe('rays', () => {
  it('the nearest point of a line to a ray: the way between both is perpendicular to both', () =>
    times(200, () => {
      const [point, direction] = [anyVector(), anyVector().normalize()];
      const ray = new Ray(anyVector(), anyVector().normalize());
      const t = alongLine(ray, point, direction) as number;
      const near = point.clone().addScaledVector(direction, t);
      const away = near.sub(ray.origin);
      away.addScaledVector(ray.direction, -away.dot(ray.direction));
      expect(Math.abs(away.dot(direction))).toBeLessThan(1e-6 * (1 + Math.abs(t)));
    }));

  it('say nothing about a line that they are parallel to, or a plane that they never meet', () => {
    const ray = new Ray(new Vector3(0, 1, 0), new Vector3(1, 0, 0));
    expect(alongLine(ray, new Vector3(), new Vector3(1, 0, 0))).toBeNull();
    expect(onPlane(ray, new Vector3(), new Vector3(0, 1, 0))).toBeNull();
    expect(onPlane(ray, new Vector3(-1, 0, 0), new Vector3(1, 0, 0))).toBeNull();
    expect(onPlane(ray, new Vector3(2, 0, 0), new Vector3(1, 0, 0))?.toArray()).toEqual([2, 1, 0]);
  });

  it('an angle about an axis grows counter-clockwise, and without a jump', () => {
    const [zero, axis] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0)];
    expect(angleAbout(new Vector3(0, 5, -2), new Vector3(), axis, zero)).toBeCloseTo(Math.PI / 2, 12);
    expect(unwrapped(-3, 3)).toBeCloseTo(2 * Math.PI - 3, 12);
  });
});

describe('angles of a turn', () => {
  it('are the turn, and no further from what they were than any other triple', () =>
    times(300, () => {
      const turn = anyTurn();
      const before: Triple = [between(-400, 400), between(-400, 400), between(-400, 400)];
      const rotation = nearestRotation(turn, before);
      expect(Math.abs(turnOf(rotation).dot(turn))).toBeCloseTo(1, 9);
      const [x, y, z] = rotation;
      const distance = (r: Triple) => r.reduce((sum, a, i) => sum + (a - (before[i] as number)) ** 2, 0);
      for (const other of [
        [x + 180, 180 - y, z + 180],
        [x - 180, 180 - y, z - 180],
        [x + 360, y, z],
        [x, y - 360, z],
      ] as Triple[])
        expect(distance(rotation)).toBeLessThanOrEqual(distance(other) + 1e-6);
    }));

  it('keep the third where the second is 90 or -90 degrees and only a sum is known', () => {
    for (const before of [
      [20, 90, 50],
      [20, -90, 50],
    ] as Triple[]) {
      const rotation = nearestRotation(turnOf(before), before);
      for (const [i, degrees] of before.entries()) expect(rotation[i]).toBeCloseTo(degrees, 4);
    }
  });

  it('run on through 90 degrees about the second axis', () => {
    let rotation: Triple = [0, 0, 0];
    for (let degrees = 1; degrees <= 400; degrees++) {
      const turn = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), (degrees * Math.PI) / 180);
      rotation = nearestRotation(turn, rotation);
      expect(rotation[0]).toBeCloseTo(0, 4);
      expect(rotation[1]).toBeCloseTo(degrees, 4);
      expect(rotation[2]).toBeCloseTo(0, 4);
    }
  });
});

describe('a change', () => {
  const placed: Placed = { position: [1, 2, 3], rotation: [10, 20, 30], scale: [1, 2, 3] };
  const own = axesOf(turnOf([10, 20, 30]));

  it('moves along an axis, and leaves the other numbers as they were written', () => {
    const odd: Placed = { position: [0.123456789, 2, -3.3333333] };
    const move = { type: 'move', offset: new Vector3(0, 0.5, 0) } as const;
    expect(changed(odd, own, move, level, 0.001).position).toEqual([0.123456789, 2.5, -3.3333333]);
  });

  it('turns about the pivot as a rotation matrix does', () =>
    times(50, () => {
      const axis = anyVector().normalize();
      const angle = between(-3, 3);
      const turned = changed(placed, own, { type: 'turn', axis, angle }, level, 1e-6);
      const matrix = new Matrix4()
        .makeTranslation(level.pivot)
        .multiply(new Matrix4().makeRotationAxis(axis, angle))
        .multiply(new Matrix4().makeTranslation(level.pivot.clone().negate()));
      const expected = new Vector3(1, 2, 3).applyMatrix4(matrix);
      expect(new Vector3(...turned.position).distanceTo(expected)).toBeLessThan(2e-6);
      const turn = new Quaternion().setFromAxisAngle(axis, angle).multiply(turnOf([10, 20, 30]));
      // Degrees are written with two decimals.
      expect(turnOf(turned.rotation as Triple).angleTo(turn)).toBeLessThan(3e-4);
    }));

  it('turns the target of a light about the light', () => {
    const light: Placed = { position: [1, 0.5, -2], target: [2, 0.5, -2] };
    const turn = { type: 'turn', axis: new Vector3(0, 1, 0), angle: Math.PI / 2 } as const;
    expect(changed(light, worldAxes(), turn, level, 1e-6)).toEqual({
      position: [1, 0.5, -2],
      target: [1, 0.5, -3],
    });
  });

  it('scales along the object’s own axes, and places about the pivot', () => {
    const frame = { pivot: new Vector3(), axes: own };
    const scaled = changed(placed, own, { type: 'scale', factors: [2, 1, 1] }, frame, 1e-6);
    expect(scaled.scale).toEqual([2, 2, 3]);
    const along = (p: Triple, i: number) => new Vector3(...p).dot(own[i] as Vector3);
    expect(along(scaled.position, 0)).toBeCloseTo(2 * along([1, 2, 3], 0), 5);
    expect(along(scaled.position, 1)).toBeCloseTo(along([1, 2, 3], 1), 5);
  });

  it('makes an object at an angle as long along its axes as the world’s scale would make it', () => {
    const turned = axesOf(turnOf([0, 90, 0]));
    const box: Placed = { position: [0, 0, 0], rotation: [0, 90, 0], scale: [1, 1, 1] };
    const frame = { pivot: new Vector3(), axes: worldAxes() };
    const { scale } = changed(box, turned, { type: 'scale', factors: [3, 1, 1] }, frame, 1e-6);
    // The object's z lies along the world's x.
    expect(scale).toEqual([1, 1, 3]);
  });

  it('sizes a rectangle light', () => {
    const light: Placed = { position: [0, 2, 0], target: [0, 0, 0], width: 2, height: 1 };
    const axes = aimedAxes([0, 2, 0], [0, 0, 0]);
    const frame = { pivot: new Vector3(0, 2, 0), axes };
    const scaled = changed(light, axes, { type: 'scale', factors: [1.5, 2, 1] }, frame, 1e-6);
    expect(scaled).toMatchObject({ position: [0, 2, 0], target: [0, 0, 0], width: 3, height: 2 });
  });

  it('is as fine as the hand', () => {
    expect(handStep(0.01)).toBeCloseTo(0.001, 12);
    expect(handStep(100)).toBeCloseTo(0.01, 12);
    expect(roundTo(-0.00001, 0.001)).toBe(0);
    expect(roundTo(0.3000004, 0.1)).toBe(0.3);
  });
});

describe('a drag', () => {
  it('along an axis follows the pointer, wherever the camera is', () =>
    times(60, () => {
      const frame: Frame = { pivot: anyVector(), axes: axesOf(anyTurn()) };
      const { camera, view } = scene(frame, anyVector(1).setLength(between(3, 10)));
      for (const [i, id] of (['x', 'y', 'z'] as const).entries()) {
        const axis = frame.axes[i] as Vector3;
        if (Math.abs(axis.dot(camera.getWorldDirection(new Vector3()))) > 0.9) continue;
        const grabbed = frame.pivot.clone().addScaledVector(axis, 0.4);
        const drag = startDrag('move', id, frame, view, over(camera, grabbed), STEPS);
        const change = drag(over(camera, grabbed.clone().addScaledVector(axis, 0.7)), false);
        if (change?.type !== 'move') throw new Error('no move');
        expect(change.offset.distanceTo(axis.clone().multiplyScalar(0.7))).toBeLessThan(1e-6);
      }
    }));

  it('in a plane and in the screen’s plane follows the pointer', () => {
    const { camera, view } = scene(level);
    const grabbed = level.pivot.clone();
    const plane = startDrag('move', 'zx', level, view, over(camera, grabbed), STEPS);
    const change = plane(over(camera, grabbed.clone().add(new Vector3(0.5, 0, -0.8))), false);
    if (change?.type !== 'move') throw new Error('no move');
    expect(change.offset.distanceTo(new Vector3(0.5, 0, -0.8))).toBeLessThan(1e-6);
    const screen = startDrag('move', 'centre', level, view, over(camera, grabbed), STEPS);
    const [right, up] = [new Vector3(), new Vector3()];
    camera.matrixWorld.extractBasis(right, up, new Vector3());
    const to = grabbed.clone().addScaledVector(right, 0.4).addScaledVector(up, -0.2);
    const across = screen(over(camera, to), false);
    if (across?.type !== 'move') throw new Error('no move');
    expect(across.offset.distanceTo(to.sub(grabbed))).toBeLessThan(1e-6);
  });

  it('goes in steps of 0.1 m, 15 degrees and 0.1', () => {
    const { camera, view } = scene(level);
    const grabbed = level.pivot.clone().add(new Vector3(0.4, 0, 0));
    const move = startDrag('move', 'x', level, view, over(camera, grabbed), STEPS);
    const moved = move(over(camera, grabbed.clone().add(new Vector3(0.372, 0, 0))), true);
    if (moved?.type !== 'move') throw new Error('no move');
    expect(moved.offset.x).toBeCloseTo(0.4, 9);
    const turn = startDrag('rotate', 'y', level, view, over(camera, grabbed), STEPS);
    const turnedTo = (degrees: number) =>
      grabbed
        .clone()
        .sub(level.pivot)
        .applyAxisAngle(new Vector3(0, 1, 0), (degrees * Math.PI) / 180)
        .add(level.pivot);
    const turned = turn(over(camera, turnedTo(38)), true);
    expect(turned?.type === 'turn' && (turned.angle * 180) / Math.PI).toBeCloseTo(45, 9);
    const scale = startDrag('scale', 'x', level, view, over(camera, grabbed), STEPS);
    const scaled = scale(over(camera, grabbed.clone().add(new Vector3(0.11, 0, 0))), true);
    expect(scaled?.type === 'scale' && scaled.factors[0]).toBeCloseTo(1.3, 9);
  });

  it('round a ring counts more than one turn', () => {
    const { camera, view } = scene(level);
    const at = (degrees: number) =>
      over(
        camera,
        new Vector3(0.5, 0, 0)
          .applyAxisAngle(new Vector3(0, 1, 0), (degrees * Math.PI) / 180)
          .add(level.pivot),
      );
    const drag = startDrag('rotate', 'y', level, view, at(0), STEPS);
    let angle = 0;
    for (let degrees = 0; degrees <= 500; degrees += 20) {
      const change = drag(at(degrees), false);
      angle = change?.type === 'turn' ? (change.angle * 180) / Math.PI : Number.NaN;
    }
    expect(angle).toBeCloseTo(500, 5);
  });

  it('along a ring that is seen from its edge turns the near side with the pointer', () => {
    const { camera, view } = scene(level, new Vector3(0, 0.1, 6));
    const near = level.pivot.clone().add(new Vector3(0, 0, 0.5));
    const drag = startDrag('rotate', 'y', level, view, over(camera, near), STEPS);
    const change = drag(over(camera, near.clone().add(new Vector3(0.1, 0, 0))), false);
    // The near side goes to the right: counter-clockwise from above. The radius on the screen is one radian, seen at the pivot.
    const [from, to] = [near, near.clone().add(new Vector3(0.1, 0, 0))].map(
      (point) => over(camera, point).at.x,
    );
    const expected = (to! - from!) / SIZES.ring;
    expect(change?.type === 'turn' && change.angle).toBeCloseTo(expected, 3);
    // In the ring's plane the pointer would be far away, or nowhere.
    const above = drag(over(camera, near.clone().add(new Vector3(0.1, 0.3, 0))), false);
    expect(above?.type === 'turn' && above.angle).toBeCloseTo(expected, 1);
  });

  it('goes in other steps, and no scale in steps is less than one', () => {
    const { camera, view } = scene(level);
    const at = (x: number) => over(camera, level.pivot.clone().add(new Vector3(x, 0, 0)));
    const coarse = { move: 0.5, rotate: 45, scale: 0.25 };
    const scale = startDrag('scale', 'x', level, view, at(0.4), coarse);
    const factorAt = (x: number) => {
      const change = scale(at(x), true);
      return change?.type === 'scale' ? change.factors[0] : null;
    };
    expect([factorAt(0.49), factorAt(0.01), factorAt(-1)]).toEqual([1.25, 0.25, 0.25]);
    const moved = startDrag('move', 'x', level, view, at(0), coarse)(at(0.7), true);
    expect(moved?.type === 'move' && moved.offset.x).toBeCloseTo(0.5, 9);
  });

  it('of the square between two axes scales along its diagonal', () => {
    const { camera, view } = scene(level);
    const at = (x: number, y: number) => over(camera, level.pivot.clone().add(new Vector3(x, y, 0)));
    const drag = startDrag('scale', 'xy', level, view, at(0.3, 0.3), STEPS);
    const factorsAt = (x: number, y: number) => {
      const change = drag(at(x, y), false);
      return change?.type === 'scale' ? change.factors : [];
    };
    for (const [x, y] of [
      [0.6, 0.6],
      [0.9, 0.3],
      [0.2, 1],
    ] as const) {
      const [fx, fy, fz] = factorsAt(x, y);
      expect([fx, fy]).toEqual([fy, fx]);
      expect(fx).toBeCloseTo(2, 6);
      expect(fz).toBe(1);
    }
  });

  it('never turns anything inside out', () => {
    const { camera, view } = scene(level);
    const grabbed = level.pivot.clone().add(new Vector3(0.4, 0, 0));
    const drag = startDrag('scale', 'x', level, view, over(camera, grabbed), STEPS);
    const change = drag(over(camera, level.pivot.clone().add(new Vector3(-1, 0, 0))), false);
    expect(change?.type === 'scale' && change.factors).toEqual([0.01, 1, 1]);
  });
});

describe('what is moved', () => {
  const store = new DocumentStore(createDocument());
  const [box, ball] = [addObject(store, 'box'), addObject(store, 'sphere')];
  const [lamp, sun] = [addLight(store, 'point'), addLight(store, 'directional')];
  const ambient = addLight(store, 'ambient');
  store.edit('place', ({ objects, lights }) => {
    Object.assign(objects[box] as object, { position: [0, 0, 0], rotation: [0, 90, 0] });
    Object.assign(objects[ball] as object, { position: [4, 0, 2] });
    Object.assign(lights[lamp] as object, { position: [2, 3, 1] });
  });
  const objects = [box, ball].map((id) => ({ kind: 'objects', id }) as const);
  const lights = [lamp, sun, ambient].map((id) => ({ kind: 'lights', id }) as const);
  const material = { kind: 'materials', id: Object.keys(store.document.materials)[0] as string } as const;
  const options = { tool: 'move', space: 'world', pivot: 'middle' } as const;

  it('is what stands somewhere and is not locked', () => {
    const all = [...objects, ...lights, material];
    expect(moversOf(store.document, all).map(({ id }) => id)).toEqual([box, ball, lamp, sun]);
    store.edit('lock', (draft) => {
      Object.assign(draft.objects[ball] as object, { locked: true });
    });
    expect(moversOf(store.document, all).map(({ id }) => id)).toEqual([box, lamp, sun]);
    store.undo();
  });

  it('has its gizmo in the middle, or at the last', () => {
    const movers = moversOf(store.document, objects);
    expect(frameOf(movers, options)?.pivot.toArray()).toEqual([2, 0, 1]);
    expect(frameOf(movers, { ...options, pivot: 'last' })?.pivot.toArray()).toEqual([4, 0, 2]);
    expect(frameOf([], options)).toBeNull();
  });

  it('has its own axes, or the world’s; a scale of one thing is along its own', () => {
    const movers = moversOf(store.document, objects.slice(0, 1));
    const x = (more: object) =>
      frameOf(movers, { ...options, ...more })
        ?.axes[0].toArray()
        .map(Math.round);
    expect(x({})).toEqual([1, 0, 0]);
    expect(x({ space: 'local' })).toEqual([0, 0, -1]);
    expect(x({ tool: 'scale' })).toEqual([0, 0, -1]);
  });

  it('can be turned and scaled unless it is a point', () => {
    const can = (tool: GizmoTool, ...refs: Entity[]) => canBe(tool, moversOf(store.document, refs));
    const [point, directional] = lights as [Entity, Entity, Entity];
    expect([can('move', point), can('rotate', point), can('scale', point)]).toEqual([true, false, false]);
    expect([can('rotate', directional), can('scale', directional)]).toEqual([true, false]);
    expect(can('scale', point, directional)).toBe(true);
  });
});

const middleOf = (points: readonly Pixel[]): Pixel => ({
  x: points.reduce((sum, { x }) => sum + x, 0) / points.length,
  y: points.reduce((sum, { y }) => sum + y, 0) / points.length,
});

describe('the handles', () => {
  it('are hit where they are drawn, and nowhere far from them', () =>
    times(40, () => {
      const frame: Frame = { pivot: anyVector(), axes: axesOf(anyTurn()) };
      const { view } = scene(frame, anyVector(1).setLength(between(2, 20)));
      const centre = view.project(frame.pivot);
      for (const tool of ['move', 'rotate', 'scale'] as const) {
        const handles = handlesOf(tool, frame, view);
        for (const handle of handles) {
          const { points, area } = handle;
          const end = area ? middleOf(points) : points.at(-1);
          if (!end || !centre || handle.strength < 0.25) continue;
          // Something is there; at an axis' end it is that axis, unless another lies over it.
          expect(handleAt(handles, end, 7)).not.toBeNull();
        }
        if (centre) expect(handleAt(handles, { x: centre.x + 130, y: centre.y + 130 }, 7)).toBeNull();
      }
    }));

  it('are grabbed where they are nearest, and not where they are hardly seen', () => {
    const line = (id: HandleId, y: number, strength = 1): Handle => ({
      ...{ id, area: false, away: [], depth: 0, strength },
      points: [
        { x: 0, y },
        { x: 100, y },
      ],
    });
    const at = { x: 50, y: 2 };
    expect(handleAt([line('x', 0), line('y', 7)], at, 7)).toBe('x');
    expect(handleAt([line('y', 7), line('x', 0)], at, 7)).toBe('x');
    expect(handleAt([line('x', 0, 0.2), line('y', 7)], at, 7)).toBe('y');
    expect(handleAt([line('x', 0, 0.2)], at, 7)).toBeNull();
    // Of two that are as near, the later one is in front.
    expect(handleAt([line('x', 0), line('z', 0)], at, 7)).toBe('z');
  });

  it('are as large near as far away', () => {
    for (const distance of [1, 10, 80]) {
      const { view } = scene(level, new Vector3(0, 0, distance));
      const x = handlesOf('move', level, view).find(({ id }) => id === 'x');
      const [from, to] = x?.points ?? [];
      expect(to && from && to.x - from.x).toBeCloseTo(SIZES.axis - SIZES.axisFrom, 3);
    }
  });

  it('that point at the eye are not there, nor planes seen from their edges', () => {
    const { view } = scene(level, new Vector3(0, 0, 6));
    const ids = handlesOf('move', level, view).map(({ id }) => id);
    expect(ids.sort()).toEqual(['centre', 'x', 'xy', 'y']);
  });

  it('behind the camera are not there', () => {
    const camera = cameraAt(new Vector3(0, 0, 5), new Vector3());
    const frame = { pivot: new Vector3(0, 0, 9), axes: worldAxes() };
    expect(handlesOf('move', frame, gizmoView(camera, WIDTH, HEIGHT, frame.pivot))).toEqual([]);
  });
});

it('the numbers of a drag', () => {
  const offset = new Vector3(0.5, -0.25, 0);
  expect(readout('x', { type: 'move', offset }, level, 0.001)).toBe('X +0.500 m');
  expect(readout('xy', { type: 'move', offset }, level, 0.01)).toBe('X +0.50  Y −0.25 m');
  expect(readout('centre', { type: 'move', offset }, level, 0.01)).toBe('X +0.50  Y −0.25  Z 0.00 m');
  expect(readout('y', { type: 'turn', axis: new Vector3(), angle: -Math.PI / 6 }, level, 1)).toBe('−30.0°');
  expect(readout('z', { type: 'scale', factors: [1, 1, 1.5] }, level, 1)).toBe('Z × 1.50');
  expect(readout('centre', { type: 'scale', factors: [2, 2, 2] }, level, 1)).toBe('× 2.00');
});
