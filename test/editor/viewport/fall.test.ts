/** How far things fall, against closed forms. */
import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  Matrix4,
  PlaneGeometry,
  SphereGeometry,
} from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import { type Body, fallOf, type Triangles } from '../../../src/editor/viewport/placing/fall.ts';

function soup(geometry: BufferGeometry, matrix = new Matrix4()): Triangles {
  const flat = geometry.index ? geometry.toNonIndexed() : geometry;
  return Float64Array.from(flat.applyMatrix4(matrix).getAttribute('position').array);
}

function body(triangles: Triangles): Body {
  const heights = triangles.filter((_, i) => i % 3 === 1);
  return { triangles, middle: (Math.min(...heights) + Math.max(...heights)) / 2 };
}

const at = (x: number, y: number, z: number) => new Matrix4().makeTranslation(x, y, z);
const floor = soup(new PlaneGeometry(10, 10).rotateX(-Math.PI / 2));
const box = (x: number, y: number, z: number) => soup(new BoxGeometry(1, 1, 1), at(x, y, z));

describe('something falls', () => {
  it('onto the floor: its lowest point touches it', () => {
    expect(fallOf([body(box(0, 3, 0))], [floor])).toBeCloseTo(2.5, 6);
    const sphere = soup(new SphereGeometry(1, 32, 16), at(1, 4, 2));
    expect(fallOf([body(sphere)], [floor])).toBeCloseTo(3, 6);
  });

  it('onto what is below it, not onto what is beside it', () => {
    expect(fallOf([body(box(0, 5, 0))], [floor, box(0.9, 0.5, 0)])).toBeCloseTo(3.5, 6);
    expect(fallOf([body(box(0, 5, 0))], [floor, box(1, 0.5, 0)])).toBeCloseTo(4.5, 6);
  });

  it('to y = 0 where nothing is below', () => {
    expect(fallOf([body(box(20, 5, 0))], [floor])).toBeCloseTo(4.5, 6);
    expect(fallOf([body(box(0, -3, 0))], [])).toBeCloseTo(-3.5, 6);
  });

  it('onto a ground that holds everything, and out of it', () => {
    expect(fallOf([body(box(20, 5, 0))], [floor], 1)).toBeCloseTo(3.5, 6);
    expect(fallOf([body(box(0, 5, 0))], [floor], -1)).toBeCloseTo(4.5, 6);
    expect(fallOf([body(box(0, 5, 0))], [floor], 1)).toBeCloseTo(3.5, 6);
    expect(fallOf([body(box(20, 0, 0))], [], 1)).toBeCloseTo(-1.5, 6);
  });

  it('not at all where it stands; out of what it has sunk into; from under a table to the floor', () => {
    expect(fallOf([body(box(0, 0.5, 0))], [floor])).toBeCloseTo(0, 6);
    expect(fallOf([body(box(0, 0.3, 0))], [floor])).toBeCloseTo(-0.2, 6);
    const table = soup(new BoxGeometry(3, 0.1, 3), at(0, 2, 0));
    expect(fallOf([body(box(0, 1, 0))], [floor, table])).toBeCloseTo(0.5, 6);
  });

  it('point on face, face on point, edge on edge', () => {
    const up = () => new ConeGeometry(1, 2, 24);
    const cone = soup(up(), at(0, 1, 0));
    // The cone's tip is at 2, under the middle of the box.
    expect(fallOf([body(box(0, 6, 0))], [floor, cone])).toBeCloseTo(3.5, 6);
    const onTip = soup(up(), new Matrix4().makeRotationX(Math.PI).setPosition(0, 6, 0));
    expect(fallOf([body(onTip)], [floor, box(0.2, 0.5, 0.2)])).toBeCloseTo(4, 6);
    // Two roofs across each other: their ridges meet at (0, 0).
    const ridge = (turn: number, y: number) =>
      soup(
        new BoxGeometry(4, 1, 1),
        new Matrix4()
          .makeRotationY(turn)
          .multiply(new Matrix4().makeRotationX(Math.PI / 4))
          .setPosition(0, y, 0),
      );
    expect(fallOf([body(ridge(Math.PI / 2, 5))], [ridge(0, 0)])).toBeCloseTo(5 - Math.SQRT2, 6);
  });

  it('as one with all else that falls', () => {
    expect(fallOf([body(box(0, 3, 0)), body(box(0, 5, 0))], [floor])).toBeCloseTo(2.5, 6);
  });

  it('sphere on sphere, as far as their triangles let them: no gap is left, and nothing overlaps', () => {
    const random = createRandom(3);
    for (let i = 0; i < 6; i++) {
      const [x, z] = [1.2 * (random() - 0.5), 1.2 * (random() - 0.5)];
      const lower = soup(new SphereGeometry(1, 40, 24), at(0, 1, 0));
      const upper = () => new SphereGeometry(0.5, 40, 24);
      const fall = fallOf([body(soup(upper(), at(x, 6, z)))], [lower]) as number;
      const exact = 6 - (1 + Math.sqrt(1.5 ** 2 - x * x - z * z));
      expect(Math.abs(fall - exact)).toBeLessThan(0.02);
      const again = fallOf([body(soup(upper(), at(x, 6 - fall, z)))], [lower]) as number;
      expect(Math.abs(again)).toBeLessThan(1e-6);
    }
  });

  it('nothing is nothing', () => {
    expect(fallOf([], [floor])).toBeNull();
  });
});
