/** The ground's material: it multiplies what is behind it by the part of its light that reaches it. */
import {
  cameraViewMatrix,
  cross,
  dot,
  float,
  If,
  luminance,
  positionView,
  positionWorld,
  smoothstep,
  uniform,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import {
  AddEquation,
  type AnalyticLightNode,
  type Color,
  CustomBlending,
  type Light,
  LightingModel,
  LightingNode,
  type Node,
  type NodeBuilder,
  NodeMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SrcColorFactor,
  Vector4,
  ZeroFactor,
} from 'three/webgpu';
import {
  fragmentPoint,
  type LightShadows,
  lightShadows,
  type ShadedPoint,
} from '../../material/light-shadows.ts';
import { latticePoint } from '../../material/sampler.ts';
import { type Assignable, keptFloat, repeat } from '../../material/statements.ts';
import type { SkyShadow } from './sky-shadow.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** Points of a rectangle that are looked at. */
const RECTANGLE_POINTS = 48;

/** The sky lights the ground even where there are no lamps: three.js must ask the lighting model. */
class SkyNode extends LightingNode {
  static get type(): string {
    return 'GroundSkyNode';
  }
}

export class CatcherMaterial extends NodeMaterial {
  static override get type(): string {
    return 'CatcherMaterial';
  }

  /** x and z of the middle, the radius (0: no end) and the part of it over which shadows fade. */
  readonly rim = uniform(new Vector4());
  readonly strength = uniform(1);
  readonly #sky: SkyShadow;
  readonly #irradiance: Node<'vec3'>;

  /** @param irradiance of the sky on level ground; its object is read in every frame */
  constructor(sky: SkyShadow, irradiance: Color) {
    super();
    this.name = 'ground';
    this.lights = true;
    this.#sky = sky;
    this.#irradiance = uniform(irradiance) as unknown as Node<'vec3'>;
    // What is there is multiplied; of a transparent picture, which is black there, the shadow covers a part.
    this.blending = CustomBlending;
    this.blendEquation = AddEquation;
    this.blendSrc = ZeroFactor;
    this.blendDst = SrcColorFactor;
    this.blendSrcAlpha = OneFactor;
    this.blendDstAlpha = OneMinusSrcAlphaFactor;
    // A floor that lies in the ground is before it.
    this.polygonOffset = true;
    this.polygonOffsetFactor = 1;
    this.polygonOffsetUnits = 4;
  }

  override setupMaterialLightings(builder: NodeBuilder): ReturnType<NodeMaterial['setupMaterialLightings']> {
    return [...super.setupMaterialLightings(builder), new SkyNode()];
  }

  override setupLightingModel(): CatcherLightingModel {
    return new CatcherLightingModel(this.#sky, this.#irradiance);
  }

  override setupOutput(_builder: NodeBuilder, output: Node): Node {
    const place = (positionWorld as Vec3).xz as Vec2;
    const { x: radius, y: fade } = this.rim.zw as unknown as { x: Float; y: Float };
    const from = radius.mul(fade.oneMinus());
    const distance = place.sub(this.rim.xy as Vec2).length();
    const inside = smoothstep(from, radius.max(from.add(radius.mul(1e-6))), distance).oneMinus();
    const presence = radius.greaterThan(0).select(inside, float(1));
    const shade = (output as Node<'vec4'>).rgb
      .oneMinus()
      .mul(this.strength)
      .mul(presence)
      .oneMinus()
      .toVar() as Vec3;
    return vec4(shade, luminance(shade).oneMinus()) as unknown as Node;
  }
}

/** The irradiance of lamps and sky on level ground: with the objects there, over that without them. */
class CatcherLightingModel extends LightingModel {
  private readonly sky: SkyShadow;
  private readonly irradiance: Vec3;
  private readonly arrived = vec3(0).toVar() as Vec3;
  private readonly whole = vec3(0).toVar() as Vec3;
  private N: Vec3 | null = null;
  private shadows: LightShadows | null = null;
  private point: ShadedPoint | null = null;

  constructor(sky: SkyShadow, irradiance: Vec3) {
    super();
    this.sky = sky;
    this.irradiance = irradiance;
  }

  override start(builder: NodeBuilder): void {
    // Set here: lights add to them inside branches.
    assign(this.arrived, vec3(0));
    assign(this.whole, vec3(0));
    this.N = (cameraViewMatrix as unknown as Node<'mat4'>).mul(vec4(0, 1, 0, 0)).xyz.toVar() as Vec3;
    this.shadows = lightShadows(builder);
    this.point = this.shadows && fragmentPoint();
    super.start(builder);
  }

  /** Directional, point and spot lights. */
  override direct(data: Parameters<LightingModel['direct']>[0], builder: NodeBuilder): void {
    const { lightDirection, lightColor, lightNode } = data as unknown as {
      lightDirection: Vec3;
      lightColor: Vec3;
      lightNode: AnalyticLightNode<Light> & { light: Light };
    };
    const L = lightDirection.toVar() as Vec3;
    const E = lightColor.mul(dot(this.N as Vec3, L).max(0)).toVar() as Vec3;
    If(E.x.add(E.y).add(E.z).greaterThan(0), () => {
      const shadow = this.shadows?.lamp(lightNode.light, builder);
      const lit = shadow ? E.mul(shadow(this.point as ShadedPoint)) : E;
      add(this.whole, E);
      add(this.arrived, lit as Vec3);
    });
  }

  /** A rectangle, by even points on it: the same ones for what arrives and for what would. */
  override directRectArea(data: Parameters<LightingModel['directRectArea']>[0], builder: NodeBuilder): void {
    const { lightColor, lightPosition, halfWidth, halfHeight, lightNode } = data as unknown as {
      lightNode: { light: Light };
      lightColor: Vec3;
      lightPosition: Vec3;
      halfWidth: Vec3;
      halfHeight: Vec3;
    };
    const centre = lightPosition.sub(positionView as Vec3).toVar() as Vec3;
    const side = cross(halfWidth, halfHeight).toVar() as unknown as Vec3;
    const quarterArea = side.length().toVar() as Float;
    const facing = side.div(quarterArea).negate().toVar() as Vec3;
    const shadow = this.shadows?.panel(lightNode.light, builder) ?? null;
    const point = this.point as ShadedPoint;
    const blocker = shadow && keptFloat(shadow.blocker(point));
    const [sum, seen] = [float(0).toVar() as Float, float(0).toVar() as Float];
    repeat(RECTANGLE_POINTS, (i) => {
      const u = latticePoint(i, RECTANGLE_POINTS);
      const place = vec2(u.x, u.y).mul(2).sub(1).toVar() as unknown as Vec2;
      const way = centre.add(halfWidth.mul(place.x)).add(halfHeight.mul(place.y)).toVar() as Vec3;
      const distance2 = dot(way, way).toVar() as Float;
      const L = way.mul(distance2.inverseSqrt()).toVar() as Vec3;
      const cosines = dot(this.N as Vec3, L)
        .max(0)
        .mul(dot(facing, L).negate().max(0))
        .toVar() as Float;
      If(cosines.greaterThan(0), () => {
        const share = cosines.div(distance2).toVar() as Float;
        add(sum, share);
        if (shadow === null || blocker === null) add(seen, share);
        else {
          const turn = i.mul(0.7548776662466927).add(point.noise).fract().toVar() as Float;
          const shift = vec2(turn, turn.mul(13).fract())
            .sub(0.5)
            .mul(2 / Math.sqrt(RECTANGLE_POINTS));
          const at = place.add(shift).clamp(-1, 1) as unknown as Vec2;
          add(seen, share.mul(shadow.seen(point, blocker, at, turn)) as Float);
        }
      });
    });
    const E = lightColor.mul(quarterArea.mul(4 / RECTANGLE_POINTS)).toVar() as Vec3;
    add(this.whole, E.mul(sum) as Vec3);
    add(this.arrived, E.mul(seen) as Vec3);
  }

  override finish(builder: NodeBuilder): void {
    const kept = this.sky.kept((positionWorld as Vec3).xz as Vec2);
    const whole = this.whole.add(this.irradiance).toVar() as Vec3;
    const arrived = this.arrived.add(this.irradiance.mul(kept.oneMinus()));
    const lit = whole.greaterThan(vec3(0)) as unknown as Vec3;
    const { outgoingLight } = builder.context as unknown as { outgoingLight: Vec3 };
    // A channel without light has no shadow.
    const ratio = arrived.div(whole.max(1e-30)).clamp(0, 1);
    assign(outgoingLight, vec3(1).sub(vec3(lit).mul(ratio.oneMinus())) as Vec3);
  }
}

const assign = (variable: Node, value: Node) => (variable as unknown as Assignable).assign(value);
const add = (variable: Node, value: Node) => (variable as unknown as Assignable).addAssign(value);
