/**
 * What objects keep off the ground of the sky's light: a map of the ground. On a plane the shadow of a direction is a
 * projection, so that the objects are drawn onto the map along each of many directions, and what they cover is summed up by
 * colour: exact for each direction, whatever the objects' shapes, and more directions with every frame. Where things touch the
 * ground all directions have one edge, which would be as coarse as the texels: so each is drawn with the map moved within a texel.
 */
import { float, texture, uniform, vec4 } from 'three/tsl';
import {
  AlwaysDepth,
  HalfFloatType,
  LinearFilter,
  Matrix4,
  type Mesh,
  type Node,
  NodeMaterial,
  QuadMesh,
  RenderTarget,
  type Scene,
  Vector3,
  Vector4,
  WebGLCoordinateSystem,
  type WebGPURenderer,
} from 'three/webgpu';
import { luminance } from '../../color/rec709.ts';
import type { Caster } from '../effects/shadows/casters.ts';
import { mapCamera } from '../effects/shadows/map-camera.ts';
import { radicalInverse } from '../radical-inverse.ts';
import { type Bounds, topOf } from './place.ts';
import { ProjectedMaterials } from './projected-materials.ts';
import type { SkyLight } from './sky-light.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** Texels along each side. */
const SIDE = 512;
/** Directions after which nothing is gained that could be seen. */
const DIRECTIONS = 256;
/**
 * What the map's sums are counted in: half floats hold sums of these up to 512 exactly. Colours as they are would be rounded
 * with each direction, always the same way, which tints deep shadows.
 */
const STEP = 1 / 4;
/** Beside the objects the map has as much as this many times their height: a ball's shadow is below 1 % there. */
const MARGIN = 3;
/** The outer part of the map in which shadows fade, so that none ends at an edge. */
const RIM = 0.15;
/** Meshes and triangles that a frame may draw for it, and directions at least and at most. */
const MESHES_PER_FRAME = 2048;
const TRIANGLES_PER_FRAME = 4e6;
const PER_FRAME = [2, 32] as const;

export class SkyShadow {
  readonly #sum = new RenderTarget(SIDE, SIDE, {
    type: HalfFloatType,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
  });
  readonly #materials = new ProjectedMaterials();
  readonly #clear = new QuadMesh(new NodeMaterial());
  /** x and z of the map's middle, and half its extent along both. */
  readonly #region = uniform(new Vector4(0, 0, 1, 1));
  /** One over the sum of the directions' colours; 0 while there is none. */
  readonly #unit = uniform(new Vector3());
  readonly #weights = new Vector3();
  /** By how much the colours of the directions so far were more than was counted. */
  readonly #owed = new Vector3();
  #height = 0;
  #top = 0;
  #casts: ReadonlySet<Mesh> = new Set();
  #perFrame = 1;
  #done = DIRECTIONS;

  constructor() {
    this.#sum.texture.name = 'sky shadow';
    const clear = this.#clear.material as NodeMaterial;
    clear.name = 'sky shadow clear';
    clear.fragmentNode = vec4(0);
    clear.depthNode = float(1);
    clear.depthFunc = AlwaysDepth;
    clear.depthWrite = true;
  }

  /** Further frames would have more directions. */
  get unsettled(): boolean {
    return this.#done < DIRECTIONS;
  }

  /** Begins anew: the objects, the ground or the sky are not as they were. */
  restart(casters: readonly Caster[], bounds: Bounds, height: number): void {
    const above = casters.filter((caster) => topOf(caster) > height);
    this.#casts = new Set(above.map(({ mesh }) => mesh));
    this.#height = height;
    this.#top = Math.max(bounds.high[1] - height, 1e-6);
    const [x, z] = [0, 2].map((i) => (bounds.low[i]! + bounds.high[i]!) / 2) as [number, number];
    const reach = (i: number) => (bounds.high[i]! - bounds.low[i]!) / 2 + MARGIN * this.#top;
    this.#region.value.set(x, z, reach(0), reach(2));
    const triangles = above.reduce((sum, { mesh: { geometry } }) => {
      return sum + (geometry.index?.count ?? geometry.getAttribute('position').count) / 3;
    }, 1);
    const affordable = Math.min(
      MESHES_PER_FRAME / Math.max(above.length, 1),
      TRIANGLES_PER_FRAME / triangles,
    );
    this.#perFrame = Math.floor(Math.min(Math.max(affordable, PER_FRAME[0]), PER_FRAME[1]));
    this.#unit.value.set(0, 0, 0);
    this.#weights.set(0, 0, 0);
    this.#owed.set(0, 0, 0);
    this.#done = this.#casts.size === 0 ? DIRECTIONS : 0;
  }

  /** Draws some more directions. The scene's world matrices are up to date. */
  draw(three: WebGPURenderer, scene: Scene, sky: SkyLight): void {
    if (!this.unsettled) return;
    const { background } = scene;
    const { autoClear } = three;
    const before = three.getRenderTarget();
    const draw = three.getRenderObjectFunction();
    three.autoClear = false;
    scene.background = null;
    three.setRenderTarget(this.#sum);
    if (this.#done === 0) this.#clear.render(three);
    three.setRenderObjectFunction((object, ofScene, ofCamera, geometry, material, ...rest) => {
      if (!this.#casts.has(object as Mesh)) return;
      const projected = this.#materials.for(material, object as Mesh);
      three.renderObject(object, ofScene, ofCamera, geometry, projected, ...rest);
    });
    for (let i = 0; i < this.#perFrame && this.unsettled; i++) this.#drawDirection(three, scene, sky);
    three.setRenderObjectFunction(draw);
    three.setRenderTarget(before);
    three.autoClear = autoClear;
    scene.background = background;
    const [r, g, b] = this.#weights.toArray().map((weight) => (weight > 0 ? 1 / weight : 0)) as [
      number,
      number,
      number,
    ];
    this.#unit.value.set(r, g, b);
  }

  #drawDirection(three: WebGPURenderer, scene: Scene, sky: SkyLight): void {
    const found = sky.direction(this.#done);
    if (found === null) {
      this.#done = DIRECTIONS;
      return;
    }
    const { color, depth } = this.#materials;
    this.#count(color.value, found.color, sky);
    depth.value = 1 - (this.#done + 1) / (DIRECTIONS + 1);
    const projection = this.#projection(found.direction, three);
    three.render(scene, mapCamera(new Matrix4(), projection, three.coordinateSystem));
    this.#weights.add(color.value);
    this.#done += 1;
  }

  /** A direction's colour as parts of all light, whose mean is 1, in whole steps; what is left is passed on to the next direction. */
  #count(counted: Vector3, color: readonly [number, number, number], { irradiance }: SkyLight): void {
    const all = irradiance.toArray() as [number, number, number];
    const bright = luminance(all);
    const parts = color.map((value, c) => (all[c]! > 0 ? (value * bright) / all[c]! : 0));
    this.#owed.add(counted.fromArray(parts));
    counted.copy(this.#owed).divideScalar(STEP).round().multiplyScalar(STEP);
    this.#owed.sub(counted);
  }

  /** The part of the sky's light that is kept off a place, by channel. @param place x and z */
  kept(place: Vec2): Vec3 {
    const at = place
      .sub(this.#region.xy as Vec2)
      .div(this.#region.zw as Vec2)
      .toVar() as Vec2;
    const sum = texture(this.#sum.texture) as unknown as { sample(at: Node): Node<'vec4'> };
    const from = at.abs().toVar() as Vec2;
    const rim = from.x.max(from.y).oneMinus().div(RIM).clamp(0, 1) as Float;
    return sum.sample(at.mul(0.5).add(0.5)).rgb.mul(this.#unit).mul(rim) as Vec3;
  }

  dispose(): void {
    this.#sum.dispose();
    this.#materials.dispose();
    (this.#clear.material as NodeMaterial).dispose();
  }

  /**
   * From the world along a direction onto the map, as seen from above: x to the right, z down. What is below the ground is
   * cut off.
   */
  #projection({ x, y, z }: Vector3, { coordinateSystem }: WebGPURenderer): Matrix4 {
    const [cx, cz, ex, ez] = this.#region.value.toArray() as [number, number, number, number];
    const h = this.#height;
    const [a, b] = [x / y, z / y];
    // Higher than anything, so that nothing is cut off there.
    const depth = 0.5 / this.#top;
    // The first point of the sequence is a corner: it begins with the second.
    const [jx, jy] = [2, 3].map((base) => (2 * radicalInverse(this.#done + 1, base) - 1) / SIDE) as [
      number,
      number,
    ];
    const [scale, shift] = coordinateSystem === WebGLCoordinateSystem ? [2, -1] : [1, 0];
    // biome-ignore format: a matrix, row by row
    return new Matrix4().set(
      1 / ex, -a / ex, 0, (a * h - cx) / ex + jx,
      0, b / ez, -1 / ez, (cz - b * h) / ez + jy,
      0, scale * depth, 0, shift - scale * depth * h,
      0, 0, 0, 1,
    );
  }
}
