/**
 * How much of its surroundings a surface has open, from what the picture shows. Ground-truth ambient occlusion (J.
 * Jimenez, X. Wu, A. Pesce and A. Jarabo, 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion", SIGGRAPH
 * course): the hemisphere in slices through the view ray. What each slice has open is kept in bits, so that light passes
 * behind things of a thickness (O. Therrien, Y. Levesque and G. Gilet, 2023, "Screen Space Indirect Lighting with
 * Visibility Bitmask", The Visual Computer). One more slice, through the direction that a mirror shows, says what highlights
 * would see (docs/decisions/screen-space-light.md).
 */
import { atan, float, If, select, uint, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, UniformNode } from 'three/webgpu';
import { repeat } from '../../../material/statements.ts';
import { type Guide, inline, NOTHING } from './guide.ts';
import { gradientNoise, latticeNoise } from './noise.ts';
import { toOctahedron } from './octahedron.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;
type Uint = Node<'uint'>;

/** Of a slice: one for each bit. */
const SECTORS = 32;
const SECTOR = Math.PI / SECTORS;
/** The last part of the radius, over which what is found counts less and less. */
const FADE = 0.25;
/**
 * How far above its surface a point is taken to be, as a part of its distance: normals are half floats, so a plane's own points
 * may seem 5e-4 of their distance from each other above it.
 */
const LIFT = 1e-3;
/** Of the normal in a slice: where it is shorter, the slice hardly counts. */
const LEAST_LENGTH = 0.05;
type Numbers = Readonly<
  Record<'radius' | 'thickness' | 'directions' | 'steps', UniformNode<'float', number>>
>;

export type Write = (wide: Node, sharp: Node) => void;

/** Visibility, the mean open direction; and what is closed in the mirror's plane, as `OpenSky.mirrored` has it; distance. */
export function visibility(guide: Guide, numbers: Numbers, write: Write): Vec4 {
  const { radius, thickness, directions, steps } = numbers;
  return inline(() => {
    const place = uv() as Vec2;
    const own = guide.sample(place).toVar() as Vec4;
    const result = vec4(1, 0, 0, own.w).toVar() as Vec4;
    const mirrored = vec4(0, 0, 0, own.w).toVar() as Vec4;
    If(own.w.lessThan(NOTHING), () => {
      const centre = guide.texel(place).toVar() as Vec2;
      const N = own.xyz.normalize().toVar() as Vec3;
      const P = guide
        .position(centre, own.w as Float)
        .add(N.mul(own.w.mul(LIFT)))
        .toVar() as Vec3;
      const V = P.normalize().negate().toVar() as Vec3;
      const pixel = centre.mul(guide.size).floor().toVar() as Vec2;
      const turn = gradientNoise(pixel).toVar() as Float;
      const shift = latticeNoise(pixel).toVar() as Float;
      const scale = guide
        .perMetre(own.w as Float)
        .mul(radius)
        .toVar() as Vec2;
      /** The slice through the view ray and a direction on the screen. */
      const slice = (across: Vec3) => {
        // Where the radius ends on the screen, in parts of it.
        const reach = scale.mul(across.xy).toVar() as Vec2;
        const axis = across.cross(V).normalize().toVar() as unknown as Vec3;
        const O = V.cross(axis).toVar() as unknown as Vec3;
        const projected = N.sub(axis.mul(N.dot(axis))).toVar() as Vec3;
        const length = projected.length().max(1e-6).toVar() as Float;
        // From the view ray to the normal, in the slice.
        const n = projected
          .dot(V)
          .div(length)
          .clamp(-1, 1)
          .acos()
          .mul(select(projected.dot(O).lessThan(0), float(-1), float(1)))
          .toVar() as Float;
        const T = O.mul(n.cos()).sub(V.mul(n.sin())).toVar() as Vec3;
        const closed = uint(0).toVar() as Uint;
        /** Sets the bits of what is in the way on one side. */
        const look = (side: 1 | -1, count: Float) => {
          const way = reach.mul(side).toVar() as Vec2;
          /**
           * The angle from the normal to a point, in the slice; what is below the horizon is at it. A texel's centre is beside the
           * slice: by its height over the surface's plane it is where it would be in it, so a plane has nothing above itself.
           */
          const fromNormal = (d: Vec3): Float => {
            const height = d.dot(N).div(length.max(LEAST_LENGTH)).toVar() as Float;
            const angle = atan(d.dot(T), height.max(1e-9)) as unknown as Float;
            return select(height.greaterThan(0), angle, float((side * Math.PI) / 2)) as unknown as Float;
          };
          const room = select(
            way.greaterThan(vec2(0)) as never,
            centre.oneMinus(),
            centre,
          ) as unknown as Vec2;
          const exits = room.div(way.abs().max(1e-9)) as Vec2;
          const end = way.mul(exits.x.min(exits.y).min(1)).toVar() as Vec2;
          const pixels = end.mul(guide.size).length().toVar() as Float;
          repeat(count, (j) => {
            const t = j.add(shift).div(count) as Float;
            // At least one pixel further each time.
            const part = t
              .mul(t)
              .max(j.add(1).div(pixels.max(1e-3)))
              .toVar() as Float;
            If(part.lessThanEqual(1), () => {
              const at = centre.add(end.mul(part)).toVar() as Vec2;
              const S = guide.position(at, guide.sample(at).w as Float).toVar() as Vec3;
              const front = S.sub(P).toVar() as Vec3;
              const distance = front.length().max(1e-9).toVar() as Float;
              const strength = radius.sub(distance).div(radius.mul(FADE)).clamp(0, 1).toVar() as Float;
              If(strength.greaterThan(0), () => {
                const back = front.add(S.normalize().mul(thickness)).toVar() as Vec3;
                const sectorOf = (beta: Float) =>
                  beta.div(Math.PI).add(0.5).mul(SECTORS).add(shift).floor().min(SECTORS) as Float;
                const first = fromNormal(front).toVar() as Float;
                const last = fromNormal(back) as Float;
                const a = sectorOf(first).toVar() as Float;
                const b = sectorOf(first.add(last.sub(first).mul(strength)) as Float).toVar() as Float;
                const low = a
                  .min(b)
                  .min(SECTORS - 1)
                  .toUint() as Uint;
                const count = a.sub(b).abs().toVar() as Float;
                // A shift by all 32 bits is not defined.
                const run = select(
                  count.greaterThanEqual(SECTORS),
                  uint(0xffffffff),
                  uint(1)
                    .shiftLeft(count.min(SECTORS - 1).toUint())
                    .sub(uint(1)),
                ) as unknown as Uint;
                closed.assign(closed.bitOr(run.shiftLeft(low)) as Uint);
              });
            });
          });
        };
        return { O, length, n, closed, look };
      };
      const [all, open, bent] = [float(0).toVar(), float(0).toVar(), vec3(0).toVar()];
      repeat(directions as unknown as Float, (i) => {
        const phi = i.add(turn).div(directions).mul(Math.PI).toVar();
        const { O, length, n, closed, look } = slice(vec3(phi.cos(), phi.sin(), 0).toVar() as Vec3);
        for (const side of [1, -1] as const) look(side, steps as unknown as Float);
        // Cosine and sine of the sector's middle, from the normal and from the view ray: turned by a sector each time.
        const first = 0.5 * SECTOR - Math.PI / 2;
        const fromN = vec2(Math.cos(first), Math.sin(first)).toVar() as Vec2;
        const theta = n.add(first).toVar() as Float;
        const fromV = vec2(theta.cos(), theta.sin()).toVar() as Vec2;
        repeat(SECTORS, (k) => {
          const weight = length.mul(fromN.x).mul(fromV.y.abs()).toVar() as Float;
          all.addAssign(weight);
          If(isOpen(closed, k), () => {
            open.addAssign(weight);
            bent.addAssign(V.mul(fromV.x).add(O.mul(fromV.y)).mul(weight));
          });
          for (const angle of [fromN, fromV]) angle.assign(turned(angle));
        });
      });
      const direction = select(open.greaterThan(all.mul(1e-3)), bent, N) as unknown as Vec3;
      result.assign(vec4(open.div(all.max(1e-9)), toOctahedron(direction), own.w));

      // Where the plane of view and normal meets the screen's; of a surface that faces the view, anywhere.
      const flat = N.xy.sub(V.xy.mul(N.z.div(V.z))).toVar() as Vec2;
      const facing = flat.length().lessThan(1e-4);
      const { n, closed, look } = slice(
        vec3(select(facing, vec2(1, 0), flat.normalize()) as unknown as Vec2, 0).toVar() as Vec3,
      );
      // A mirror shows nothing of the viewer's side.
      look(1, steps.mul(2) as unknown as Float);
      repeat(SECTORS, (k) => {
        If(isOpen(closed, k).not(), () => {
          const angle = sector(k).sub(n).toVar();
          mirrored.xyz.addAssign(vec3(1, angle, angle.mul(angle)).div(SECTORS));
        });
      });
    });
    write(result, mirrored);
    return result;
  });
}

/** Cosine and sine of an angle that is a sector larger. */
function turned(angle: Vec2): Vec2 {
  const [c, s] = [Math.cos(SECTOR), Math.sin(SECTOR)];
  return vec2(angle.x.mul(c).sub(angle.y.mul(s)), angle.x.mul(s).add(angle.y.mul(c))) as unknown as Vec2;
}

/** The middle of a slice's sector, from the normal. */
const sector = (k: Float): Float => k.add(0.5).div(SECTORS).sub(0.5).mul(Math.PI) as Float;
const isOpen = (closed: Uint, k: Float) => closed.shiftRight(k.toUint()).bitAnd(uint(1)).equal(uint(0));
