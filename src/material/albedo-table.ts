import {
  Fn,
  float,
  If,
  ivec2,
  materialReference,
  mix,
  texture,
  textureLoad,
  uv,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import {
  FloatType,
  NearestFilter,
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
import { glslFunction, modelFunctionByLight } from '../glsl/tsl.ts';
import type { BrdfMaterial } from './brdf-material.ts';
import { nonNegative } from './non-negative.ts';
import { derivedNodes, parameterNodes } from './parameter-nodes.ts';
import { createSampler, latticePoint } from './sampler.ts';
import { repeat, run } from './statements.ts';

type Float = Node<'float'>;
type Vec3 = Node<'vec3'>;

/**
 * Views at which R is integrated, spread evenly over (n.v)^WARP: with cubics through them, the interpolation
 * errs by less than 5e-4 of R for the models that ship, at n.v = .02 as at 1.
 */
const NODES = 16;
const WARP = 2 / 3;
/** Directions for each node, in rows that run side by side; a row has an azimuth of v of its own where that matters. */
const SAMPLES = 4096;
const ROWS = 16;
/** Texels over sqrt(n.v): grazing views, where albedo changes fast, get more of them. */
const TEXELS = 128;

const FLOATS = {
  type: FloatType,
  minFilter: NearestFilter,
  magFilter: NearestFilter,
  depthBuffer: false,
} as const;

type PassMaterial = NodeMaterial & Partial<Pick<BrdfMaterial, 'values' | 'derived' | 'highlightAlpha'>>;

/**
 * The directional albedo R(v) = integral of f(l, v) (n.l) dl of a material over n.v, in a texture of one
 * row, drawn on the GPU by importance sampling with the model's own sampler whenever a parameter changes:
 * first the sums at a few views, then the table between them. Anisotropic materials are averaged over the
 * azimuth of v.
 */
class AlbedoPass {
  private readonly sums = new RenderTarget(NODES, ROWS, FLOATS);
  private readonly sampling: PassMaterial & { turn?: number };
  private readonly sumUp: QuadMesh;
  private readonly fill: QuadMesh;

  constructor(model: Model, term: string) {
    this.sampling = passMaterial(sumNode(model, term));
    this.sumUp = new QuadMesh(this.sampling);
    this.fill = new QuadMesh(passMaterial(tableNode(this.sums.texture)));
  }

  render(renderer: Renderer, source: BrdfMaterial, target: RenderTarget): void {
    const { values, derived, highlightAlpha } = source;
    Object.assign(this.sampling, { values, derived, highlightAlpha });
    this.sampling.turn = source.dependsOnTangent() ? (2 * Math.PI) / ROWS : 0;
    const state = RendererUtils.resetRendererState(renderer, {} as never);
    renderer.setRenderTarget(this.sums);
    this.sumUp.render(renderer);
    renderer.setRenderTarget(target);
    this.fill.render(renderer);
    RendererUtils.restoreRendererState(renderer, state);
  }
}

function passMaterial(node: Node): PassMaterial {
  const material = new NodeMaterial();
  material.fragmentNode = node;
  // Several materials share a pass: the uniforms must be read anew for each.
  material.setupObserver = (builder) =>
    alwaysRefreshed(NodeMaterial.prototype.setupObserver.call(material, builder));
  return material as PassMaterial;
}

/** An observer of material changes that sees one each time. */
export function alwaysRefreshed<T>(observer: T): T {
  (observer as { hasNode: boolean }).hasNode = true;
  return observer;
}

/** The mean over one row's samples at one view: texel (view, row). */
function sumNode(model: Model, term: string): Node {
  const parameters = parameterNodes(model, {});
  const brdf = modelFunctionByLight(model, term, parameters, derivedNodes(model, term));
  const sampler = createSampler(model, parameters);
  const [N, X, Y] = [vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)] as unknown as [Vec3, Vec3, Vec3];
  return Fn(() => {
    const texel = (uv() as Node<'vec2'>).mul(vec2(NODES, ROWS)).floor().toVar();
    const cosine = texel.x
      .div(NODES - 1)
      .pow(1 / WARP)
      .max(1e-4)
      .toVar();
    const sine = cosine.mul(cosine).oneMinus().max(0).sqrt().toVar();
    const phi = texel.y.mul(materialReference('turn', 'float') as unknown as Float).toVar();
    const V = vec3(0).toVar() as Vec3;
    V.assign(vec3(sine.mul(phi.cos()), sine.mul(phi.sin()), cosine));
    run(brdf.perView(V, N, X, Y));
    sampler.start(V, N, X, Y);
    const sum = vec3(0).toVar();
    repeat(SAMPLES / ROWS, (i) => {
      const u = latticePoint(i.mul(ROWS).add(texel.y) as Float, SAMPLES);
      const L = sampler.sampleL(vec2(u.x, u.y) as unknown as Node<'vec2'>, V, N, X, Y).toVar() as Vec3;
      If(L.z.greaterThan(0), () => {
        const density = sampler.pdf(L, V, N, X, Y).toVar();
        If(density.greaterThan(0), () => {
          sum.addAssign(nonNegative(brdf.perLight(L, V, N, X, Y)).mul(L.z.div(density)));
        });
      });
    });
    return vec4(sum.div(SAMPLES / ROWS), 1);
  })() as unknown as Node;
}

/** The rows' mean, between the nodes by the cubic through the nearest four (Lagrange's). */
function tableNode(sums: Texture): Node {
  return Fn(() => {
    const root = (uv() as Node<'vec2'>).x
      .mul(TEXELS)
      .floor()
      .div(TEXELS - 1)
      .toVar();
    const place = root
      .pow(2 * WARP)
      .mul(NODES - 1)
      .toVar();
    const first = place
      .floor()
      .sub(1)
      .clamp(0, NODES - 4)
      .toVar();
    const x = place.sub(first).toVar();
    const sum = vec3(0).toVar();
    for (const i of [0, 1, 2, 3]) {
      const others = [0, 1, 2, 3].filter((j) => j !== i);
      const weight = others
        .reduce<Float>((w, j) => w.mul(x.sub(j).div(i - j)) as Float, float(1 / ROWS))
        .toVar();
      repeat(ROWS, (row) => {
        const texel = textureLoad(sums, ivec2(first.add(i).toInt(), row.toInt())) as unknown as Node<'vec4'>;
        sum.addAssign(texel.rgb.mul(weight));
      });
    }
    return vec4(sum.max(0), 1);
  })() as unknown as Node;
}

/** Of each renderer its own: what one of them gives back to its device is not another's. */
const passes = new WeakMap<Renderer, WeakMap<Model, Map<string, AlbedoPass>>>();

function passFor(renderer: Renderer, model: Model, term: string): AlbedoPass {
  const byModel = passes.get(renderer) ?? new WeakMap<Model, Map<string, AlbedoPass>>();
  passes.set(renderer, byModel);
  const byTerm = byModel.get(model) ?? new Map<string, AlbedoPass>();
  byModel.set(model, byTerm);
  const pass = byTerm.get(term) ?? new AlbedoPass(model, term);
  byTerm.set(term, pass);
  return pass;
}

/** A material's tables, one for each renderer: its texture, and the state of the material that it was drawn for. */
export class AlbedoTable {
  private readonly tables = new Map<Renderer, { readonly target: RenderTarget; drawn: string }>();

  /** The table as it is, maybe not drawn yet. */
  texture(renderer: Renderer): Texture {
    return this.of(renderer).target.texture;
  }

  update(renderer: Renderer, material: BrdfMaterial): void {
    const table = this.of(renderer);
    const state = `${material.term} ${material.valuesVersion}`;
    if (table.drawn === state) return;
    table.drawn = state;
    passFor(renderer, material.model, material.term).render(renderer, material, table.target);
  }

  dispose(): void {
    for (const { target } of this.tables.values()) target.dispose();
    this.tables.clear();
  }

  private of(renderer: Renderer): { readonly target: RenderTarget; drawn: string } {
    let table = this.tables.get(renderer);
    if (!table) {
      table = { target: new RenderTarget(TEXELS, 1, FLOATS), drawn: '' };
      this.tables.set(renderer, table);
    }
    return table;
  }
}

/** A cosine's place in a table: the texel left of it and how far it is from there. */
const tablePlace = glslFunction(`
  vec2 tablePlace(float cosine) {
    float place = sqrt(min(max(cosine, 0.0), 1.0)) * ${TEXELS - 1}.0;
    float left = min(floor(place), ${TEXELS - 2}.0);
    return vec2(left, place - left);
  }
`) as unknown as (cosine: Float) => Node<'vec2'>;

/** R(v) of the material that is being drawn, from its table. */
export class AlbedoNode extends Node {
  static get type(): string {
    return 'AlbedoNode';
  }

  private readonly table = (
    texture(new Texture()) as unknown as TextureNode & { setUpdateMatrix(value: boolean): TextureNode }
  ).setUpdateMatrix(false);
  private readonly cosine: Float;

  /** @param cosine n.v */
  constructor(cosine: Float) {
    super('vec3' as never);
    this.cosine = cosine;
    this.updateBeforeType = NodeUpdateType.OBJECT;
  }

  override updateBefore(frame: NodeFrame): undefined {
    const { renderer, material } = frame as unknown as { renderer: Renderer; material: BrdfMaterial };
    // Materials of one model share what was built for the first of them, but not its table.
    material.albedoTable ??= new AlbedoTable();
    material.albedoTable.update(renderer, material);
    this.table.value = material.albedoTable.texture(renderer);
  }

  override setup(builder: NodeBuilder): Node {
    const { material, renderer } = builder as unknown as { material: BrdfMaterial; renderer: Renderer };
    if (material.albedoTable) this.table.value = material.albedoTable.texture(renderer);
    const place = tablePlace(this.cosine).toVar();
    // Not by the sampler: its fractions have 8 bits only, and not every device filters 32-bit floats.
    const load = (x: Node<'int'>) =>
      (this.table as unknown as { load(uv: Node): Node<'vec4'> }).load(ivec2(x, 0)).rgb;
    const left = place.x.toInt().toVar() as Node<'int'>;
    return mix(load(left), load(left.add(1) as Node<'int'>), place.y);
  }
}
