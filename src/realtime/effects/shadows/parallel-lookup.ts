/** Shadows of lights that are far away. */
import { Fn } from 'three/tsl';
import {
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
  vec4,
} from './lookup.ts';

/** The part of a cascade's width, along its edge, over which it goes over into the next. */
const BLEND = 0.1;

/** The finest cascade that has all that can shade the point; near its edge the next one in more and more pixels. */
function findCascade(
  read: ReturnType<typeof readRow>,
  cascades: Float,
  x: Vec3,
  noise: Float,
  onFound: (map: ReturnType<typeof mapAt>, number: Float) => void,
): void {
  const isFound = int(0).toVar();
  const highest = read(3).w as Float;
  const reach = highest.sub(x.z).max(0).mul(read(0).w).toVar();
  repeat(cascades, (i) => {
    If(isFound.equal(0), () => {
      const map = mapAt(read, i.toInt() as unknown as Int);
      const at = vec2(x.x.mul(map.place.x).add(map.place.y), x.y.mul(map.place.z).add(map.place.w));
      const size = map.bounds.zw.sub(map.bounds.xy).max(1);
      const beside = reach.mul(map.place.x.max(map.place.z.negate())).add(FILTER + 1);
      const inner = at.sub(map.bounds.xy).min(map.bounds.zw.sub(at)).sub(beside).div(size.mul(BLEND)).toVar();
      const depth = inner.x.min(inner.y);
      const isLast = i.add(1).greaterThanEqual(cascades);
      If(depth.greaterThan(noise).or(isLast), () => {
        onFound(map, i);
        isFound.assign(1);
      });
    });
  });
}

/** Which cascade a point's shadow is looked up in: 0 is the finest. */
export function cascadeFunction(maps: Maps) {
  return Fn(([row, position, noise]: [Int, Vec3, Float]) => {
    const read = readRow(maps, row);
    const frame = [read(1).toVar(), read(2).toVar(), read(3).toVar()] as [Vec4, Vec4, Vec4];
    const found = float(0).toVar();
    findCascade(read, frame[0].w as Float, inFrame(position, frame), noise, (_, number) => {
      found.assign(number);
    });
    return found;
  }).setLayout({
    name: 'sunCascade',
    type: 'float',
    inputs: [
      { name: 'row', type: 'int' },
      { name: 'position', type: 'vec3' },
      { name: 'noise', type: 'float' },
    ],
  });
}

/** The part of the sun's disc that a point sees. */
export function sunFunction(maps: Maps) {
  return Fn(([row, position, normal, samples, noise]: [Int, Vec3, Vec3, Float, Float]) => {
    const read = readRow(maps, row);
    const frame = [read(1).toVar(), read(2).toVar(), read(3).toVar()] as [Vec4, Vec4, Vec4];
    const [cascades, height, highest] = [frame[0].w, frame[1].w, frame[2].w] as [Float, Float, Float];
    const tangent = read(0).w.toVar() as Float;
    const x = inFrame(position, frame);
    const n = inFrame(normal, frame);
    const seen = float(1).toVar();

    const place = vec4(0).toVar() as unknown as Vec4;
    const bounds = vec4(0).toVar() as unknown as Vec4;
    findCascade(read, cascades, x, noise, (map) => {
      (place as unknown as { assign(v: Vec4): void }).assign(map.place);
      (bounds as unknown as { assign(v: Vec4): void }).assign(map.bounds);
    });
    const texel = float(1).div(place.x.min(place.z.negate()).max(1e-20)).toVar() as unknown as Float;

    /** What is at a place of the map. @param jitter in texels */
    const look = (q: Vec2, jitter: Vec2): Vec3 => {
      const at = vec2(q.x.mul(place.x).add(place.y), q.y.mul(place.z).add(place.w)).toVar();
      const found = texelAt(at as unknown as Vec2, jitter, bounds);
      const distance = distanceAt(maps, found);
      const middle = found.add(0.5);
      return vec3(
        middle.x.sub(place.y).div(place.x),
        middle.y.sub(place.w).div(place.z),
        height.sub(distance),
      ).toVar() as unknown as Vec3;
    };
    const isBlocking = (found: Vec3) => {
      const offset = found.sub(x).toVar() as Vec3;
      return offset.z.greaterThan(0).and(isAbove(offset, n, height.sub(x.z).abs() as Float, texel));
    };

    const most = highest.sub(x.z).toVar() as Float;
    const sum = float(0).toVar();
    const blockers = float(0).toVar();
    const total = searchSamples(samples).toVar() as Float;
    If(most.greaterThan(0).and(cascades.greaterThan(0)), () => {
      repeat(total, (i) => {
        const u = i.mul(0.7548776662466927).add(noise).fract().toVar() as Float;
        const q = discPoint(i, total, noise).mul(u.mul(u).mul(most).mul(tangent)) as Vec2;
        const jitter = discPoint(total.sub(i).sub(1) as Float, total, noise).mul(FILTER) as Vec2;
        const found = look(x.xy.add(q) as Vec2, jitter);
        const above = found.z.sub(x.z);
        const isBefore = found.xy
          .sub(x.xy)
          .length()
          .lessThan(above.mul(tangent).add(texel.mul(FILTER + 0.7)));
        If(isBlocking(found).and(isBefore), () => {
          sum.addAssign(above);
          blockers.addAssign(1);
        });
      });
    });
    // How far the middle of the sun is above the triangle's plane, against how far it reaches.
    const edge = n.xy.length().mul(tangent);
    If(blockers.greaterThan(0).or(n.z.lessThan(edge)), () => {
      const above = sum.div(blockers.max(1)).toVar();
      const count = float(0).toVar();
      repeat(samples, (i) => {
        const q = discPoint(i, samples, noise).toVar() as Vec2;
        const d = q.mul(tangent).toVar() as Vec2;
        If(
          dot(n.xy as Vec2, d)
            .add(n.z)
            .greaterThan(0),
          () => {
            const isSeen = float(1).toVar();
            If(blockers.greaterThan(0), () => {
              const jitter = vec2(q.y, q.x.negate()).mul(FILTER) as unknown as Vec2;
              If(isBlocking(look(x.xy.add(d.mul(above)) as Vec2, jitter)), () => {
                isSeen.assign(0);
              });
            });
            count.addAssign(isSeen);
          },
        );
      });
      seen.assign(count.div(samples));
    });
    return seen;
  }).setLayout({
    name: 'sunSeen',
    type: 'float',
    inputs: [
      { name: 'row', type: 'int' },
      { name: 'position', type: 'vec3' },
      { name: 'normal', type: 'vec3' },
      { name: 'samples', type: 'float' },
      { name: 'noise', type: 'float' },
    ],
  });
}
