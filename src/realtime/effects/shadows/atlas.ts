/**
 * All maps of all lights: squares of one texture, since a shader may have no more than 16 textures on any machine. A texel
 * is the distance in metres from the map's camera; from a plane, if the map is of a parallel light.
 */
import { float, positionView, vec4 } from 'three/tsl';
import {
  AlwaysDepth,
  type Camera,
  FloatType,
  type Mesh,
  NearestFilter,
  type Node,
  NodeMaterial,
  QuadMesh,
  RedFormat,
  RenderTarget,
  type Scene,
  Vector3,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Caster } from './casters.ts';
import { CastingMaterials } from './casting-materials.ts';
import type { Tile } from './rows.ts';
import { castingSide } from './sides.ts';

/** Where nothing is: farther than anything, and its square is a float32. */
export const NOTHING = 1e15;

/** Texels along a side that every GPU has, and what is not to be exceeded: 128 MiB with the depth buffer. */
const MAX_SIDE = 4096;

export class ShadowAtlas {
  readonly target: RenderTarget;
  readonly tiles: readonly Tile[];
  readonly #clear = new QuadMesh(new NodeMaterial());
  readonly #materials = new CastingMaterials<'parallel' | 'central'>((side, kind) => {
    const material = new NodeMaterial();
    material.name = 'shadows';
    material.side = side;
    const P = positionView as Node<'vec3'>;
    const distance = kind === 'parallel' ? P.z.negate() : P.length();
    // Its alpha is for what cuts holes.
    material.colorNode = vec4(distance, 0, 0, 1) as unknown as NodeMaterial['colorNode'];
    return material;
  });

  /** @param sizes of the maps' squares, in texels; all are halved until they fit */
  constructor(sizes: readonly number[]) {
    let packed = pack(sizes);
    for (let i = 1; packed === null; i++) packed = pack(sizes.map((size) => Math.max(1, size >> i)));
    this.tiles = packed.tiles;
    this.target = new RenderTarget(packed.width, packed.height, {
      format: RedFormat,
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    this.target.texture.name = 'shadows';
    const clear = this.#clear.material as NodeMaterial;
    clear.name = 'shadows clear';
    clear.fragmentNode = float(NOTHING);
    clear.depthNode = float(1);
    clear.depthFunc = AlwaysDepth;
    clear.depthWrite = true;
  }

  /**
   * Draws a map.
   *
   * @param isParallel whether the camera's rays are
   * @param casts the meshes that are drawn
   */
  draw(
    three: WebGPURenderer,
    scene: Scene,
    camera: Camera,
    tile: Tile,
    isParallel: boolean,
    casts: readonly Caster[],
  ): void {
    const { background } = scene;
    const meshes = new Set(casts.map(({ mesh }) => mesh));
    const { autoClear } = three;
    const before = three.getRenderTarget();
    const draw = three.getRenderObjectFunction();
    three.autoClear = false;
    scene.background = null;
    this.target.viewport.set(tile.x, tile.y, tile.size, tile.size);
    three.setRenderTarget(this.target);
    this.#clear.render(three);
    three.setRenderObjectFunction((object, ofScene, ofCamera, geometry, material, ...rest) => {
      if (!meshes.has(object as Mesh)) return;
      const side = castingSide(material, geometry, isParallel || isOutside(object as Mesh, camera));
      const casting = this.#materials.of(material, side, isParallel ? 'parallel' : 'central');
      three.renderObject(object, ofScene, ofCamera, geometry, casting, ...rest);
    });
    three.render(scene, camera);
    three.setRenderObjectFunction(draw);
    three.setRenderTarget(before);
    three.autoClear = autoClear;
    scene.background = background;
  }

  dispose(): void {
    this.target.dispose();
    (this.#clear.material as NodeMaterial).dispose();
    this.#materials.dispose();
  }
}

/** Whether a camera is not within a mesh's bounds. */
function isOutside({ geometry, matrixWorld }: Mesh, camera: Camera): boolean {
  const place = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  return !geometry.boundingBox?.containsPoint(place.applyMatrix4(matrixWorld.clone().invert()));
}

interface Packed {
  readonly width: number;
  readonly height: number;
  readonly tiles: readonly Tile[];
}

/** Squares on shelves, the largest first; null where they do not fit. */
function pack(sizes: readonly number[]): Packed | null {
  const area = sizes.reduce((sum, size) => sum + size * size, 0);
  const largest = Math.max(1, ...sizes);
  const width = Math.min(MAX_SIDE, Math.max(largest, 2 ** Math.ceil(Math.log2(Math.sqrt(area || 1)))));
  const tiles: Tile[] = [];
  const order = sizes.map((_, i) => i).sort((a, b) => sizes[b]! - sizes[a]!);
  let [x, y, shelf] = [0, 0, 0];
  for (const i of order) {
    const size = sizes[i] as number;
    if (x + size > width) [x, y, shelf] = [0, y + shelf, 0];
    tiles[i] = { x, y, size };
    x += size;
    shelf = Math.max(shelf, size);
  }
  const height = Math.max(1, y + shelf);
  return largest > MAX_SIDE || height > MAX_SIDE ? null : { width, height, tiles };
}
