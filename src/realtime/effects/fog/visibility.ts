/** Whether a place in the air sees a lamp: one look at its map, since there is no surface that could shade itself. */
import { If } from 'three/tsl';
import { repeat } from '../../../material/statements.ts';
import { look } from '../shadows/central-lookup.ts';
import {
  type Float,
  fetch,
  float,
  type Int,
  inFrame,
  int,
  type Maps,
  mapAt,
  readRow,
  type Vec2,
  type Vec3,
  type Vec4,
  vec2,
} from '../shadows/lookup.ts';

/** What is nearer than the place by less than this part of the way is what the place lies on. */
const SAME = 1e-3;

/** @param isFar whether the lamp is far away  @returns 1 or 0 */
export function seesLamp(maps: Maps, row: Int, isFar: Float, position: Vec3): Float {
  const seen = float(1).toVar();
  const read = readRow(maps, row);
  const frame = [read(1), read(2), read(3)] as [Vec4, Vec4, Vec4];
  If(isFar.greaterThan(0.5), () => {
    const [cascades, height] = [frame[0].w, frame[1].w] as [Float, Float];
    const x = inFrame(position, frame);
    const isFound = int(0).toVar();
    // The finest cascade that has the place.
    repeat(cascades, (i) => {
      If(isFound.equal(0), () => {
        const { place, bounds } = mapAt(read, i.toInt() as unknown as Int);
        const at = vec2(x.x.mul(place.x).add(place.y), x.y.mul(place.z).add(place.w)).toVar();
        const isIn = at
          .greaterThanEqual(bounds.xy as Vec2)
          .all()
          .and(at.lessThan(bounds.zw as Vec2).all());
        If(isIn, () => {
          isFound.assign(1);
          const top = height.sub(fetch(maps, at as unknown as Vec2, bounds));
          seen.assign(top.greaterThan(x.z).select(float(0), float(1)));
        });
      });
    });
  }).Else(() => {
    const x = inFrame(position.sub(read(0).xyz) as Vec3, frame);
    const found = look(maps, { read, reach: frame[2].w as Float }, x, vec2(0) as unknown as Vec2);
    const isBefore = found.place.length().lessThan(x.length().mul(1 - SAME));
    seen.assign(isBefore.select(float(0), float(1)));
  });
  return seen as unknown as Float;
}
