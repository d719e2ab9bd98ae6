import { type BufferAttribute, BufferGeometry, Float32BufferAttribute } from 'three/webgpu';

/** Computes the tangents of a mesh from its texture coordinates, if they are missing and can be had. */
export function ensureTangents(geometry: BufferGeometry): void {
  const { index, attributes } = geometry;
  if (!attributes.position || !attributes.normal || !attributes.uv || attributes.tangent) return;
  if (index) geometry.computeTangents();
  else geometry.setAttribute('tangent', tangentsWithoutIndex(geometry));
}

/**
 * The tangents of a mesh whose triangles list their vertices. three.js wants an index; it is given one that
 * joins equal vertices, so that a surface which is smooth gets tangents which are.
 */
function tangentsWithoutIndex({ attributes }: BufferGeometry): BufferAttribute {
  const { position, normal, uv } = attributes as Record<'position' | 'normal' | 'uv', BufferAttribute>;
  const first = new Map<string, number>();
  const index = Array.from({ length: position.count - (position.count % 3) }, (_, i) => {
    const key = [position, normal, uv]
      .flatMap((attribute) =>
        Array.from({ length: attribute.itemSize }, (_, k) => attribute.getComponent(i, k)),
      )
      .join();
    const same = first.get(key) ?? i;
    first.set(key, same);
    return same;
  });
  const joined = new BufferGeometry();
  for (const [name, attribute] of Object.entries({ position, normal, uv }))
    joined.setAttribute(name, attribute);
  joined.setIndex(index);
  joined.computeTangents();
  const tangent = joined.getAttribute('tangent');
  const all = new Float32Array(4 * position.count);
  index.forEach((same, i) => {
    for (let k = 0; k < 4; k++) all[4 * i + k] = tangent.getComponent(same, k);
  });
  return new Float32BufferAttribute(all, 4);
}
