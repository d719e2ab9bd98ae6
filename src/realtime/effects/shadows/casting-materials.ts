/**
 * What objects are drawn with where only what they keep off counts: one material for all that is whole, and one for each
 * surface with holes or opacity.
 */
import type { Material, NodeMaterial, Side } from 'three/webgpu';

/** A surface, as far as it can let light through. */
export type CastingSurface = Material & Partial<Pick<NodeMaterial, 'opacityNode'>> & { alphaMap?: unknown };

interface Cut {
  /** What of the surface the shader was made of. */
  readonly version: string;
  readonly material: NodeMaterial;
}

export class CastingMaterials<Kind extends string> {
  readonly #make: (side: Side, kind: Kind) => NodeMaterial;
  readonly #plain = new Map<string, NodeMaterial>();
  #cut = new WeakMap<Material, Map<string, Cut>>();
  readonly #made = new Set<NodeMaterial>();

  /** @param make what draws the side; its colour's alpha is 1 */
  constructor(make: (side: Side, kind: Kind) => NodeMaterial) {
    this.#make = make;
  }

  of(surface: CastingSurface, side: Side, kind: Kind): NodeMaterial {
    const name = `${side} ${kind}`;
    if (surface.alphaTest <= 0 && !surface.transparent) {
      const material = this.#plain.get(name) ?? this.#new(side, kind);
      this.#plain.set(name, material);
      return material;
    }
    const { material } = this.#cutOut(surface, side, kind, name);
    material.alphaTest = surface.transparent ? 0 : surface.alphaTest;
    material.opacity = surface.opacity;
    return material;
  }

  dispose(): void {
    for (const material of this.#made) material.dispose();
  }

  #cutOut(surface: CastingSurface, side: Side, kind: Kind, name: string): Cut {
    const known = this.#cut.get(surface) ?? new Map<string, Cut>();
    this.#cut.set(surface, known);
    const version = `${surface.version} ${surface.transparent}`;
    const before = known.get(name);
    if (before?.version === version) return before;
    if (before) {
      this.#made.delete(before.material);
      before.material.dispose();
    }
    const material = this.#new(side, kind);
    // What is blended keeps off a part of the light: the same part of its texels is left out.
    material.alphaHash = surface.transparent;
    material.opacityNode = surface.opacityNode ?? null;
    Object.assign(material, { alphaMap: surface.alphaMap ?? null });
    const cut = { version, material };
    known.set(name, cut);
    return cut;
  }

  #new(side: Side, kind: Kind): NodeMaterial {
    const material = this.#make(side, kind);
    this.#made.add(material);
    return material;
  }
}
