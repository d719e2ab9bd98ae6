import { luminance } from '../../color/rec709.ts';
import type { Placement } from './instances.ts';
import {
  BLOCK_NUMBERS,
  BLOCK_SLOTS,
  BLOCK_TRIANGLES,
  LIGHT_SLOTS,
  LIGHT_TYPES,
  NO_TRAIL,
  NONE,
  WORDS_PER_SLOT,
} from './layout.ts';
import type { TreeLight } from './light-tree.ts';
import type { Emission } from './materials.ts';
import { blocksAt, type PackedMesh, verticesAt } from './mesh.ts';
import type { Pace } from './pace.ts';
import { luminanceSampler } from './textures.ts';
import { uvWord } from './vertices.ts';
import type { Words } from './words.ts';

type Point = [number, number, number];

/** Points that are looked at for the mean over a triangle: as many as it has texels, within these bounds. */
const LEAST_SAMPLES = 32;
const MOST_SAMPLES = 512;

/**
 * Writes a light for each triangle of an instance that shines; triangles without area are left dark. Adds those with
 * power to `tree`.
 *
 * @returns the number of the first one's light
 */
export async function writeTriangleLights(
  words: Words,
  first: number,
  mesh: PackedMesh,
  { toWorld, mirrors }: Placement,
  instance: number,
  emission: Emission,
  tree: TreeLight[],
  pace: Pace,
): Promise<void> {
  const firstSlot = words.allocate(mesh.triangles * LIGHT_SLOTS);
  const floats = new Float32Array(mesh.words.buffer);
  const m = toWorld.elements;
  const meanOf = emission.map === null ? null : meanSampler(mesh, floats, emission.map);
  const nits = luminance(emission.radiance);
  await pace.each(0, mesh.triangles, (from, to) => {
    for (let triangle = from; triangle < to; triangle += 1)
      words.setUints(firstSlot + triangle * LIGHT_SLOTS, LIGHT_TYPES.triangle, instance, triangle, NO_TRAIL);
  });
  await pace.each(0, mesh.blocks, (from, to) => {
    for (let block = from; block < to; block += 1) {
      const at = (blocksAt(mesh) + block * BLOCK_SLOTS) * WORDS_PER_SLOT;
      for (let lane = 0; lane < BLOCK_TRIANGLES; lane += 1) {
        const triangle = mesh.words[at + BLOCK_NUMBERS * WORDS_PER_SLOT + lane] as number;
        if (triangle === NONE) continue;
        const corners = [0, 1, 2].map((corner): Point => {
          const word = at + 3 * corner * WORDS_PER_SLOT + lane;
          const [x, y, z] = [
            floats[word]!,
            floats[word + WORDS_PER_SLOT]!,
            floats[word + 2 * WORDS_PER_SLOT]!,
          ];
          return [0, 1, 2].map((i) => m[i]! * x + m[i + 4]! * y + m[i + 8]! * z + m[i + 12]!) as Point;
        }) as [Point, Point, Point];
        const [a, b, c] = corners;
        const normal = crossOf(a, b, c);
        const doubled = Math.hypot(...normal);
        const area = Math.fround(doubled / 2);
        if (!(area > 0 && area < Number.POSITIVE_INFINITY)) continue;
        const slot = firstSlot + triangle * LIGHT_SLOTS;
        words.setFloats(slot + 1, ...emission.radiance, Number(emission.doubleSided));
        words.setFloats(slot + 2, ...a);
        words.setFloats(slot + 3, ...b, area);
        words.setFloats(slot + 4, ...c);
        const power = Math.PI * nits * area * (meanOf?.(triangle) ?? 1);
        if (!(power > 0)) continue;
        // The mirrored triangle runs the other way round.
        const sign = mirrors ? -1 : 1;
        tree.push({
          light: first + triangle,
          bounds: {
            box: [
              Math.min(a[0], b[0], c[0]),
              Math.min(a[1], b[1], c[1]),
              Math.min(a[2], b[2], c[2]),
              Math.max(a[0], b[0], c[0]),
              Math.max(a[1], b[1], c[1]),
              Math.max(a[2], b[2], c[2]),
            ],
            axis: normal.map((x) => (sign * x) / doubled) as Point,
            cosNormals: 1,
            cosEmission: 0,
            power,
            twoSided: emission.doubleSided,
          },
        });
      }
    }
  });
}

function crossOf(a: Point, b: Point, c: Point): Point {
  const [x1, y1, z1] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [x2, y2, z2] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  return [y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2];
}

/** The mean of a texture's luminance over a triangle. */
function meanSampler(
  mesh: PackedMesh,
  floats: Float32Array,
  map: NonNullable<Emission['map']>,
): (triangle: number) => number {
  const sample = luminanceSampler(map);
  const stride = mesh.vertexSlots * WORDS_PER_SLOT;
  const base = verticesAt(mesh) * WORDS_PER_SLOT;
  const { width, height } = map.texels;
  const { repeat, uv: set } = map.ref;
  const texels = width * height * Math.abs(repeat[0] * repeat[1]);
  const has = uvWord(set, 1) < stride;
  const uvOf = (vertex: number): [number, number] => {
    const at = base + vertex * stride;
    return has ? [floats[at + uvWord(set, 0)]!, floats[at + uvWord(set, 1)]!] : [0, 0];
  };
  return (triangle) => {
    const [a, b, c] = [0, 1, 2].map((i) => uvOf(mesh.words[mesh.indices + 3 * triangle + i] as number)) as [
      [number, number],
      [number, number],
      [number, number],
    ];
    const [u1, v1, u2, v2] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
    const covered = (texels * Math.abs(u1 * v2 - u2 * v1)) / 2;
    const samples = Math.ceil(Math.min(Math.max(covered, LEAST_SAMPLES), MOST_SAMPLES));
    let sum = 0;
    for (let i = 0; i < samples; i += 1) {
      // M. Roberts, 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", folded into the triangle.
      let s = (0.5 + i * 0.7548776662466927) % 1;
      let t = (0.5 + i * 0.5698402909980532) % 1;
      if (s + t > 1) [s, t] = [1 - s, 1 - t];
      sum += sample(a[0] + s * u1 + t * u2, a[1] + s * v1 + t * v2);
    }
    return sum / samples;
  };
}
