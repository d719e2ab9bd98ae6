import { cross, dot, float, If, positionView, vec2, vec3 } from 'three/tsl';
import { type AnalyticLightNode, type Light, LightingModel, type Node, type NodeBuilder } from 'three/webgpu';
import type { Model } from '../glsl/model.ts';
import { glslFunction, modelFunctionByLight, type ParameterNodes, type SplitCall } from '../glsl/tsl.ts';
import { airTo, airToLamp, hasAir } from './air.ts';
import type { EnvironmentLightNode } from './environment-light.ts';
import { fragmentData, wantsFragmentData } from './fragment-data.ts';
import { frameContext } from './frame-context.ts';
import { isOneLamp, lampLight } from './lamp-light.ts';
import { lightFromEverywhere } from './light-from-everywhere.ts';
import { fragmentPoint, type LightShadows, lightShadows, type ShadedPoint } from './light-shadows.ts';
import { nonNegative } from './non-negative.ts';
import { createSampler, latticePoint, type Sampler } from './sampler.ts';
import { type ShadingFrame, shadingFrame } from './shading-frame.ts';
import { type Assignable, keptFloat, repeat, run } from './statements.ts';
import { traceRays } from './traced-rays.ts';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** Samples on a rectangle, and directions drawn from the model. */
const RECTANGLE_POINTS = 26;
const RECTANGLE_DIRECTIONS = 48;
/** By how much less than their density directions weigh: the rectangle's edge cuts through them, not through the points. */
const DIRECTIONS_TRUST = 0.5;
/** Half the side of the least square that a direction stands for, in parts of the rectangle: below it float32 has no digits. */
const LEAST_SQUARE = 1e-3;

export interface LightingOptions {
  readonly model: Model;
  readonly term: string;
  readonly parameters: ParameterNodes;
  /** What is derived from the parameters alone; null where a parameter varies over the surface. */
  readonly derived: readonly Node[] | null;
  /** null where nothing lights but lamps. */
  readonly environment: EnvironmentLightNode | null;
  /** Whether the material's albedo table holds: it does not where a parameter varies over the surface. */
  readonly hasTable: boolean;
}

/**
 * The shading equation L_o(v) = sum over lights of f(l, v) E_l (n.l) for any model, with E_l the light's
 * irradiance on a surface that faces it.
 */
export class BrdfLightingModel extends LightingModel {
  private readonly options: LightingOptions;
  private readonly brdf: SplitCall;
  private readonly sampler: Sampler;
  private frame: ShadingFrame | null = null;
  private shadows: LightShadows | null = null;
  private point: ShadedPoint | null = null;
  private wantsData = false;

  constructor(options: LightingOptions) {
    super();
    this.options = options;
    this.brdf = modelFunctionByLight(options.model, options.term, options.parameters, options.derived);
    this.sampler = createSampler(options.model, options.parameters);
  }

  override start(builder: NodeBuilder): void {
    this.frame = shadingFrame(builder, this.options.model);
    const { V, N, X, Y } = this.frame;
    this.wantsData = wantsFragmentData(builder);
    if (this.wantsData) {
      (fragmentData.tangent as unknown as Assignable).assign(X);
      (fragmentData.lamps as unknown as Assignable).assign(float(0));
      (fragmentData.cascade as unknown as Assignable).assign(float(0));
    }
    run(this.brdf.perView(V, N, X, Y));
    // Lights add to these inside branches: they must be declared, and 0, before the first of them.
    const { reflectedLight } = builder.context as unknown as {
      reflectedLight: Record<'directSpecular' | 'indirectSpecular', { assign(value: Node): void }>;
    };
    reflectedLight.directSpecular.assign(vec3(0));
    reflectedLight.indirectSpecular.assign(vec3(0));
    this.shadows = lightShadows(builder);
    this.point = this.shadows && fragmentPoint();
    this.shadows?.start(builder);
    super.start(builder);
  }

  /** One more lamp reaches the fragment. */
  private count(): void {
    if (this.wantsData) (fragmentData.lamps as unknown as Assignable).addAssign(float(1));
  }

  private f(L: Vec3): Vec3 {
    const { V, N, X, Y } = this.frame as ShadingFrame;
    return nonNegative(this.brdf.perLight(L, V, N, X, Y));
  }

  /** f (n.l), 0 where the light is below the horizon. */
  private reflected(L: Vec3, cosine: Float): Vec3 {
    const { V, N, X, Y } = this.frame as ShadingFrame;
    return nonNegative(this.brdf.perLight(L, V, N, X, Y).mul(aboveHorizon(cosine)) as Vec3);
  }

  /** Directional, point and spot lights; a shadow of three.js' own is in lightColor already. */
  override direct(data: Parameters<LightingModel['direct']>[0], builder: NodeBuilder): void {
    const { lightDirection, lightColor, lightNode, reflectedLight } = data as unknown as {
      lightDirection: Vec3;
      lightColor: Vec3;
      lightNode: AnalyticLightNode<Light> & { light: Light };
      reflectedLight: { directSpecular: Assignable };
    };
    if (frameContext(builder).rayTracer) return;
    const { N } = this.frame as ShadingFrame;
    const lamp = lampLight(lightNode, builder, { lightDirection, lightColor });
    const L = lamp.direction.toVar() as Vec3;
    const E = lamp.irradiance.toVar() as Vec3;
    const cosine = dot(N, L).toVar() as Float;
    const shadow = this.shadows?.lamp(lightNode.light, builder) ?? null;
    // Without a branch, where there is little to skip: a software GPU computes what is in it, anyway, and the branch besides.
    if (isOneLamp(lightNode.light) && !shadow && !this.wantsData && !hasAir(builder)) {
      reflectedLight.directSpecular.addAssign(this.reflected(L, cosine).mul(E));
      return;
    }
    // Most fragments face away from most lights, or are outside a spot's cone.
    If(cosine.mul(E.x.add(E.y).add(E.z)).greaterThan(0), () => {
      const shadowed = shadow ? E.mul(shadow(this.point as ShadedPoint)) : E;
      const air = airToLamp(builder, lightNode, L);
      const light = air ? shadowed.mul(air) : shadowed;
      reflectedLight.directSpecular.addAssign(this.reflected(L, cosine).mul(light));
      if (this.wantsData) {
        If(light.x.add(light.y).add(light.z).greaterThan(0), () => this.count());
        const cascade = this.shadows?.cascade(lightNode.light, builder);
        const found = cascade?.(this.point as ShadedPoint).add(1);
        if (found) (fragmentData.cascade as unknown as Assignable).assign(found);
      }
    });
  }

  /**
   * A rectangle, by multiple importance sampling: points on it and directions drawn from the model, weighted
   * by the power heuristic with exponent 2 (E. Veach, 1997, section 9.2). The points serve rough surfaces, the
   * directions smooth ones. Each direction stands for a square of the rectangle's plane, as large as its density says, and
   * counts by the part of it that the rectangle covers (docs/decisions/wide-lights.md).
   */
  override directRectArea(data: Parameters<LightingModel['directRectArea']>[0], builder: NodeBuilder): void {
    const { lightColor, lightPosition, halfWidth, halfHeight, lightNode, reflectedLight } =
      data as unknown as {
        lightNode: { light: Light };
        lightColor: Vec3;
        lightPosition: Vec3;
        halfWidth: Vec3;
        halfHeight: Vec3;
        reflectedLight: { directSpecular: Assignable };
      };
    if (frameContext(builder).rayTracer) return;
    const { V, N, X, Y } = this.frame as ShadingFrame;
    const { sampleL, pdf } = this.sampler;
    this.sampler.start(V, N, X, Y);
    const points = RECTANGLE_POINTS;
    const directions = RECTANGLE_DIRECTIONS;
    const center = lightPosition.sub(positionView as Vec3).toVar() as Vec3;
    const side = cross(halfWidth, halfHeight).toVar() as unknown as Vec3;
    const quarterArea = side.length().toVar();
    const [width2, height2] = [dot(halfWidth, halfWidth).toVar(), dot(halfHeight, halfHeight).toVar()];
    // It shines along its -z axis.
    const facing = side.div(quarterArea).negate().toVar() as Vec3;
    const sum = vec3(0).toVar();
    const shadow = this.shadows?.panel(lightNode.light, builder) ?? null;
    const point = this.point as ShadedPoint;
    const blocker = shadow && keptFloat(shadow.blocker(point));
    /** 1 where the fragment sees a place of the rectangle. @param spread how far apart the places are */
    const seen = (place: Node<'vec2'>, i: Float, spread: number): Float | null => {
      if (shadow === null || blocker === null) return null;
      const turn = i.mul(0.7548776662466927).add(point.noise).fract().toVar() as Float;
      const shift = vec2(turn, turn.mul(13).fract()).sub(0.5).mul(spread);
      return shadow.seen(point, blocker, place.add(shift).clamp(-1, 1) as unknown as Node<'vec2'>, turn);
    };
    /** Adds f (n.l) p/(p^2 + q^2): p and q are how densely its own kind and the other sample l, in 1/sr. */
    const add = (L: Vec3, cosine: Float, p: Float, q: Float, visible: Float | null) => {
      const ratio = q.div(p).toVar();
      const share = cosine.div(p.mul(ratio.mul(ratio).add(1))) as Float;
      sum.addAssign(this.f(L).mul(visible === null ? share : share.mul(visible)));
    };
    repeat(points, (i) => {
      const u = latticePoint(i, points);
      const toPoint = center
        .add(halfWidth.mul(u.x.mul(2).sub(1)))
        .add(halfHeight.mul(u.y.mul(2).sub(1)))
        .toVar() as Vec3;
      const distance2 = dot(toPoint, toPoint).toVar();
      const L = toPoint.mul(distance2.inverseSqrt()).toVar() as Vec3;
      const cosineAtLight = dot(facing, L).negate().toVar();
      const cosine = dot(N, L).toVar();
      If(cosine.greaterThan(0).and(cosineAtLight.greaterThan(1e-6)), () => {
        const lightDensity = distance2.div(cosineAtLight.mul(quarterArea).mul(4));
        const other = pdf(L, V, N, X, Y).mul(directions * DIRECTIONS_TRUST) as Float;
        const place = vec2(u.x, u.y).mul(2).sub(1) as unknown as Node<'vec2'>;
        add(L, cosine, lightDensity.mul(points) as Float, other, seen(place, i, 2 / Math.sqrt(points)));
      });
    });
    repeat(directions, (i) => {
      const u = latticePoint(i, directions);
      const L = sampleL(vec2(u.x, u.y) as unknown as Node<'vec2'>, V, N, X, Y).toVar() as Vec3;
      const cosine = dot(N, L).toVar();
      const cosineAtLight = dot(facing, L).negate().toVar();
      If(cosine.greaterThan(0).and(cosineAtLight.greaterThan(1e-6)), () => {
        const t = dot(center, facing).negate().div(cosineAtLight).toVar();
        If(t.greaterThan(0), () => {
          const density = pdf(L, V, N, X, Y).mul(directions).toVar() as Float;
          If(density.greaterThan(0), () => {
            const hit = L.mul(t).sub(center).toVar() as Vec3;
            const place = vec2(dot(hit, halfWidth).div(width2), dot(hit, halfHeight).div(height2)).toVar();
            const area = t.mul(t).div(cosineAtLight).toVar();
            const half = area.div(density).sqrt().div(2);
            const square = vec2(half.div(width2.sqrt()), half.div(height2.sqrt())).max(LEAST_SQUARE).toVar();
            const covered = place.add(square).min(1).sub(place.sub(square).max(-1)).max(0).div(square.mul(2));
            const part = covered.x.mul(covered.y).toVar() as Float;
            If(part.greaterThan(0), () => {
              const other = area.div(quarterArea.mul(4)).mul(points / DIRECTIONS_TRUST) as Float;
              const visible = seen(place as unknown as Node<'vec2'>, i, 0);
              add(L, cosine, density, other, visible === null ? part : (part.mul(visible) as Float));
            });
          });
        });
      });
    });
    const air = airTo(builder, center, center.length() as Float);
    reflectedLight.directSpecular.addAssign(air ? sum.mul(lightColor).mul(air) : sum.mul(lightColor));
    If(sum.x.add(sum.y).add(sum.z).greaterThan(0), () => this.count());
  }

  /**
   * Ambient light and the environment. three.js gives ambient and hemisphere lights as irradiance E: the
   * constant radiance E/pi, of which the surface reflects its directional albedo R(v).
   */
  override indirect(builder: NodeBuilder): void {
    const { irradiance, ambientOcclusion, reflectedLight } = builder.context as unknown as {
      irradiance: Vec3;
      ambientOcclusion: Float;
      reflectedLight: { indirectSpecular: Assignable };
    };
    const { environment, hasTable } = this.options;
    const told = frameContext(builder);
    const ambient = hasAmbient(builder) ? (irradiance.mul(1 / Math.PI) as Vec3) : null;
    if (!environment && !ambient && !told.tracedLight && !told.rayTracer) return;
    const reflector = {
      frame: this.frame as ShadingFrame,
      sampler: this.sampler,
      hasTable,
      f: (L: Vec3) => this.f(L),
    };
    if (told.rayTracer) {
      traceRays(reflector, environment, ambient, told.rayTracer);
      return;
    }
    const reflected = lightFromEverywhere(reflector, environment, ambient, told);
    reflectedLight.indirectSpecular.addAssign(reflected.mul(ambientOcclusion));
  }
}

/** The cosine where it is positive, else 0. */
const aboveHorizon = glslFunction(`
  float aboveHorizon(float cosine) {
    return cosine * step(0.0, cosine);
  }
`) as unknown as (cosine: Float) => Float;

/** Whether anything but lamps lights the scene. */
function hasAmbient(builder: NodeBuilder): boolean {
  const { lightsNode } = builder as unknown as {
    lightsNode: { getLightNodes(builder: NodeBuilder): { light?: Light; type: string }[] };
  };
  return lightsNode.getLightNodes(builder).some(({ light, type }) => {
    if (!light) return type !== 'AONode' && type !== 'NearLightNode';
    const kind = light as { isAmbientLight?: true; isHemisphereLight?: true; isLightProbe?: true };
    return kind.isAmbientLight || kind.isHemisphereLight || kind.isLightProbe;
  });
}
