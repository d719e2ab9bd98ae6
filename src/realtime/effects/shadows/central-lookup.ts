/** Shadows of lights that shine from a place. */
import { Fn } from 'three/tsl';
import type { Node } from 'three/webgpu';
import {
  basis,
  discPoint,
  distanceAt,
  dot,
  FILTER,
  type Float,
  float,
  If,
  type Int,
  inFrame,
  int,
  isAbove,
  type Maps,
  mapAt,
  readRow,
  repeat,
  searchSamples,
  texelAt,
  type Vec2,
  type Vec3,
  type Vec4,
  vec2,
  vec3,
} from './lookup.ts';

type Read = (texel: number | Int) => Vec4;

/** The point that is shaded and the light's shape, in the light's frame. */
interface Situation {
  readonly read: Read;
  /** From the light. */
  readonly x: Vec3;
  readonly normal: Vec3;
  readonly distance: Float;
  /** Tangent that the +z map goes to. */
  readonly reach: Float;
}

/** What a lamp's maps have in a direction. @param jitter in texels */
type Look = (d: Vec3, jitter: Vec2) => Found;

/** What of a caster is at a texel: a place relative to the light, and how large a texel is there. */
interface Found {
  readonly place: Vec3;
  readonly texel: Float;
}

function situation(
  maps: Maps,
  row: Int,
  position: Vec3,
  normal: Vec3,
): Situation & { origin: Vec4; z: Vec4 } {
  const read = readRow(maps, row);
  const origin = read(0).toVar() as Vec4;
  const frame = [read(1).toVar(), read(2).toVar(), read(3).toVar()] as [Vec4, Vec4, Vec4];
  const x = inFrame(position.sub(origin.xyz) as Vec3, frame);
  return {
    read,
    origin,
    z: frame[2],
    x,
    normal: inFrame(normal, frame),
    distance: x.length().toVar() as Float,
    reach: frame[2].w as Float,
  };
}

/** What a map has in a direction. @param jitter in texels */
export function look(
  maps: Maps,
  { read, reach }: Pick<Situation, 'read' | 'reach'>,
  d: Vec3,
  jitter: Vec2,
): Found {
  const a = d.abs().toVar() as Vec3;
  // The face of the cube, as in FACES, and the two other components.
  const map = int(0).toVar();
  const major = d.z.toVar();
  const pair = vec2(d.x, d.y).toVar();
  const isFront = d.z.greaterThan(0).and(a.x.max(a.y).lessThanEqual(d.z.mul(reach)));
  If(isFront.not(), () => {
    If(a.z.greaterThanEqual(a.x.max(a.y)), () => {
      map.assign(d.z.lessThan(0).select(int(1), int(0)));
    }).Else(() => {
      If(a.x.greaterThanEqual(a.y), () => {
        map.assign(d.x.greaterThan(0).select(int(2), int(3)));
        major.assign(d.x);
        pair.assign(vec2(d.y, d.z));
      }).Else(() => {
        map.assign(d.y.greaterThan(0).select(int(4), int(5)));
        major.assign(d.y);
        pair.assign(vec2(d.z, d.x));
      });
    });
  });
  const { place, bounds } = mapAt(read, map as unknown as Int);
  const size = major.abs().max(1e-30).toVar();
  const at = vec2(
    pair.x.div(major.negate()).mul(place.x).add(place.y),
    pair.y.div(size).mul(place.z).add(place.w),
  ).toVar() as unknown as Vec2;
  const texel = texelAt(at, jitter, bounds);
  const found = distanceAt(maps, texel);
  // Back from the texel's middle.
  const side = major.lessThan(0).select(float(-1), float(1)).toVar();
  const u = texel.x.add(0.5).sub(place.y).div(place.x).mul(side).negate();
  const v = texel.y.add(0.5).sub(place.w).div(place.z);
  const other = vec2(u, v).toVar();
  const direction = vec3(other, side).toVar();
  If(map.greaterThan(3), () => {
    direction.assign(vec3(other.y, side, other.x));
  }).ElseIf(map.greaterThan(1), () => {
    direction.assign(vec3(side, other));
  });
  const along = found.div(direction.length()).toVar();
  const finest = place.x.min(place.z.negate()).max(1e-20);
  return {
    place: direction.mul(along).toVar() as unknown as Vec3,
    texel: along.div(finest).toVar() as unknown as Float,
  };
}

/** Of a lamp that has one map. */
function lookAhead(maps: Maps, { read }: Situation): Look {
  const { place, bounds } = mapAt(read, int(0) as unknown as Int);
  const perTexel = vec2(place.x.reciprocal().negate(), place.z.reciprocal()).toVar();
  const finest = place.x.min(place.z.negate()).max(1e-20).reciprocal().toVar();
  return (d, jitter) => {
    const at = vec2(d.x.div(d.z.negate()).mul(place.x).add(place.y), d.y.div(d.z).mul(place.z).add(place.w));
    // Behind it there is nothing.
    const ahead = d.z.greaterThan(1e-30).select(at, vec2(-1)).toVar() as unknown as Vec2;
    const texel = texelAt(ahead, jitter, bounds);
    const found = distanceAt(maps, texel);
    // Back from the texel's middle.
    const direction = vec3(texel.add(0.5).sub(place.yw).mul(perTexel), 1).toVar();
    const along = found.mul(dot(direction as unknown as Vec3, direction as unknown as Vec3).inverseSqrt());
    return {
      place: direction.mul(along.toVar()).toVar() as unknown as Vec3,
      texel: along.mul(finest).toVar() as unknown as Float,
    };
  };
}

/**
 * Where blockers are on the way from the light (0) to the point (1), in the mean; -1 without any.
 *
 * @param toLight a place of the light for a place of the unit disc or square
 * @param share where a place in space is on the way from the light to the point
 * @param within whether what is so far off the way, as a part of the light's own size there, is before the light
 */
function findBlocker(
  lookFor: Look,
  s: Situation,
  samples: Float,
  noise: Float,
  nearest: Float,
  place: (i: Float, n: Float) => Vec2,
  toLight: (place: Vec2) => Vec3,
  share: (place: Vec3) => Float,
  within: (off: Vec3, open: Float, slack: Float) => Node<'bool'>,
): Float {
  const n = searchSamples(samples).toVar() as Float;
  const sum = float(0).toVar();
  const count = float(0).toVar();
  repeat(n, (i) => {
    const u = i.mul(0.7548776662466927).add(noise).fract().toVar() as Float;
    // Denser towards the point: near it, what can keep light off is small.
    const open = u.mul(u).mul(nearest.oneMinus()).toVar() as Float;
    const p = toLight(place(i, n)).toVar() as Vec3;
    const d = p.mul(open).add(s.x.mul(open.oneMinus())).toVar() as Vec3;
    const jitter = discPoint(n.sub(i).sub(1) as Float, n, noise).mul(FILTER) as Vec2;
    const found = lookFor(d, jitter);
    const at = share(found.place).toVar() as Float;
    If(at.lessThan(1).and(at.greaterThan(0)), () => {
      const offset = found.place.sub(s.x).toVar() as Vec3;
      const off = found.place.sub(s.x.mul(at)) as Vec3;
      const slack = found.texel.mul(FILTER + 0.7) as Float;
      If(
        isAbove(offset, s.normal, s.distance, found.texel).and(within(off, at.oneMinus() as Float, slack)),
        () => {
          sum.addAssign(at);
          count.addAssign(1);
        },
      );
    });
  });
  return count.greaterThan(0).select(sum.div(count.max(1)), float(-1)) as unknown as Float;
}

const FLOATS = ['samples', 'noise'] as const;
const POINT = [
  { name: 'row', type: 'int' },
  { name: 'position', type: 'vec3' },
  { name: 'normal', type: 'vec3' },
] as const;

/** The part of a lamp's disc that a point sees. @param isSingle whether it has one map, and not the faces of a cube */
export function lampFunction(maps: Maps, isSingle: boolean) {
  return Fn(([row, position, normal, samples, noise]: [Int, Vec3, Vec3, Float, Float]) => {
    const s = situation(maps, row, position, normal);
    const lookFor: Look = isSingle ? lookAhead(maps, s) : (d, jitter) => look(maps, s, d, jitter);
    const radius = s.origin.w.toVar() as Float;
    const towards = s.x.div(s.distance).toVar() as Vec3;
    const [e1, e2] = basis(towards);
    const toLight = (q: Vec2) => e1.mul(q.x).add(e2.mul(q.y)).mul(radius) as Vec3;
    const share = (place: Vec3) => dot(place, towards).div(s.distance) as Float;
    const nearest = s.read(4).x.div(s.distance).min(1).toVar() as Float;
    const blocker = findBlocker(
      lookFor,
      s,
      samples,
      noise,
      nearest,
      (i, n) => discPoint(i, n, noise),
      toLight,
      share,
      (off, open, slack) => off.length().lessThan(open.mul(radius).add(slack)) as unknown as Node<'bool'>,
    ).toVar();
    const seen = float(1).toVar();
    // How far the lamp's middle is above the triangle's plane.
    const height = dot(s.normal, s.x).negate().toVar() as Float;
    If(blocker.greaterThan(0).or(height.lessThan(radius)), () => {
      const open = blocker.oneMinus().toVar() as unknown as Float;
      const count = float(0).toVar();
      repeat(samples, (i) => {
        const q = discPoint(i, samples, noise).toVar() as Vec2;
        const p = toLight(q).toVar() as Vec3;
        If(dot(s.normal, p).add(height).greaterThan(0), () => {
          const isSeen = float(1).toVar();
          If(blocker.greaterThan(0), () => {
            const d = p.mul(open).add(s.x.mul(blocker)).toVar() as Vec3;
            const found = lookFor(d, vec2(q.y, q.x.negate()).mul(FILTER) as unknown as Vec2);
            const isNearer = share(found.place).lessThan(1);
            const offset = found.place.sub(s.x).toVar() as Vec3;
            If(isNearer.and(isAbove(offset, s.normal, s.distance, found.texel)), () => {
              isSeen.assign(0);
            });
          });
          count.addAssign(isSeen);
        });
      });
      seen.assign(count.div(samples));
    });
    return seen;
  }).setLayout({
    name: isSingle ? 'spotSeen' : 'lampSeen',
    type: 'float',
    inputs: [...POINT, ...FLOATS.map((name) => ({ name, type: 'float' as const }))],
  });
}

/** Where what keeps a rectangle's light off a point is, 0..1 from the rectangle to the point; -1 without any. */
export function panelBlockerFunction(maps: Maps) {
  return Fn(([row, position, normal, samples, noise]: [Int, Vec3, Vec3, Float, Float]) => {
    const s = situation(maps, row, position, normal);
    const result = float(-1).toVar();
    If(s.x.z.greaterThan(0), () => {
      const half = vec2(s.read(1).w, s.read(2).w).toVar() as unknown as Vec2;
      const nearest = s.read(4).x.div(s.x.z).min(1).toVar() as Float;
      result.assign(
        findBlocker(
          (d, jitter) => look(maps, s, d, jitter),
          s,
          samples,
          noise,
          nearest,
          (i, n) => squarePoint(i, n, noise),
          (q) => vec3(q.mul(half), 0) as unknown as Vec3,
          (place) => place.z.div(s.x.z) as Float,
          (off, open, slack) => {
            const most = half.mul(open).add(slack);
            return off.x.abs().lessThan(most.x).and(off.y.abs().lessThan(most.y)) as unknown as Node<'bool'>;
          },
        ),
      );
    });
    return result;
  }).setLayout({
    name: 'panelBlocker',
    type: 'float',
    inputs: [...POINT, ...FLOATS.map((name) => ({ name, type: 'float' as const }))],
  });
}

/** Whether a point sees a place of a rectangle, 0 or 1. @param place -1..1 along both sides */
export function panelSeenFunction(maps: Maps) {
  return Fn(([row, position, normal, blocker, place, turn]: [Int, Vec3, Vec3, Float, Vec2, Float]) => {
    const s = situation(maps, row, position, normal);
    const half = vec2(s.read(1).w, s.read(2).w);
    const p = vec3(place.mul(half), 0).toVar() as unknown as Vec3;
    const result = float(0).toVar();
    If(dot(s.normal, p.sub(s.x)).greaterThan(0), () => {
      result.assign(1);
      If(blocker.greaterThan(0), () => {
        const d = p.mul(blocker.oneMinus()).add(s.x.mul(blocker)).toVar() as Vec3;
        const angle = turn.mul(2 * Math.PI);
        const jitter = vec2(angle.cos(), angle.sin()).mul(turn.mul(7).fract().sqrt().mul(FILTER));
        const found = look(maps, s, d, jitter as unknown as Vec2);
        const offset = found.place.sub(s.x).toVar() as Vec3;
        const isNearer = found.place.z.lessThan(s.x.z);
        If(isNearer.and(isAbove(offset, s.normal, s.distance, found.texel)), () => {
          result.assign(0);
        });
      });
    });
    return result;
  }).setLayout({
    name: 'panelSeen',
    type: 'float',
    inputs: [
      ...POINT,
      { name: 'blocker', type: 'float' },
      { name: 'place', type: 'vec2' },
      { name: 'turn', type: 'float' },
    ],
  });
}

/** The i-th of n points that fill the square -1..1 evenly, shifted: a Fibonacci lattice. */
function squarePoint(i: Float, n: Float, turn: Float): Vec2 {
  const u = i.add(0.5).div(n);
  const v = i.mul(0.6180339887498949).add(turn).fract();
  return vec2(u, v).mul(2).sub(1) as unknown as Vec2;
}
