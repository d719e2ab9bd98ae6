/** Which faces of a mesh cast shadows. */
import { BackSide, type BufferGeometry, DoubleSide, FrontSide, type Side } from 'three/webgpu';

interface SidedMaterial {
  readonly side: Side;
}

/**
 * The faces that a map is drawn of, for a camera at the light. A path tracer's rays run from the surface to the light, and
 * meet the front faces of what has one side: those that face away from the light. Of a closed body the faces
 * towards the light keep off the same light, and do so where the body stands on something, too.
 */
export function castingSide(material: SidedMaterial, geometry: BufferGeometry): Side {
  if (material.side === DoubleSide || isClosed(geometry)) return DoubleSide;
  return material.side === FrontSide ? BackSide : FrontSide;
}

const closed = new WeakMap<BufferGeometry, { version: number; closed: boolean }>();

/** Of the integrals below, over the surface times its size. */
const TOLERANCE = 1e-4;

/**
 * Whether a mesh is the surface of a body. Of such, and of hardly anything else, the integral of the normal is 0, and that of
 * the outer product of place and normal is the volume times the identity (both by the divergence theorem).
 */
export function isClosed(geometry: BufferGeometry): boolean {
  const positions = geometry.getAttribute('position');
  const version = 'version' in positions ? positions.version : 0;
  const known = closed.get(geometry);
  if (known?.version === version) return known.closed;
  const result = integrate(geometry);
  closed.set(geometry, { version, closed: result });
  return result;
}

function integrate(geometry: BufferGeometry): boolean {
  const positions = geometry.getAttribute('position');
  const { index } = geometry;
  const count = index ? index.count : positions.count;
  const normal = [0, 0, 0];
  const moment = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  let area = 0;
  let size = 0;
  const p = new Float64Array(9);
  for (let i = 0; i + 2 < count; i += 3) {
    for (let k = 0; k < 3; k++) {
      const vertex = index ? index.getX(i + k) : i + k;
      p[3 * k] = positions.getX(vertex);
      p[3 * k + 1] = positions.getY(vertex);
      p[3 * k + 2] = positions.getZ(vertex);
    }
    const [ax, ay, az] = [p[3]! - p[0]!, p[4]! - p[1]!, p[5]! - p[2]!];
    const [bx, by, bz] = [p[6]! - p[0]!, p[7]! - p[1]!, p[8]! - p[2]!];
    const n = [(ay * bz - az * by) / 2, (az * bx - ax * bz) / 2, (ax * by - ay * bx) / 2];
    area += Math.hypot(n[0]!, n[1]!, n[2]!);
    for (let k = 0; k < 3; k++) {
      const centre = (p[k]! + p[3 + k]! + p[6 + k]!) / 3;
      size = Math.max(size, Math.abs(centre));
      normal[k]! += n[k]!;
      for (let j = 0; j < 3; j++) moment[3 * k + j]! += centre * n[j]!;
    }
  }
  if (area === 0) return false;
  const volume = (moment[0]! + moment[4]! + moment[8]!) / 3;
  const off = moment.map((m, i) => Math.abs(m - (i % 4 === 0 ? volume : 0)));
  return (
    Math.max(...normal.map(Math.abs)) <= TOLERANCE * area &&
    Math.max(...off) <= TOLERANCE * area * size &&
    volume !== 0
  );
}
