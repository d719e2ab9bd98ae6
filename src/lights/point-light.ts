import {
  type ColorRepresentation,
  type NodeBuilder,
  type NodeFrame,
  PointLight,
  PointLightNode,
} from 'three/webgpu';
import { type Falloff, FalloffNodes } from './falloff.ts';
import { lightColor, lightVector } from './light-vector.ts';

/**
 * A point light: E = I f_dist(r), I its intensity in cd (E. Yerga, 2018, section 4.7).
 *
 * `distance` is its range in metres, 0 for none. `decay` is not used: `falloff` takes its place.
 */
export class BrdfPointLight extends PointLight {
  falloff: Falloff = 'inverse-square';
  /** Of the lamp, in metres. Shadows alone know it (docs/decisions/light-sizes.md). */
  radius = 0;

  /** @param intensity in cd */
  constructor(color?: ColorRepresentation, intensity = 1) {
    super(color, intensity);
  }

  override copy(source: this, recursive?: boolean): this {
    super.copy(source, recursive);
    this.falloff = source.falloff;
    this.radius = source.radius;
    return this;
  }
}

class BrdfPointLightNode extends PointLightNode {
  static get type(): string {
    return 'BrdfPointLightNode';
  }

  private readonly falloff = new FalloffNodes();

  override update(frame: NodeFrame): undefined {
    super.update(frame);
    const light = this.light as BrdfPointLight;
    this.falloff.set(light.falloff, light.distance);
  }

  override setupDirect(builder: NodeBuilder) {
    const { lightDirection, inverseDistance } = lightVector(this, builder);
    return { lightDirection, lightColor: lightColor(this).mul(this.falloff.at(inverseDistance)) };
  }
}

BrdfPointLight.registerNode(BrdfPointLightNode);
