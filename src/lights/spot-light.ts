import { lightTargetDirection, renderGroup, uniform } from 'three/tsl';
import {
  type ColorRepresentation,
  type Node,
  type NodeBuilder,
  type NodeFrame,
  SpotLight,
  SpotLightNode,
  type UniformNode,
} from 'three/webgpu';
import { glslFunction } from '../glsl/tsl.ts';
import { viewDirection } from '../material/view-direction.ts';
import { hasOneView } from '../material/view-space.ts';
import { type Falloff, FalloffNodes } from './falloff.ts';
import { lightColor, lightVector } from './light-vector.ts';

/**
 * The thesis's spot light: I(l) = I_max cos(theta_s)^s for theta_s <= theta_u, else 0, where theta_s is
 * the angle between the spot's direction and -l; E = I(l) f_dist(r) (E. Yerga, 2018, section 4.7).
 *
 * `intensity` is I_max in cd, `angle` is theta_u in radians (up to pi/2), `distance` the range in metres.
 * A `penumbra` in 0..1 beyond the thesis softens the edge inward: from theta_u (1 - penumbra) to theta_u.
 */
export class BrdfSpotLight extends SpotLight {
  /** s: how fast the light falls from the axis outward; 0 is a disc of even intensity. */
  exponent = 0;
  falloff: Falloff = 'inverse-square';
  /** Of the lamp, in metres. Shadows alone know it (docs/decisions/light-sizes.md). */
  radius = 0;

  /** @param intensity I_max in cd  @param angle theta_u in radians */
  constructor(color?: ColorRepresentation, intensity = 1, angle = Math.PI / 6, exponent = 0) {
    super(color, intensity, 0, angle);
    this.exponent = exponent;
  }

  override copy(source: this, recursive?: boolean): this {
    super.copy(source, recursive);
    this.exponent = source.exponent;
    this.falloff = source.falloff;
    this.radius = source.radius;
    return this;
  }
}

/** I(l)/I_max of a spot light. @param cosTheta cosine of theta_s @param angle theta_u in radians */
export function spotFactor(cosTheta: number, angle: number, exponent: number, penumbra = 0): number {
  const [outer, inner] = [Math.cos(angle), Math.cos(angle * (1 - penumbra))];
  if (cosTheta < outer) return 0;
  const t = inner > outer ? Math.min((cosTheta - outer) / (inner - outer), 1) : 1;
  return Math.max(cosTheta, 0) ** exponent * t * t * (3 - 2 * t);
}

/** Without penumbra the edge is a step: a slope that no difference of float32 cosines but 0 survives. */
export const STEP_SLOPE = 1e30;

/** spotFactor() on the GPU. The least positive base keeps pow(0, 0) out, which is undefined. */
const beamOf = glslFunction(`
  float beam(float cosTheta, float cosCutoff, float edgeSlope, float exponent) {
    return pow(max(cosTheta, 1e-6), exponent) * smoothstep(0.0, 1.0, (cosTheta - cosCutoff) * edgeSlope);
  }
`) as unknown as (cosTheta: Node, cosCutoff: Node, edgeSlope: Node, exponent: Node) => Node<'float'>;

class BrdfSpotLightNode extends SpotLightNode {
  static get type(): string {
    return 'BrdfSpotLightNode';
  }

  private readonly falloff = new FalloffNodes();
  private readonly cosCutoff: UniformNode<'float', number> = uniform(0).setGroup(renderGroup);
  private readonly edgeSlope: UniformNode<'float', number> = uniform(0).setGroup(renderGroup);
  private readonly exponent: UniformNode<'float', number> = uniform(0).setGroup(renderGroup);

  override update(frame: NodeFrame): undefined {
    super.update(frame);
    const light = this.light as BrdfSpotLight;
    this.falloff.set(light.falloff, light.distance);
    this.exponent.value = light.exponent;
    const outer = Math.cos(light.angle);
    const inner = Math.cos(light.angle * (1 - light.penumbra));
    this.cosCutoff.value = outer;
    this.edgeSlope.value = inner > outer ? 1 / (inner - outer) : STEP_SLOPE;
  }

  override setupDirect(builder: NodeBuilder) {
    const { lightDirection, inverseDistance } = lightVector(this, builder);
    const light = this.light as SpotLight;
    const axis = hasOneView(builder) ? viewDirection(light) : (lightTargetDirection(light) as Node<'vec3'>);
    const cosTheta = lightDirection.dot(axis).toVar();
    const beam = beamOf(cosTheta, this.cosCutoff, this.edgeSlope, this.exponent);
    return { lightDirection, lightColor: lightColor(this).mul(this.falloff.at(inverseDistance)).mul(beam) };
  }
}

BrdfSpotLight.registerNode(BrdfSpotLightNode);
