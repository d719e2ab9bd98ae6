/**
 * What objects are drawn with onto the map of the ground: each place of it gets the colour of a direction once, however often
 * the objects cover it. Every direction has a depth of its own, nearer than those before: of one direction the first
 * fragment alone passes.
 */
import { uniform, vec4 } from 'three/tsl';
import {
  AddEquation,
  CustomBlending,
  LessDepth,
  type Mesh,
  type Node,
  NodeMaterial,
  OneFactor,
  Vector3,
} from 'three/webgpu';
import { CastingMaterials, type CastingSurface } from '../effects/shadows/casting-materials.ts';
import { castingSide } from '../effects/shadows/sides.ts';

export class ProjectedMaterials {
  /** Of the direction that is drawn. */
  readonly color = uniform(new Vector3());
  readonly depth = uniform(1);
  readonly #materials = new CastingMaterials<'direction'>((side) => {
    const material = new NodeMaterial();
    material.name = 'sky shadow';
    material.side = side;
    // Its alpha is for what cuts holes.
    material.colorNode = vec4(this.color, 1) as unknown as NodeMaterial['colorNode'];
    material.depthNode = this.depth as unknown as Node;
    material.depthFunc = LessDepth;
    material.blending = CustomBlending;
    material.blendEquation = AddEquation;
    material.blendSrc = OneFactor;
    material.blendDst = OneFactor;
    return material;
  });

  /** For a mesh with a material of its own. */
  for(surface: CastingSurface, { geometry }: Mesh): NodeMaterial {
    return this.#materials.of(surface, castingSide(surface, geometry, false), 'direction');
  }

  dispose(): void {
    this.#materials.dispose();
  }
}
