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
  type Material,
  type Mesh,
  type Node,
  NodeMaterial,
  OneFactor,
  type Side,
  Vector3,
} from 'three/webgpu';
import { castingSide } from '../effects/shadows/sides.ts';

type Surface = Material & Partial<Pick<NodeMaterial, 'opacityNode'>> & { alphaMap?: unknown };

export class ProjectedMaterials {
  /** Of the direction that is drawn. */
  readonly color = uniform(new Vector3());
  readonly depth = uniform(1);
  readonly #plain = new Map<Side, NodeMaterial>();
  #cut = new WeakMap<Material, { key: string; material: NodeMaterial }>();
  readonly #made: NodeMaterial[] = [];

  /** For a mesh with a material of its own. */
  for(surface: Surface, { geometry }: Mesh): NodeMaterial {
    const side = castingSide(surface, geometry, false);
    if (surface.alphaTest <= 0 && !surface.transparent) {
      const material = this.#plain.get(side) ?? this.#make(side);
      this.#plain.set(side, material);
      return material;
    }
    const key = `${side} ${surface.version} ${surface.transparent}`;
    let entry = this.#cut.get(surface);
    if (entry?.key !== key) {
      const material = this.#make(side);
      // What is blended keeps off a part of the light: the same part of its texels is left out.
      material.alphaHash = surface.transparent;
      material.opacityNode = surface.opacityNode ?? null;
      Object.assign(material, { alphaMap: surface.alphaMap ?? null });
      entry = { key, material };
      this.#cut.set(surface, entry);
    }
    entry.material.alphaTest = surface.transparent ? 0 : surface.alphaTest;
    entry.material.opacity = surface.opacity;
    return entry.material;
  }

  dispose(): void {
    for (const material of this.#made) material.dispose();
  }

  #make(side: Side): NodeMaterial {
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
    this.#made.push(material);
    return material;
  }
}
