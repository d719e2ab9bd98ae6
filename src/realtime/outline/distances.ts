/**
 * How far each pixel is from what a mask says is covered, as far as an outline reaches. The nearest of each row is looked
 * for first and then the nearest of those, so that a pixel takes two lines of looks and not a disc of them: T. Saito and
 * J. Toriwaki, 1994, "New algorithms for Euclidean distance transformation of an n-dimensional digitized picture", Pattern
 * Recognition 27. A pixel that is covered in part has the edge at half a pixel less that share from its middle: S. Gustavson
 * and R. Strand, 2011, "Anti-aliased Euclidean distance transform", Pattern Recognition Letters 32.
 */
import { Fn, If, Loop, vec2, vec4 } from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { pixelOf } from '../frame/pass.ts';

type Int = Node<'int'>;
type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec4 = Node<'vec4'>;

/** What is further than that is not looked for, in pixels; a byte holds it. */
export const MOST_REACH = 254;

interface Map {
  readonly source: TextureNode<'vec4'>;
  /** In pixels. */
  readonly size: Vec2;
  /** Pixels to either side that are looked at. */
  readonly reach: Int;
}

/** Runs for i = -reach ... reach. */
function eachWay(reach: Int, body: (i: Float) => void): void {
  const range = { start: reach.negate(), end: reach, condition: '<=', type: 'int' };
  Loop(range as unknown as number, ({ i }: { i: Node }) => body((i as Int).toFloat() as Float));
}

/**
 * Of the nearest pixel of the row that the mask's red covers at all: how far it is, a 255th for each pixel, and its share; then
 * the same of green. Far away, as if there were one 255 pixels away, where there is none.
 */
export function nearestInRow(mask: Map, pixel: Vec2): Vec4 {
  return Fn(() => {
    const nearest = vec2(MOST_REACH + 1).toVar();
    const found = vec4(1, 1, 1, 1).toVar();
    eachWay(mask.reach, (i) => {
      const share = pixelOf(mask.source, pixel.add(vec2(i, 0)) as Vec2, mask.size).toVar() as Vec4;
      const away = i.abs().toVar() as Float;
      const take = (own: Float, least: Float, into: Vec2) =>
        If(own.greaterThan(0).and(away.add(0.5).sub(own).lessThan(least)), () => {
          least.assign(away.add(0.5).sub(own));
          into.assign(vec2(away.div(255), own));
        });
      take(share.r as Float, nearest.x as Float, found.xy as Vec2);
      take(share.g as Float, nearest.y as Float, found.zw as Vec2);
    });
    return found;
  })() as unknown as Vec4;
}

export interface Distances {
  /** From the edge of what red covers, and of what green does, in pixels; 0 and less within. */
  readonly away: Vec2;
  /** The share of the pixel itself that each covers. */
  readonly share: Vec2;
}

/** To be called where statements can be. @param rows as nearestInRow() has them */
export function distancesFrom(rows: Map, pixel: Vec2): Distances {
  const away = vec2(MOST_REACH + 1).toVar() as Vec2;
  const here = pixelOf(rows.source, pixel, rows.size).toVar() as Vec4;
  eachWay(rows.reach, (i) => {
    const row = pixelOf(rows.source, pixel.add(vec2(0, i)) as Vec2, rows.size).toVar() as Vec4;
    const across = row.xz.mul(255).toVar() as Vec2;
    away.assign(away.min(across.mul(across).add(i.mul(i)).sqrt().add(0.5).sub(row.yw)) as Vec2);
  });
  // Of the pixel itself, if it is the nearest.
  const share = here.yw.mul(here.xz.mul(255).min(1).oneMinus()) as Vec2;
  return { away, share };
}
