/** Numbers that are typed during a drag, and how things are aligned. */
import { PerspectiveCamera, Ray, Vector3 } from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { gizmoView } from '../../../src/editor/viewport/gizmo/camera-view.ts';
import { worldAxes } from '../../../src/editor/viewport/gizmo/frame.ts';
import { axesIn, type GizmoTool, type HandleId } from '../../../src/editor/viewport/gizmo/handles.ts';
import { changeOf, constrain, type Held } from '../../../src/editor/viewport/gizmo/held.ts';
import type { Change } from '../../../src/editor/viewport/gizmo/placed.ts';
import { typedAfter, typedChange } from '../../../src/editor/viewport/gizmo/typed.ts';
import { alignedBy } from '../../../src/editor/viewport/placing/align.ts';

const camera = new PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 0, 10);
camera.updateMatrixWorld();
const frame = { pivot: new Vector3(), axes: worldAxes() };
const view = gizmoView(camera, 400, 400, frame.pivot);
const typed = (text: string, tool: GizmoTool, id: HandleId) => typedChange(text, tool, id, frame, view);
const offset = (change: Change | null) => (change?.type === 'move' ? change.offset.toArray() : null);

describe('what is typed', () => {
  test('is a number with arithmetic, and nothing else', () => {
    expect(typedAfter('1', '.')).toBe('1.');
    expect(typedAfter('1.', 'Backspace')).toBe('1');
    expect(typedAfter('', 'Backspace')).toBe('');
    for (const key of ['x', 'F2', 'Shift', 'é', '#']) expect(typedAfter('1', key)).toBeNull();
    expect(typedAfter('1'.repeat(40), '1')).toBeNull();
  });

  test('moves by metres, along the axes of the handle in their order', () => {
    expect(offset(typed('1.5', 'move', 'y'))).toEqual([0, 1.5, 0]);
    expect(offset(typed('-1/4', 'move', 'x'))).toEqual([-0.25, 0, 0]);
    expect(offset(typed('1 2', 'move', 'zx'))).toEqual([1, 0, 2]);
    expect(offset(typed('1 2 3', 'move', 'centre'))).toEqual([1, 2, 3]);
    expect(offset(typed('1,5', 'move', 'centre'))).toEqual([1.5, 0, 0]);
    for (const text of ['', '-', '1/', '1 +', '1/0']) expect(typed(text, 'move', 'x')).toBeNull();
  });

  test('turns by degrees, about the axis of the ring or the line of sight', () => {
    const about = (id: HandleId) => {
      const change = typed('90', 'rotate', id);
      return change?.type === 'turn' ? [change.axis.toArray(), change.angle] : null;
    };
    expect(about('x')).toEqual([[1, 0, 0], Math.PI / 2]);
    expect(about('view')).toEqual([[0, 0, 1], Math.PI / 2]);
  });

  test('scales by factors above 0, one for all of the handle’s axes or one each', () => {
    const factors = (text: string, id: HandleId) => {
      const change = typed(text, 'scale', id);
      return change?.type === 'scale' ? change.factors : null;
    };
    expect(factors('2', 'centre')).toEqual([2, 2, 2]);
    expect(factors('2', 'xy')).toEqual([2, 2, 1]);
    expect(factors('2 3', 'yz')).toEqual([1, 2, 3]);
    expect(factors('0', 'x')).toBeNull();
    expect(factors('-1', 'x')).toBeNull();
  });
});

/** A pointer over the middle of the picture, so many pixels to the right and up. */
function pointer(right: number, up: number) {
  const at = { x: 200 + right, y: 200 - up };
  const direction = new Vector3(right * view.pixel, up * view.pixel, -10).normalize();
  return { at, ray: new Ray(camera.position.clone(), direction) };
}

function held(tool: GizmoTool): Held {
  const start = pointer(80, 0);
  return {
    ...{
      pointerId: null,
      start,
      merge: 'drag',
      steps: { move: 0.1, rotate: 15, scale: 0.1 },
      selected: [],
      copies: false,
      moved: true,
      change: null,
    },
    grip: { handle: tool === 'rotate' ? 'view' : 'centre' },
    stand: { movers: [], frame, tool, view, handles: [] },
    drag: null,
    last: { pointer: start, ctrl: false },
    typed: '',
  };
}

describe('x, y and z', () => {
  test('hold a move to an axis, with Shift to the plane across it; once more it is free', () => {
    const drag = held('move');
    drag.last = { pointer: pointer(120, 0), ctrl: false };
    expect(constrain(drag, 'X', false)).toBe(true);
    const along = offset(changeOf(drag, false))!;
    expect(along[0]).toBeCloseTo(40 * view.pixel, 6);
    expect([along[1], along[2]]).toEqual([0, 0]);
    constrain(drag, 'x', true);
    expect(drag.grip).toEqual({ handle: 'yz' });
    constrain(drag, 'x', true);
    expect(drag.grip).toEqual({ handle: 'centre' });
    drag.last = { pointer: pointer(120, 30), ctrl: false };
    expect(offset(changeOf(drag, false))![1]).toBeCloseTo(30 * view.pixel, 6);
    drag.typed = '2';
    constrain(drag, 'z', false);
    expect(offset(changeOf(drag, false))).toEqual([0, 0, 2]);
    for (const key of ['q', 'Shift', '1']) expect(constrain(drag, key, false)).toBe(false);
  });

  test('scale one axis by the way of the middle, and turn about one', () => {
    const drag = held('scale');
    constrain(drag, 'y', false);
    drag.last = { pointer: pointer(200, 0), ctrl: false };
    expect(changeOf(drag, false)).toEqual({ type: 'scale', factors: [1, 2, 1] });
    const turn = held('rotate');
    constrain(turn, 'z', true);
    expect(turn.grip).toEqual({ handle: 'z' });
    turn.last = { pointer: pointer(0, 80), ctrl: false };
    const change = changeOf(turn, false);
    expect(change?.type === 'turn' && change.angle).toBeCloseTo(Math.PI / 2, 6);
  });
});

test('a handle names its axes', () => {
  expect((['x', 'yz', 'zx', 'centre', 'view'] as const).map(axesIn)).toEqual([
    [0],
    [1, 2],
    [0, 2],
    [0, 1, 2],
    [],
  ]);
});

describe('things of different sizes', () => {
  const extents = [
    { low: 0, high: 2 },
    { low: 5, high: 6 },
    { low: 3, high: 3 },
    { low: 9, high: 13 },
  ];

  test('are aligned by their lower and upper ends and their middles', () => {
    expect(alignedBy(extents, 'low')).toEqual([0, -5, -3, -9]);
    expect(alignedBy(extents, 'high')).toEqual([11, 7, 10, 0]);
    expect(alignedBy(extents, 'middle')).toEqual([5.5, 1, 3.5, -4.5]);
  });

  test('are spread with gaps alike, the outermost as they are; two are', () => {
    const by = alignedBy(extents, 'spread');
    expect([by[0], by[3]]).toEqual([0, 0]);
    const ends = [0, 2, 1, 3].map((i) => [extents[i]!.low + by[i]!, extents[i]!.high + by[i]!] as const);
    const gaps = ends.slice(1).map(([low], i) => low - ends[i]![1]);
    for (const gap of gaps) expect(gap).toBeCloseTo(2, 12);
    expect(alignedBy(extents.slice(0, 2), 'spread')).toEqual([0, 0]);
  });
});
