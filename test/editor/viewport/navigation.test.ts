/** Where a camera goes, and along which axes things are moved from it. */
import { PerspectiveCamera, Vector3 } from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import { type Pose, poseBetween } from '../../../src/editor/viewport/navigation/camera-path.ts';
import { directionOf, nearestAxis, viewAxes } from '../../../src/editor/viewport/navigation/view-axes.ts';

const random = createRandom(5);
const any = () => new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).multiplyScalar(8);
const pose = (position: Vector3, target = new Vector3()): Pose => ({ position, target });

describe('a camera on its way', () => {
  it('begins where it is and ends where it goes, at distances between both', () => {
    for (let i = 0; i < 100; i++) {
      const [from, to] = [pose(any(), any()), pose(any(), any())];
      expect(poseBetween(from, to, 0).position.distanceTo(from.position)).toBeLessThan(1e-9);
      expect(poseBetween(from, to, 1).position.distanceTo(to.position)).toBeLessThan(1e-9);
      const radius = ({ position, target }: Pose) => position.distanceTo(target);
      const middle = radius(poseBetween(from, to, 0.5));
      expect(middle).toBeCloseTo(Math.sqrt(radius(from) * radius(to)), 9);
    }
  });

  it('that is in what it looks at goes at once', () => {
    const to = pose(new Vector3(1, 2, 3));
    expect(poseBetween(pose(new Vector3()), to, 0.5)).toBe(to);
  });

  it('goes the shorter way round', () => {
    const from = pose(new Vector3(-0.1, 0, -5));
    const to = pose(new Vector3(0.1, 0, -5));
    expect(poseBetween(from, to, 0.5).position.z).toBeLessThan(-4.9);
  });

  it('goes over to the view from above without going through the target', () => {
    const [from, to] = [pose(new Vector3(3, 0, 4)), pose(new Vector3(0, 5, 0))];
    for (let part = 0; part <= 1; part += 0.1)
      expect(poseBetween(from, to, part).position.length()).toBeCloseTo(5, 9);
  });
});

describe('axes', () => {
  it('the nearest one is the one with the largest cosine', () => {
    for (let i = 0; i < 100; i++) {
      const v = any();
      const nearest = directionOf(nearestAxis(v));
      for (const axis of ['x', 'y', 'z'] as const)
        for (const sign of [1, -1] as const)
          expect(v.dot(nearest)).toBeGreaterThanOrEqual(v.dot(directionOf({ axis, sign })));
    }
  });

  it('as they lie in the picture are three different ones, wherever the camera is', () => {
    for (let i = 0; i < 200; i++) {
      const camera = new PerspectiveCamera();
      camera.position.copy(any());
      camera.lookAt(any());
      const { right, up, away } = viewAxes(camera);
      expect(new Set([right, up, away].map((v) => v.toArray().findIndex((x) => x !== 0))).size).toBe(3);
      expect(away.dot(camera.getWorldDirection(new Vector3()))).toBeGreaterThanOrEqual(-1e-12);
    }
  });

  it('from the front, from above', () => {
    const camera = new PerspectiveCamera();
    camera.position.set(0, 1, 5);
    camera.lookAt(0, 0, 0);
    expect(viewAxes(camera)).toMatchObject({ right: { x: 1 }, up: { y: 1 }, away: { z: -1 } });
    camera.position.set(0, 5, 0.5);
    camera.lookAt(0, 0, 0);
    expect(viewAxes(camera)).toMatchObject({ right: { x: 1 }, up: { z: -1 }, away: { y: -1 } });
  });
});
