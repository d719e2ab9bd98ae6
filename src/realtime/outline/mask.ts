/** Which parts of a picture meshes cover, whatever is in front of them: red says it of the one set, green of the other. */
import { uniform, vec4 } from 'three/tsl';
import {
  AddEquation,
  type BufferGeometry,
  CustomBlending,
  DoubleSide,
  Matrix4,
  type Mesh,
  type Node,
  NodeMaterial,
  OneFactor,
  PerspectiveCamera,
  RenderTarget,
  RGFormat,
  Scene,
  type Texture,
  UnsignedByteType,
  Vector2,
  Vector3,
  type WebGPURenderer,
} from 'three/webgpu';
import { Instances } from '../frame/instances.ts';
import type { Rectangle } from './screen-bounds.ts';

/** For each pixel the share of it that is covered, in steps of a quarter. */
export class CoverageMask {
  readonly #target = new RenderTarget(1, 1, {
    format: RGFormat,
    type: UnsignedByteType,
    samples: 4,
    depthBuffer: false,
  });
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera();
  readonly #materials = [maskMaterial(1, 0), maskMaterial(0, 1)] as const;
  /** A mesh has one parent, and the scene that it is in has it: these stand for the meshes of a geometry here, one for each set. */
  readonly #instances = new Map<BufferGeometry, readonly [Instances, Instances]>();

  constructor() {
    this.#target.texture.name = 'coverage';
    // Both are given theirs.
    this.#scene.matrixWorldAutoUpdate = false;
    this.#camera.matrixWorldAutoUpdate = false;
  }

  get texture(): Texture {
    return this.#target.texture;
  }

  /** Says which meshes there are, with up to date matrices; with none, nothing of those before is kept. */
  follow(red: readonly Mesh[], green: readonly Mesh[]): void {
    if (red.length + green.length === 0 && this.#instances.size > 0) this.#target.dispose();
    const [reds, greens] = [byGeometry(red), byGeometry(green)];
    for (const [geometry, [ofRed, ofGreen]] of this.#instances) {
      // three.js then lets go of what it draws it with.
      if (!reds.has(geometry)) ofRed.dispose();
      if (!greens.has(geometry)) ofGreen.dispose();
      if (!reds.has(geometry) && !greens.has(geometry)) this.#instances.delete(geometry);
    }
    this.#scene.clear();
    for (const [i, sets] of [reds, greens].entries())
      for (const [geometry, meshes] of sets) this.#place(geometry, meshes, i as 0 | 1);
  }

  #place(geometry: BufferGeometry, meshes: readonly Mesh[], color: 0 | 1): void {
    const [red, green] = this.#materials;
    const both = this.#instances.get(geometry) ?? [
      new Instances(geometry, red),
      new Instances(geometry, green),
    ];
    this.#instances.set(geometry, both);
    both[color].place(meshes, new Vector3().setFromMatrixPosition(meshes[0]!.matrixWorld));
    this.#scene.add(both[color].meshFor(meshes.length));
  }

  /** @param part of a canvas of that size, which the camera sees */
  render(
    three: WebGPURenderer,
    camera: PerspectiveCamera,
    canvas: { readonly width: number; readonly height: number },
    part: Rectangle,
  ): void {
    this.#target.setSize(part.width, part.height);
    const own = this.#camera;
    own.coordinateSystem = camera.coordinateSystem;
    own.matrixWorld.copy(camera.matrixWorld);
    own.matrixWorldInverse.copy(camera.matrixWorldInverse);
    own.near = camera.near;
    own.far = camera.far;
    own.projectionMatrix.multiplyMatrices(enlarging(part, canvas), camera.projectionMatrix);
    own.projectionMatrixInverse.copy(own.projectionMatrix).invert();
    const previous = three.getRenderTarget();
    three.setRenderTarget(this.#target);
    three.render(this.#scene, own);
    three.setRenderTarget(previous);
    for (const both of this.#instances.values()) for (const instances of both) instances.tidy();
  }

  dispose(): void {
    this.follow([], []);
    for (const material of this.#materials) material.dispose();
  }
}

function byGeometry(meshes: readonly Mesh[]): Map<BufferGeometry, Mesh[]> {
  const sets = new Map<BufferGeometry, Mesh[]>();
  for (const mesh of meshes) {
    const set = sets.get(mesh.geometry);
    if (set) set.push(mesh);
    else sets.set(mesh.geometry, [mesh]);
  }
  return sets;
}

/** Of clip space: what is in the part becomes all of the picture. */
function enlarging(
  { x, y, width, height }: Rectangle,
  canvas: { readonly width: number; readonly height: number },
): Matrix4 {
  // In normalised device coordinates, whose y goes up.
  const left = (2 * x) / canvas.width - 1;
  const top = 1 - (2 * y) / canvas.height;
  const [scaleX, scaleY] = [canvas.width / width, canvas.height / height];
  const matrix = new Matrix4().makeScale(scaleX, scaleY, 1);
  matrix.elements[12] = -1 - left * scaleX;
  matrix.elements[13] = 1 - top * scaleY;
  return matrix;
}

/** Counts up to full coverage; of front and back alike. */
function maskMaterial(red: number, green: number): NodeMaterial {
  const material = new NodeMaterial();
  material.name = 'coverage';
  material.fragmentNode = vec4(uniform(new Vector2(red, green)) as Node<'vec2'>, 0, 0);
  material.side = DoubleSide;
  material.depthTest = false;
  material.depthWrite = false;
  material.blending = CustomBlending;
  material.blendEquation = AddEquation;
  material.blendSrc = OneFactor;
  material.blendDst = OneFactor;
  return material;
}
