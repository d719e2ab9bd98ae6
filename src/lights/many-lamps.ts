/**
 * Lighting for scenes of many lamps. three.js gives each light code of its own, so that a shader of hundreds takes minutes to
 * compile. Here point and spot lights without shadows, once they are more than a few, are rows of numbers that one loop goes
 * through: what compiles does not depend on how many there are, and a lamp that comes or goes compiles nothing. A pixel looks
 * at those lamps only that may reach its part of the view.
 *
 *     renderer.lighting = new LampLighting();
 */
import {
  buffer,
  cameraProjectionMatrix,
  int,
  ivec2,
  positionView,
  renderGroup,
  texture,
  uniform,
  vec4,
} from 'three/tsl';
import {
  type Camera,
  DataTexture,
  FloatType,
  Light,
  Lighting,
  LightingNode,
  LightsNode,
  type Matrix4,
  NearestFilter,
  type Node,
  type NodeBuilder,
  type NodeFrame,
  NodeUpdateType,
  type PerspectiveCamera,
  RedFormat,
  RGFormat,
  type TextureNode,
  Vector2,
  Vector3,
  type WebGPURenderer,
} from 'three/webgpu';
import { glslFunction } from '../glsl/tsl.ts';
import { repeat } from '../material/statements.ts';
import { Clusters, COLUMNS, type Reach, ROWS, SLICES, sliceScale } from './clusters.ts';
import lampText from './lamp.glsl?raw';
import { LAMP_TEXELS, writeLamp } from './lamp-row.ts';
import { BrdfPointLight } from './point-light.ts';
import { BrdfSpotLight } from './spot-light.ts';

type Float = Node<'float'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;
type Lamp = BrdfPointLight | BrdfSpotLight;

/** As many lamps have code of their own, which is faster for a few. */
const FEW = 8;
/** Lamps that there is room for, at first and at most: 64 bytes each of the 64 KiB that uniforms may have on any machine. */
const ROOM = [256, 1000] as const;
/** Parts of the view that a lamp is in, in the mean; where they are more, some lamps count as everywhere. */
const PARTS = 256;
/** Texels of a lamp's row that are read. */
const READ = 4;

const lampIrradiance = glslFunction(lampText) as unknown as (
  L: Vec3,
  inverseDistance: Float,
  power: Vec4,
  axis: Vec4,
  edge: Vec4,
) => Vec3;

/** One for each renderer. */
export class LampLighting extends Lighting {
  /** Lamps that are to cast shadows have code of their own. Where nothing draws shadows for them, they need none. */
  drawsShadows = true;

  override createNode(lights: Light[] = []): LightsNode {
    return new LampLightsNode(this).setLights(lights);
  }
}

/** What @types/three leaves out. */
interface LightsNodeParts {
  customCacheKey(): number;
}

class LampLightsNode extends LightsNode {
  private readonly lighting: LampLighting;
  private own: Light[] = [];
  private isMany = false;
  /** Private to the engine, too: three.js takes nodes in fields to be parts, whose changes ask for another shader. */
  readonly #many = new ManyLampsNode();

  constructor(lighting: LampLighting) {
    super();
    this.lighting = lighting;
  }

  static get type(): string {
    return 'LampLightsNode';
  }

  override setLights(lights: Light[]): this {
    super.setLights(lights);
    const lamps = lights.filter((light) => this.isOneOfMany(light)).slice(0, ROOM[1]);
    this.isMany = lamps.length > FEW;
    if (this.isMany) this.#many.setLamps(lamps);
    const inLoop = new Set<Light>(lamps);
    this.own = this.isMany ? lights.filter((light) => !inLoop.has(light)) : lights;
    return this;
  }

  /** What has code of its own. */
  override getBuiltinLights(): Light[] {
    return this.own;
  }

  override customCacheKey(): number {
    const key = (LightsNode.prototype as unknown as LightsNodeParts).customCacheKey.call(this);
    // The textures of another scene's lamps, or larger ones, are another shader's.
    return this.isMany ? key + 31 * this.#many.id + this.#many.capacity : key;
  }

  override setupLightsNode(builder: NodeBuilder): LightingNode[] {
    const nodes = super.setupLightsNode(builder);
    return this.isMany ? [...nodes, this.#many] : nodes;
  }

  private isOneOfMany(light: Light): light is Lamp {
    if (light.castShadow && this.lighting.drawsShadows) return false;
    const hasMap = light instanceof BrdfSpotLight && light.map !== null;
    return !hasMap && (light instanceof BrdfPointLight || light instanceof BrdfSpotLight);
  }
}

/** What a shader asks of a light that casts no shadow. */
class Unshadowed extends Light {}

class ManyLampsNode extends LightingNode {
  static get type(): string {
    return 'ManyLampsNode';
  }

  /** Stands for all of them where one light is asked about. */
  readonly light = new Unshadowed();
  capacity = 0;
  private lamps: readonly Lamp[] = [];
  /** In view space: those that are everywhere first. */
  private rows = new Float32Array(0);
  private lists!: DataTexture;
  private readonly ranges = numbers(new Float32Array(2 * COLUMNS * ROWS * SLICES), COLUMNS, RGFormat);
  private clusters!: Clusters;
  private readonly common = uniform(0).setGroup(renderGroup);
  /** Slices for each e-fold of the depth, and the nearest depth. */
  private readonly depths = uniform(new Vector2(1, 1)).setGroup(renderGroup);
  #toLamp: Vec3 | null = null;

  constructor() {
    super();
    this.updateType = NodeUpdateType.RENDER;
  }

  setLamps(lamps: readonly Lamp[]): void {
    this.lamps = lamps;
    if (lamps.length <= this.capacity) return;
    this.lists?.dispose();
    this.capacity = lamps.length <= ROOM[0] ? ROOM[0] : ROOM[1];
    this.rows = new Float32Array(4 * READ * this.capacity);
    this.clusters = new Clusters(PARTS * this.capacity);
    this.lists = numbers(new Float32Array(PARTS * this.capacity), PARTS, RedFormat);
  }

  override update(frame: NodeFrame): undefined {
    const { camera, renderer } = frame as unknown as {
      camera: Camera & Partial<PerspectiveCamera>;
      renderer: WebGPURenderer;
    };
    const { near = 0.1, far = 1000, isPerspectiveCamera } = camera;
    const row = new Float32Array(4 * LAMP_TEXELS);
    // Parts are those of a perspective view: in others every lamp is everywhere.
    const reaches = this.lamps.map((lamp) =>
      isPerspectiveCamera ? reachOf(lamp, camera.matrixWorldInverse) : null,
    );
    this.clusters.fill(reaches, camera.projectionMatrix, near, far);
    for (const [i, lamp] of this.lamps.entries()) {
      writeLamp(lamp, row, 0);
      const at = 4 * READ * i;
      this.rows.set(row.subarray(0, 4 * READ), at);
      place.fromArray(row, 0).applyMatrix4(camera.matrixWorldInverse).toArray(this.rows, at);
      axis
        .fromArray(row, 8)
        .transformDirection(camera.matrixWorldInverse)
        .toArray(this.rows, at + 8);
    }
    this.common.value = this.clusters.common;
    this.depths.value.set(sliceScale(near, far), near);
    upload(renderer, this.lists, this.clusters.entries.subarray(0, this.clusters.used));
    upload(renderer, this.ranges, this.clusters.ranges);
  }

  /** From the fragment to the lamp that the loop is at. */
  getLightVector(): Vec3 {
    return this.#toLamp as Vec3;
  }

  override setup(builder: NodeBuilder): null {
    const rows = buffer(this.rows, 'vec4', READ * this.capacity).setGroup(renderGroup) as unknown as {
      element(i: Node): Vec4;
    };
    const [lists, ranges] = [dataNode(this.lists), dataNode(this.ranges)];
    const P = positionView as Vec3;
    const clip = (cameraProjectionMatrix as unknown as { mul(v: Node): Vec4 }).mul(vec4(P, 1));
    const tile = (ndc: Float, count: number) =>
      ndc
        .mul(0.5)
        .add(0.5)
        .mul(count)
        .floor()
        .clamp(0, count - 1);
    const slice = P.z.negate().max(this.depths.y).div(this.depths.y).log().mul(this.depths.x).floor();
    const column = tile(clip.x.div(clip.w) as Float, COLUMNS);
    const row = tile(clip.y.div(clip.w) as Float, ROWS).add(slice.clamp(0, SLICES - 1).mul(ROWS));
    const range = vec4(0).toVar();
    range.assign(ranges.load(ivec2(int(column), int(row))) as unknown as Vec4);
    const total = this.common.add(range.y) as unknown as Float;
    const { lightsNode } = builder as unknown as {
      lightsNode: { setupDirectLight(builder: NodeBuilder, node: LightingNode, data: object): void };
    };
    repeat(total, (i) => {
      const entry = i.lessThan(this.common).select(i, i.sub(this.common).add(range.x)).toVar() as Float;
      const listed = lists.load(ivec2(int(entry.mod(PARTS)), int(entry.div(PARTS)))) as unknown as Vec4;
      const first = int(listed.x).mul(READ).toVar();
      const texel = (k: number) => rows.element(first.add(k));
      const toLamp = texel(0).xyz.sub(P).toVar() as Vec3;
      const inverseDistance = toLamp.dot(toLamp).inverseSqrt().toVar() as Float;
      const lightDirection = toLamp.mul(inverseDistance).toVar() as Vec3;
      const lightColor = lampIrradiance(lightDirection, inverseDistance, texel(1), texel(2), texel(3));
      this.#toLamp = toLamp;
      lightsNode.setupDirectLight(builder, this, { lightDirection, lightColor: lightColor.toVar() });
    });
    return null;
  }
}

const place = new Vector3();
const axis = new Vector3();

/** The least sphere in view space around a lamp's range, or the part of it in its cone. */
function reachOf(lamp: Lamp, view: Matrix4): Reach | null {
  const range = lamp.distance;
  if (!(range > 0)) return null;
  const centre = new Vector3().setFromMatrixPosition(lamp.matrixWorld);
  const angle = lamp instanceof BrdfSpotLight ? lamp.angle : Math.PI;
  if (angle >= Math.PI / 2) return { centre: centre.applyMatrix4(view), radius: range };
  const isWide = angle > Math.PI / 4;
  const radius = isWide ? range * Math.sin(angle) : range / (2 * Math.cos(angle));
  axis
    .setFromMatrixPosition((lamp as BrdfSpotLight).target.matrixWorld)
    .sub(centre)
    .normalize();
  centre.addScaledVector(axis, isWide ? range * Math.cos(angle) : radius);
  return { centre: centre.applyMatrix4(view), radius };
}

/** Copies numbers to a texture where they are others than it has. */
function upload(renderer: WebGPURenderer, map: DataTexture, values: Float32Array): void {
  const data = map.image.data as Float32Array;
  let i = 0;
  while (i < values.length && values[i] === data[i]) i++;
  if (i === values.length) return;
  data.set(values);
  map.needsUpdate = true;
  // Where nothing but a lamp has changed, three.js does not look at the textures of the objects that it lights.
  renderer.initTexture(map);
}

type Format = typeof RGFormat | typeof RedFormat;

function numbers(data: Float32Array, width: number, format: Format): DataTexture {
  const channels = format === RGFormat ? 2 : 1;
  const map = new DataTexture(
    data as Float32Array<ArrayBuffer>,
    width,
    data.length / channels / width,
    format,
    FloatType,
  );
  map.name = 'many lamps';
  map.minFilter = NearestFilter;
  map.magFilter = NearestFilter;
  map.needsUpdate = true;
  return map;
}

/** Read texel by texel: there is no transform of texture coordinates. */
function dataNode(map: DataTexture): TextureNode {
  const node = texture(map) as TextureNode & { setUpdateMatrix(value: boolean): TextureNode };
  return node.setUpdateMatrix(false);
}
