/** Which faces of a mesh cast shadows. */
import { BackSide, type BufferGeometry, DoubleSide, FrontSide, type Side } from 'three/webgpu';

interface SidedMaterial {
  readonly side: Side;
}

/**
 * The faces that a map is drawn of, for a camera at the light. A path tracer's rays run from the surface to the light, and
 * meet the front faces of what has one side: those that face away from the light. Of a closed body the faces
 * towards the light keep off the same light, and do so where the body stands on something, too; from outside they are all
 * that is seen of it.
 *
 * @param isOutside whether the light is outside the mesh
 */
export function castingSide(material: SidedMaterial, geometry: BufferGeometry, isOutside: boolean): Side {
  const volume = volumeOf(geometry);
  if (volume !== 0 && isOutside) return volume > 0 ? FrontSide : BackSide;
  if (material.side === DoubleSide || volume !== 0) return DoubleSide;
  return material.side === FrontSide ? BackSide : FrontSide;
}

const volumes = new WeakMap<BufferGeometry, { version: number; volume: number }>();

/** Of the integrals below, over the surface times its size. */
const TOLERANCE = 1e-4;

/**
 * The volume of a mesh that is the surface of a body, below 0 if its faces are turned inwards; of another 0. Of a body's
 * surface, and of hardly anything else, the integral of the normal is 0, and that of the outer product of place and normal is
 * the volume times the identity (both by the divergence theorem).
 */
export function volumeOf(geometry: BufferGeometry): number {
  const positions = geometry.getAttribute('position');
  const version = 'version' in positions ? positions.version : 0;
  const known = volumes.get(geometry);
  if (known?.version === version) return known.volume;
  const volume = integrate(geometry);
  volumes.set(geometry, { version, volume });
  return volume;
}

function integrate(geometry: BufferGeometry): number {
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
  if (area === 0) return 0;
  const volume = (moment[0]! + moment[4]! + moment[8]!) / 3;
  const off = moment.map((m, i) => Math.abs(m - (i % 4 === 0 ? volume : 0)));
  const isClosed =
    Math.max(...normal.map(Math.abs)) <= TOLERANCE * area && Math.max(...off) <= TOLERANCE * area * size;
  return isClosed ? volume : 0;
}
