/** Materials with which shadow maps are drawn are made once, however often maps of different kinds take turns. */
import { DoubleSide, FrontSide, MeshBasicMaterial, NodeMaterial } from 'three/webgpu';
import { expect, it, vi } from 'vitest';
import { CastingMaterials } from '../../../src/realtime/effects/shadows/casting-materials.ts';

const materials = () => {
  const make = vi.fn(() => new NodeMaterial());
  return { make, casting: new CastingMaterials<'parallel' | 'central'>(make) };
};

it('whole surfaces share one for each side and kind', () => {
  const { make, casting } = materials();
  const one = casting.of(new MeshBasicMaterial(), FrontSide, 'parallel');
  expect(casting.of(new MeshBasicMaterial(), FrontSide, 'parallel')).toBe(one);
  expect(casting.of(new MeshBasicMaterial(), DoubleSide, 'parallel')).not.toBe(one);
  expect(casting.of(new MeshBasicMaterial(), FrontSide, 'central')).not.toBe(one);
  expect(make).toHaveBeenCalledTimes(3);
});

it('a surface with holes has its own for each kind, which stay while kinds take turns', () => {
  const { make, casting } = materials();
  const leaf = new MeshBasicMaterial({ alphaTest: 0.5 });
  const sun = casting.of(leaf, FrontSide, 'parallel');
  const lamp = casting.of(leaf, FrontSide, 'central');
  expect(casting.of(leaf, FrontSide, 'parallel')).toBe(sun);
  expect(casting.of(leaf, FrontSide, 'central')).toBe(lamp);
  expect(make).toHaveBeenCalledTimes(2);
  leaf.alphaTest = 0.25;
  expect(casting.of(leaf, FrontSide, 'parallel').alphaTest).toBe(0.25);
});

it('is made anew, and the old one let go, when the surface has another shader', () => {
  const { casting } = materials();
  const leaf = new MeshBasicMaterial({ alphaTest: 0.5 });
  const old = casting.of(leaf, FrontSide, 'central');
  const gone = vi.fn();
  old.addEventListener('dispose', gone);
  leaf.needsUpdate = true;
  expect(casting.of(leaf, FrontSide, 'central')).not.toBe(old);
  expect(gone).toHaveBeenCalledOnce();
});
