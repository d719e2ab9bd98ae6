import { Fn, If, texture, uv, vec2, vec3, vec4 } from 'three/tsl';
import {
  HalfFloatType,
  LinearFilter,
  Node,
  type NodeBuilder,
  type NodeFrame,
  NodeMaterial,
  NodeUpdateType,
  QuadMesh,
  type Renderer,
  RendererUtils,
  RenderTarget,
  Texture,
  type TextureNode,
} from 'three/webgpu';
import type { Model } from '../glsl/model.ts';
import { modelFunction } from '../glsl/tsl.ts';
import type { BrdfMaterial } from './brdf-material.ts';
import { repeat } from './loop.ts';
import { nonNegative } from './non-negative.ts';
import { parameterNodes } from './parameter-nodes.ts';
import { createSampler, latticePoint } from './sampler.ts';
import { dependsOnTangent } from './tangent-dependence.ts';

type Float = Node<'float'>;
type Vec3 = Node<'vec3'>;

/** Texels over sqrt(n.v): grazing views, where albedo changes fast, get more of them. */
const TEXELS = 32;
/** Directions per texel: all for one azimuth of v, or shared among several where it matters. */
const SAMPLES = 512;
const AZIMUTHS = 8;

/**
 * The directional albedo R(v) = integral of f(l, v) (n.l) dl of a material over n.v, in a texture of one
 * row, drawn on the GPU by importance sampling with the model's own sampler whenever a parameter changes.
 * Anisotropic materials are averaged over the azimuth of v.
 */
class AlbedoPass {
  private readonly quad: QuadMesh;
  private readonly material: NodeMaterial & { values?: BrdfMaterial['values']; highlightAlpha?: number };

  constructor(model: Model, term: string) {
    this.material = new NodeMaterial();
    this.material.fragmentNode = albedoNode(model, term);
    // Several materials share this pass: the uniforms must be read anew for each.
    this.material.setupObserver = (builder) =>
      alwaysRefreshed(NodeMaterial.prototype.setupObserver.call(this.material, builder));
    this.quad = new QuadMesh(this.material);
  }

  render(renderer: Renderer, source: BrdfMaterial, target: RenderTarget): void {
    this.material.values = source.values;
    this.material.highlightAlpha = source.highlightAlpha;
    const state = RendererUtils.resetRendererState(renderer, {} as never);
    renderer.setRenderTarget(target);
    this.quad.render(renderer);
    RendererUtils.restoreRendererState(renderer, state);
  }
}

/** An observer of material changes that sees one each time. */
export function alwaysRefreshed<T>(observer: T): T {
  (observer as { hasNode: boolean }).hasNode = true;
  return observer;
}

function albedoNode(model: Model, term: string): Node {
  const parameters = parameterNodes(model, {});
  const brdf = modelFunction(model, term, parameters);
  const { sampleL, pdf } = createSampler(model, parameters);
  const [N, X, Y] = [vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)] as unknown as [Vec3, Vec3, Vec3];
  return Fn(() => {
    // The first and the last texel's middles are 0 and 1.
    const root = (uv() as Node<'vec2'>).x
      .mul(TEXELS)
      .sub(0.5)
      .div(TEXELS - 1);
    const cosine = root.mul(root).max(1e-4).toVar();
    const sine = cosine.mul(cosine).oneMinus().max(0).sqrt().toVar();
    const azimuths = dependsOnTangent(model) ? AZIMUTHS : 1;
    const samples = SAMPLES / azimuths;
    const sum = vec3(0).toVar();
    repeat(azimuths, (azimuth) => {
      const phi = azimuth.mul((2 * Math.PI) / azimuths).toVar();
      const V = vec3(sine.mul(phi.cos()), sine.mul(phi.sin()), cosine).toVar() as unknown as Vec3;
      repeat(samples, (i) => {
        const u = latticePoint(i, samples);
        const L = sampleL(vec2(u.x, u.y) as unknown as Node<'vec2'>, V, N, X, Y).toVar() as Vec3;
        If(L.z.greaterThan(0), () => {
          const density = pdf(L, V, N, X, Y).toVar();
          If(density.greaterThan(0), () => {
            sum.addAssign(nonNegative(brdf(L, V, N, X, Y)).mul(L.z.div(density)));
          });
        });
      });
    });
    return vec4(sum.div(SAMPLES), 1);
  })() as unknown as Node;
}

const passes = new WeakMap<Model, Map<string, AlbedoPass>>();

function passFor(model: Model, term: string): AlbedoPass {
  const byTerm = passes.get(model) ?? new Map<string, AlbedoPass>();
  passes.set(model, byTerm);
  const pass = byTerm.get(term) ?? new AlbedoPass(model, term);
  byTerm.set(term, pass);
  return pass;
}

/** A material's table: its texture, and the state of the material that it was drawn for. */
export class AlbedoTable {
  readonly target = new RenderTarget(TEXELS, 1, {
    type: HalfFloatType,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    depthBuffer: false,
  });
  private drawn = '';

  update(renderer: Renderer, material: BrdfMaterial): void {
    const state = `${material.term} ${material.valuesVersion}`;
    if (this.drawn === state) return;
    this.drawn = state;
    passFor(material.model, material.term).render(renderer, material, this.target);
  }

  dispose(): void {
    this.target.dispose();
  }
}

/** R(v) of the material that is being drawn, from its table. */
export class AlbedoNode extends Node {
  static get type(): string {
    return 'AlbedoNode';
  }

  private readonly table: TextureNode;

  /** @param cosine n.v */
  constructor(cosine: Float) {
    super('vec3' as never);
    const root = cosine.max(0).sqrt();
    const u = root
      .mul(TEXELS - 1)
      .add(0.5)
      .div(TEXELS);
    this.table = texture(new Texture(), vec2(u, 0.5)) as unknown as TextureNode;
    this.updateBeforeType = NodeUpdateType.OBJECT;
  }

  override updateBefore(frame: NodeFrame): undefined {
    const { renderer, material } = frame as unknown as { renderer: Renderer; material: BrdfMaterial };
    // Materials of one model share what was built for the first of them, but not its table.
    material.albedoTable ??= new AlbedoTable();
    material.albedoTable.update(renderer, material);
    this.table.value = material.albedoTable.target.texture;
  }

  override setup(builder: NodeBuilder): Node {
    const { material } = builder as unknown as { material: BrdfMaterial };
    if (material.albedoTable) this.table.value = material.albedoTable.target.texture;
    return (this.table as unknown as Node<'vec4'>).rgb;
  }
}
