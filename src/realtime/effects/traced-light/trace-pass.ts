/** Every opaque surface once more, its material as tracer of rays instead of shaded. */
import {
  context,
  dot,
  float,
  If,
  mix,
  mrt,
  normalViewGeometry,
  positionView,
  property,
  screenUV,
  smoothstep,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Node, PerspectiveCamera, RenderTarget, Scene, WebGPURenderer } from 'three/webgpu';
import type { RayTracer, TracedRay } from '../../../material/frame-context.ts';
import type { Assignable } from '../../../material/statements.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { type Guide, texelAt } from '../screen-space/guide.ts';
import { gradientNoise, latticeNoise } from '../screen-space/noise.ts';
import { type March, march } from './march.ts';
import { type Pair, pairOf, pairTarget } from './pair-pass.ts';
import type { RadianceHistory } from './radiance-history.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** The part of the frame at its borders over which what is found gives way to far light. */
const BORDER = 0.05;
/**
 * Densities in 1/sr between which lobes become mirrors, which show edges: rays that pass behind a thing must miss it. In wider
 * ones the light that they find behind it, unseen, would be missed more.
 */
const MIRROR = [3, 30] as const;
/** The coarsest level of the last frame that is read. */
const COARSEST = 5;

export interface TraceSettings extends March {
  readonly rays: Float;
  readonly reflections: boolean;
  readonly indirectLight: boolean;
  /** Its number, by which noise is moved; always the same where no frames are gathered. */
  readonly frame: Float;
  /** 1 where there is a last frame, else 0. */
  readonly hasHistory: Float;
}

export class TracePass {
  readonly #target: RenderTarget = pairTarget('traced', true);
  readonly #context: ReturnType<typeof context>;
  readonly #outputs: ReturnType<typeof mrt>;

  constructor(inputs: FrameInputs, guide: Guide, history: RadianceHistory, settings: TraceSettings) {
    const [wide, sharp] = [property('vec4', 'tracedWide'), property('vec4', 'tracedSharp')] as unknown as [
      Vec4 & Assignable,
      Vec4 & Assignable,
    ];
    const { rays, reflections, indirectLight, frame, hasHistory } = settings;
    const pixel = (screenUV as unknown as Vec2).mul(guide.size).floor() as Vec2;
    const ownDistance = (positionView as Vec3).z.negate() as Float;
    const rayTracer: RayTracer = {
      rays,
      reflections,
      indirectLight,
      // Along the first axis the set is evenly spaced: it is shifted by less than its spacing.
      shift: () =>
        vec2(
          gradientNoise(pixel).add(frame.mul(0.6180339887)).fract().div(rays),
          latticeNoise(pixel).add(frame.mul(0.7548776662)).fract(),
        ) as unknown as Vec2,
      trace: (L, density, part): TracedRay => {
        const P = (positionView as Vec3).toVar() as Vec3;
        const N = (normalViewGeometry as unknown as Vec3).toVar() as Vec3;
        // Another for each ray, too, so that no two frames miss the same.
        const jitter = latticeNoise(pixel)

          .add(frame.mul(0.569840291))
          .add(dot(L, vec3(17.3, 31.7, 23.1)))
          .fract()
          .toVar() as unknown as Float;
        const strict = smoothstep(...MIRROR, density) as unknown as Float;
        const hit = march(inputs, guide, settings, P, N, L, jitter, strict).toVar() as Vec4;
        const radiance = vec3(0).toVar() as Vec3 & Assignable;
        const share = float(0).toVar() as Float & Assignable;
        // Half the angle of a cone as large as the lobe about the ray: 1/density = pi tan^2, about.
        const cone = density.mul(Math.PI).inverseSqrt().toVar() as Float;
        const unit = guide.perMetre(ownDistance).x.mul(guide.size.x).toVar() as unknown as Float;
        const length = mix(ownDistance, hit.z, hit.w) as unknown as Float;
        // In the mirror image the found is as far behind the surface as it is before it.
        const spread = cone
          .mul(length)
          .mul(ownDistance)
          .div(ownDistance.add(length))
          .mul(unit)
          .toVar() as Float;
        If(hit.w.mul(hasHistory).greaterThan(0), () => {
          const place = hit.xy.toVar() as Vec2;
          const surface = guide.sample(place).toVar() as Vec4;
          const motion = texelAt(inputs.velocity.value, place).xy.mul(vec2(0.5, -0.5));
          const before = place.sub(motion).toVar() as Vec2;
          // As coarse as the ray's own part of the hemisphere is there.
          const footprint = cone
            .mul(rays.inverseSqrt())
            .mul(hit.z)
            .mul(guide.perMetre(surface.w as Float).x)
            .mul(inputs.size.x);
          const level = footprint.max(1).log2().min(COARSEST).mul(part.oneMinus().max(0.5)) as Float;
          const found = history.sample(before, level).toVar() as Vec4;
          radiance.assign(found.rgb);
          const edge = (at: Vec2): Float => {
            const inside = at.min(at.oneMinus()).div(BORDER).clamp(0, 1) as Vec2;
            return inside.x.mul(inside.y) as Float;
          };
          // What a mirror would show of a thing's back is not known; of what is matte it is as the front.
          const front = smoothstep(-0.1, 0.1, dot(surface.xyz, L).negate()) as unknown as Float;
          share.assign(
            edge(place)
              .min(edge(before))
              .mul(mix(float(1), front, part))
              .mul(found.a.greaterThan(0.01).select(1, 0)),
          );
        });
        return { radiance, share, spread };
      },
      write: (found, reflected, spread) => {
        wide.assign(vec4(found, ownDistance));
        sharp.assign(vec4(reflected, spread.min(1e3)));
      },
    };
    this.#context = context({ rayTracer });
    this.#outputs = mrt({ 'traced wide': wide, 'traced sharp': sharp });
  }

  render(
    three: WebGPURenderer,
    scene: Scene,
    camera: PerspectiveCamera,
    width: number,
    height: number,
  ): Pair {
    this.#target.setSize(width, height);
    const { contextNode, transparent } = three;
    const { background } = scene;
    const shadows = three.shadowMap.enabled;
    scene.background = null;
    three.transparent = false;
    three.shadowMap.enabled = false;
    three.contextNode = this.#context as typeof contextNode;
    three.setMRT(this.#outputs);
    three.setRenderTarget(this.#target);
    three.render(scene, camera);
    three.setRenderTarget(null);
    three.setMRT(null);
    three.contextNode = contextNode;
    three.transparent = transparent;
    three.shadowMap.enabled = shadows;
    scene.background = background;
    return pairOf(this.#target);
  }

  dispose(): void {
    this.#target.dispose();
  }
}
