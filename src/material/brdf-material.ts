import { diffuseColor, vec4 } from 'three/tsl';
import {
  type BufferGeometry,
  Color,
  DataTexture,
  Euler,
  HalfFloatType,
  LightingNode,
  type Node,
  type NodeBuilder,
  NodeMaterial,
  type NormalMapTypes,
  type Renderer,
  type Scene,
  TangentSpaceNormalMap,
  type Texture,
  Vector2,
  Vector3,
  Vector4,
} from 'three/webgpu';
import { BrdfParameterError } from '../brdf/error.ts';
import type { Parameter, ParameterValue, ParameterValues, Rgb } from '../brdf/model.ts';
import { checkValue, resolveParameters } from '../brdf/values.ts';
import { derivedQuantities } from '../glsl/derived.ts';
import { createEvaluator, type Evaluator } from '../glsl/evaluator.ts';
import type { Model } from '../glsl/model.ts';
import { shaderPrefix } from '../glsl/shader-text.ts';
import { glslFunction } from '../glsl/tsl.ts';
import { AlbedoTable, alwaysRefreshed } from './albedo-table.ts';
import { EnvironmentLightNode } from './environment-light.ts';
import { frameContext, frameContextKeys } from './frame-context.ts';
import { highlightAlpha } from './generic-sampler.ts';
import { BRIGHTEST_HALF } from './half-float.ts';
import { turnTangentWithInstance } from './instance-tangent.ts';
import { BrdfLightingModel } from './lighting-model.ts';
import { type Channel, derivedNodes, type ParameterMap, parameterNodes } from './parameter-nodes.ts';
import { dependsOnTangent, turnsWithTangent } from './tangent-dependence.ts';
import { isOwnNormalMatrix, positionInView, seesCamera, useViewSpace } from './view-space.ts';

/** What else is near lights the surface, even where there are no lamps: three.js must ask the lighting model. */
class NearLightNode extends LightingNode {
  static get type(): string {
    return 'NearLightNode';
  }
}

/** In place of a texture that was taken off. */
const NOTHING = new DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
NOTHING.needsUpdate = true;

/**
 * A three.js material made from any model. It runs under WebGPURenderer, on WebGPU and on WebGL 2.
 *
 * Each parameter of the model is a property of the material, with a texture beside it:
 *
 *     const material = new BrdfMaterial(model, { roughness: 0.3 });
 *     material.roughness = 0.4;            // a number, a boolean, or for colours a THREE.Color
 *     material.roughnessMap = texture;     // value = uniform x texel
 *     material.set('roughness', 0.5).setMap('roughness', texture, 'g');
 *
 * Colours of vertices (`vertexColors`), instances and batches multiply the model's first colour parameter.
 *
 * A parameter whose name three.js uses for something else (such as `name`) is reached by get() and set()
 * alone. Changing a value compiles nothing; adding or removing a texture, or choosing a term, does.
 */
export class BrdfMaterial extends NodeMaterial {
  static override get type(): string {
    return 'BrdfMaterial';
  }

  readonly isBrdfMaterial = true;
  readonly model: Model;
  /** The uniforms, by parameter: numbers, or colours. Set them through set() or the properties. */
  readonly values: Record<string, number | Color> = {};
  /** The textures, by parameter. Set them through setMap() or the properties. */
  readonly maps: Record<string, ParameterMap> = {};
  /** What shaders read, by parameter: a shader that is still being compiled may ask for a texture that is gone by then. */
  readonly sampled: Record<string, Texture> = {};

  normalMap: Texture | null = null;
  /** three.js applies a normal map only if this says which kind it is. */
  normalMapType: NormalMapTypes = TangentSpaceNormalMap;
  normalScale = new Vector2(1, 1);
  bumpMap: Texture | null = null;
  bumpScale = 1;
  aoMap: Texture | null = null;
  aoMapIntensity = 1;
  emissive = new Color(0, 0, 0);
  emissiveIntensity = 1;
  emissiveMap: Texture | null = null;
  alphaMap: Texture | null = null;
  lightMap: Texture | null = null;
  lightMapIntensity = 1;
  /** An environment of the material's own, instead of the scene's. */
  envMap: Texture | null = null;
  envMapIntensity = 1;
  envMapRotation = new Euler();

  /** The directional albedo over n.v; null until the material is first built for light from everywhere. */
  albedoTable: AlbedoTable | null = null;
  private readonly white: Node<'vec4'>;
  private currentTerm = 'BRDF';
  private ownEvaluator: Evaluator | null = null;
  /** How often a number was set, or a colour found changed. */
  private changes = 0;
  /** The values that are colours. */
  private readonly colors: Color[] = [];
  private readonly snapshot: number[] = [];
  private readonly cache = new Map<string, { version: number; term: string; value: unknown }>();

  /** @throws BrdfParameterError for a value that does not suit its parameter, or a parameter the model lacks */
  constructor(model: Model, values: Readonly<Record<string, unknown>> = {}) {
    super();
    this.lights = true;
    this.model = model;
    // three.js multiplies this by the colours of vertices and instances.
    this.white = vec4(1) as unknown as Node<'vec4'>;
    this.colorNode = this.white;
    hide(
      this,
      'model',
      'values',
      'maps',
      'sampled',
      'albedoTable',
      'white',
      'currentTerm',
      'ownEvaluator',
      'changes',
      'colors',
      'snapshot',
      'cache',
    );
    const plain = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, fromColor(value)]));
    const resolved = resolveParameters(model.file, plain);
    for (const parameter of model.parameters) {
      const value = resolved[parameter.name] as ParameterValue;
      if (parameter.type === 'color') {
        const color = new Color(...(value as Rgb));
        this.values[parameter.name] = color;
        this.colors.push(color);
      } else this.values[parameter.name] = Number(value);
      this.defineProperties(parameter);
    }
  }

  /** A parameter's value; colours as three linear numbers. @throws BrdfParameterError if there is none */
  get(name: string): ParameterValue {
    const parameter = this.parameter(name);
    const value = this.values[name] as number | Color;
    if (value instanceof Color) return [value.r, value.g, value.b];
    return parameter.type === 'bool' ? value > 0.5 : value;
  }

  /** Sets a parameter: one uniform. @throws BrdfParameterError for a wrong name or type */
  set(name: string, value: unknown): this {
    const checked = checkValue(this.model.name, this.parameter(name), fromColor(value));
    const current = this.values[name];
    if (current instanceof Color) current.setRGB(...(checked as Rgb));
    else if (current !== Number(checked)) {
      this.values[name] = Number(checked);
      this.changes++;
    }
    return this;
  }

  getMap(name: string): Texture | null {
    this.parameter(name);
    return this.maps[name]?.texture ?? null;
  }

  /**
   * Sets or removes a parameter's texture; the parameter is then its uniform times the texel.
   *
   * @param channel the component that a number or switch is read from
   */
  setMap(name: string, texture: Texture | null, channel: Channel = 'r'): this {
    this.parameter(name);
    const before = this.maps[name];
    if (texture) this.maps[name] = { texture, channel };
    else delete this.maps[name];
    if (texture || before) this.sampled[name] = texture ?? NOTHING;
    if (before?.channel !== this.maps[name]?.channel) this.needsUpdate = true;
    return this;
  }

  /** What is shown: 'BRDF', or one of the model's terms alone. */
  get term(): string {
    return this.currentTerm;
  }

  /** @throws BrdfParameterError if the model has no such term */
  set term(name: string) {
    if (!this.model.terms.includes(name)) {
      throw new BrdfParameterError(
        this.model.name,
        name,
        `no such term; there are ${this.model.terms.join(', ')}`,
      );
    }
    if (name === this.currentTerm) return;
    this.currentTerm = name;
    this.needsUpdate = true;
  }

  /**
   * Counts the changes of parameters. Those of colours, which may be changed in place, are found by comparing; in numbers,
   * without allocating, since every object asks in every frame.
   */
  get valuesVersion(): number {
    const { snapshot, colors } = this;
    let changed = snapshot.length !== 3 * colors.length;
    let i = 0;
    for (const { r, g, b } of colors) {
      if (snapshot[i] !== r || snapshot[i + 1] !== g || snapshot[i + 2] !== b) {
        snapshot[i] = r;
        snapshot[i + 1] = g;
        snapshot[i + 2] = b;
        changed = true;
      }
      i += 3;
    }
    if (changed) this.changes++;
    return this.changes;
  }

  /** The width of the model's highlight, which its generic sampler takes, if it has no sampler of its own. */
  get highlightAlpha(): number {
    if (this.model.hasSampling) return 1;
    return this.cached('highlight', () => highlightAlpha(this.evaluator()));
  }

  /** What the shader derives from the parameters alone, computed here when one has changed. */
  get derived(): readonly (number | Vector2 | Vector3 | Vector4)[] {
    return this.cached('derived', () =>
      derivedQuantities(this.model, this.currentTerm).compute(this.plainValues()).map(toVector),
    );
  }

  /** Whether turning the tangent about the normal changes anything with the present parameters. */
  dependsOnTangent(): boolean {
    if (Object.keys(this.maps).length > 0) return dependsOnTangent(this.model);
    return this.cached('turning', () => turnsWithTangent(this.evaluator(), this.currentTerm));
  }

  override customProgramCacheKey(): string {
    const maps = Object.entries(this.maps).map(([name, { channel }]) => `${name}.${channel}`);
    return [super.customProgramCacheKey(), shaderPrefix(this.model), this.currentTerm, ...maps].join(' ');
  }

  override setupObserver(builder: NodeBuilder): ReturnType<NodeMaterial['setupObserver']> {
    const observer = super.setupObserver(builder);
    // What three.js cannot see change, it must refresh for every object in every frame.
    if (!this.isPlain(builder)) return alwaysRefreshed(observer);
    const watched = observer as unknown as { hasNode: boolean; refreshUniforms: string[] };
    watched.hasNode = false;
    watched.refreshUniforms = [...watched.refreshUniforms, 'valuesVersion'];
    return seesCamera(observer);
  }

  /** Whether all that the material shows follows from three.js' own properties and the parameters' values. */
  private isPlain(builder: NodeBuilder): boolean {
    if (Object.keys(this.maps).length > 0 || this.setupEnvironment(builder) !== null) return false;
    const { context } = builder as unknown as { context: Record<string, unknown> };
    // As three.js' own observer asks, but for the colour that the constructor set.
    const hooks = ['modelViewMatrix', 'getAO', 'getShadow', 'getGI'];
    if ([...hooks, ...frameContextKeys].some((name) => context[name])) return false;
    if (context.modelNormalViewMatrix && !isOwnNormalMatrix(context)) return false;
    return Object.entries(this).every(
      ([name, value]) =>
        !(value as { isNode?: boolean } | null)?.isNode || (name === 'colorNode' && value === this.white),
    );
  }

  override setup(builder: NodeBuilder): void {
    useViewSpace(builder);
    super.setup(builder);
  }

  override setupPositionView(builder: NodeBuilder): Node {
    const { context } = builder as unknown as { context: object };
    return isOwnNormalMatrix(context) ? positionInView() : super.setupPositionView(builder);
  }

  override setupPosition(builder: NodeBuilder): ReturnType<NodeMaterial['setupPosition']> {
    const position = super.setupPosition(builder);
    if (dependsOnTangent(this.model)) turnTangentWithInstance(builder);
    return position;
  }

  override setupEnvironment(builder: NodeBuilder): Node | null {
    const { scene } = builder as unknown as { scene: Scene | null };
    return (this.envMap ?? scene?.environment) ? new EnvironmentLightNode() : null;
  }

  override setupMaterialLightings(builder: NodeBuilder): ReturnType<NodeMaterial['setupMaterialLightings']> {
    const lightings = super.setupMaterialLightings(builder);
    const environment = lightings.find((node) => node instanceof EnvironmentLightNode);
    (builder.context as { brdfEnvironment?: EnvironmentLightNode }).brdfEnvironment =
      environment as EnvironmentLightNode;
    const { tracedLight, rayTracer } = frameContext(builder);
    if (tracedLight || rayTracer) lightings.push(new NearLightNode());
    return lightings;
  }

  override setupLightingModel(builder?: NodeBuilder): BrdfLightingModel {
    const { context } = builder as unknown as { context: { brdfEnvironment?: EnvironmentLightNode } };
    this.albedoTable ??= new AlbedoTable();
    const tint = this.surfaceTint(builder as NodeBuilder);
    // Whether the parameters are the same all over the surface.
    const even = !tint && Object.keys(this.maps).length === 0;
    return new BrdfLightingModel({
      model: this.model,
      term: this.currentTerm,
      parameters: parameterNodes(this.model, this.maps, tint),
      derived: even ? derivedNodes(this.model, this.currentTerm) : null,
      environment: context.brdfEnvironment ?? null,
      hasTable: even,
    });
  }

  /** What a half float cannot hold is as bright as it can: GPUs make infinities of it, or NaN, which filters spread. */
  override setupOutput(builder: NodeBuilder, outputNode: Node): Node {
    const color = super.setupOutput(builder, outputNode) as Node<'vec4'>;
    const { renderer } = builder as unknown as { renderer: Renderer };
    if (renderer.getRenderTarget()?.texture.type !== HalfFloatType) return color;
    return vec4(atMostBrightest(color.rgb), color.a);
  }

  /** Colours of vertices, instances and batches, which multiply the model's first colour; null if there are none. */
  private surfaceTint(builder: NodeBuilder): Node<'vec3'> | null {
    const { object, geometry } = builder as unknown as {
      object: { instanceColor?: unknown; isBatchedMesh?: boolean; _colorsTexture?: unknown };
      geometry: BufferGeometry;
    };
    const vertices = this.vertexColors && geometry.hasAttribute('color');
    const batches = object.isBatchedMesh && object._colorsTexture;
    return vertices || object.instanceColor || batches ? (diffuseColor as unknown as Node<'vec4'>).rgb : null;
  }

  override copy(source: this): this {
    if (source.model !== this.model)
      throw new TypeError(`a ${this.model.name} cannot copy a ${source.model.name}`);
    super.copy(source);
    for (const { name } of this.model.parameters) {
      this.set(name, source.get(name));
      const map = source.maps[name];
      this.setMap(name, map?.texture ?? null, map?.channel);
    }
    this.term = source.term;
    return this;
  }

  override clone(): this {
    // The named classes know their model; their constructors take values alone.
    const named = this.constructor !== BrdfMaterial;
    const copy = named ? new (this.constructor as new () => this)() : new BrdfMaterial(this.model);
    return (copy as this).copy(this);
  }

  override dispose(): void {
    this.albedoTable?.dispose();
    super.dispose();
  }

  /** A value that holds until a parameter or the term changes. */
  private cached<T>(name: string, compute: () => T): T {
    const version = this.valuesVersion;
    let entry = this.cache.get(name);
    if (entry?.version !== version || entry.term !== this.currentTerm) {
      entry = { version, term: this.currentTerm, value: compute() };
      this.cache.set(name, entry);
    }
    return entry.value as T;
  }

  private evaluator(): Evaluator {
    this.ownEvaluator ??= createEvaluator(this.model);
    this.ownEvaluator.set(this.plainValues());
    return this.ownEvaluator;
  }

  private plainValues(): ParameterValues {
    return Object.fromEntries(this.model.parameters.map(({ name }) => [name, this.get(name)]));
  }

  private parameter(name: string): Parameter {
    const parameter = this.model.parameters.find((p) => p.name === name);
    if (parameter) return parameter;
    const names = this.model.parameters.map((p) => p.name).join(', ');
    throw new BrdfParameterError(this.model.name, name, `there is none; there are ${names}`);
  }

  /**
   * Properties for one parameter. They are not enumerable: three.js would take a number that becomes 0,
   * or stops to be, for another kind of material and compile it anew.
   */
  private defineProperties({ name }: Parameter): void {
    if (!(name in this)) {
      Object.defineProperty(this, name, {
        get: () => (this.values[name] instanceof Color ? this.values[name] : this.get(name)),
        set: (value: unknown) => this.set(name, value),
      });
    }
    const map = `${name}Map`;
    if (!(map in this)) {
      Object.defineProperty(this, map, {
        get: () => this.getMap(name),
        set: (texture: Texture | null) => this.setMap(name, texture),
      });
    }
  }
}

/** three.js has made the colour 0 where it is negative or not a number. */
const atMostBrightest = glslFunction(`
  vec3 atMostBrightest(vec3 color) {
    return min(color, vec3(${BRIGHTEST_HALF}.0));
  }
`) as unknown as (color: Node<'vec3'>) => Node<'vec3'>;

function toVector(value: number | readonly number[]): number | Vector2 | Vector3 | Vector4 {
  if (typeof value === 'number') return value;
  const [x = 0, y = 0, z = 0, w = 0] = value;
  return value.length === 2
    ? new Vector2(x, y)
    : value.length === 3
      ? new Vector3(x, y, z)
      : new Vector4(x, y, z, w);
}

/** Keeps fields from three.js's walk over a material's properties. */
function hide(material: BrdfMaterial, ...names: string[]): void {
  for (const name of names) Object.defineProperty(material, name, { enumerable: false });
}

function fromColor(value: unknown): unknown {
  return value instanceof Color ? [value.r, value.g, value.b] : value;
}
