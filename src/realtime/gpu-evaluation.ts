/**
 * A model's values at given directions and parameters, in the float32 of the GPU that draws the picture: on both back
 * ends in a fragment shader, as the picture itself, into a row of pixels that are read back.
 */
import { int, ivec2, screenCoordinate, textureLoad, uniform, vec3, vec4 } from 'three/tsl';
import {
  DataTexture,
  FloatType,
  NearestFilter,
  type Node,
  NodeMaterial,
  QuadMesh,
  RenderTarget,
  RGBAFormat,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Parameter, ParameterValues, Rgb } from '../brdf/model.ts';
import type { Vector3 } from '../glsl/evaluator.ts';
import type { Model } from '../glsl/model.ts';
import { modelFunction } from '../glsl/tsl.ts';

/** Unit vectors in the frame n = +z, tangent = +x. */
export interface Query {
  readonly l: Vector3;
  readonly v: Vector3;
  readonly parameters: ParameterValues;
}

/** Queries for one run of the shader: the width that every GPU's textures can have (WebGL 2's least maximum). */
const BATCH = 2048;

/** One term of a model on one renderer; made once, it can be asked any number of times, one after the other. */
export class GpuEvaluation {
  readonly #renderer: WebGPURenderer;
  readonly #layout: Layout;
  /** A column for each query; its numbers from the top, four in a texel. */
  readonly #input: DataTexture;
  readonly #target = new RenderTarget(BATCH, 1, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  readonly #material = new NodeMaterial();
  readonly #quad: QuadMesh;
  #compiled: Promise<void> | null = null;

  constructor(renderer: WebGPURenderer, model: Model, term: string) {
    this.#renderer = renderer;
    this.#layout = layoutOf(model.parameters);
    const texels = Math.ceil(this.#layout.stride / 4);
    const numbers = new Float32Array(4 * BATCH * texels);
    this.#input = new DataTexture(numbers, BATCH, texels, RGBAFormat, FloatType);
    this.#material.fragmentNode = valueNode(model, term, this.#layout, this.#input);
    this.#material.depthTest = false;
    this.#material.depthWrite = false;
    this.#quad = new QuadMesh(this.#material);
  }

  /** Values in the order of the queries. */
  async evaluate(queries: readonly Query[]): Promise<Rgb[]> {
    await this.#compile();
    const values: Rgb[] = [];
    for (let at = 0; at < queries.length; at += BATCH)
      values.push(...(await this.#run(queries.slice(at, at + BATCH))));
    return values;
  }

  dispose(): void {
    this.#input.dispose();
    this.#target.dispose();
    this.#material.dispose();
  }

  /** Without holding up whatever else runs here. */
  #compile(): Promise<void> {
    this.#compiled ??= this.#toTarget(() => this.#renderer.compileAsync(this.#quad, this.#quad.camera));
    return this.#compiled;
  }

  #toTarget<Result>(draw: () => Result): Result {
    const before = this.#renderer.getRenderTarget();
    this.#renderer.setRenderTarget(this.#target);
    const result = draw();
    this.#renderer.setRenderTarget(before);
    return result;
  }

  async #run(queries: readonly Query[]): Promise<Rgb[]> {
    const texels = this.#input.image.data as Float32Array;
    for (const [column, query] of queries.entries()) {
      for (const [i, value] of numbersOf(query, this.#layout).entries())
        texels[4 * (Math.floor(i / 4) * BATCH + column) + (i % 4)] = value;
    }
    this.#input.needsUpdate = true;
    this.#toTarget(() => this.#quad.render(this.#renderer));
    const width = queries.length;
    const read = this.#renderer.readRenderTargetPixelsAsync(this.#target, 0, 0, width, 1);
    const pixels = (await read) as Float32Array;
    return queries.map((_, i) => [pixels[4 * i]!, pixels[4 * i + 1]!, pixels[4 * i + 2]!]);
  }
}

interface Layout {
  /** How many numbers a query has: l, v, then the parameters, a colour as three and a switch as one. */
  readonly stride: number;
  readonly places: readonly { readonly parameter: Parameter; readonly at: number }[];
}

function layoutOf(parameters: readonly Parameter[]): Layout {
  let stride = 6;
  const places = parameters.map((parameter) => {
    const at = stride;
    stride += parameter.type === 'color' ? 3 : 1;
    return { parameter, at };
  });
  return { stride, places };
}

function numbersOf({ l, v, parameters }: Query, { places }: Layout): number[] {
  const values = places.flatMap(({ parameter }) => parameters[parameter.name] as number | boolean | Rgb);
  return [...l, ...v, ...values.map(Number)];
}

function valueNode(model: Model, term: string, { places }: Layout, input: DataTexture): Node<'vec4'> {
  const column = int(screenCoordinate.x);
  const number = (at: number): Node<'float'> => {
    const texel = textureLoad(input, ivec2(column, Math.floor(at / 4)));
    return [texel.x, texel.y, texel.z, texel.w][at % 4] as Node<'float'>;
  };
  const vector = (at: number) => vec3(number(at), number(at + 1), number(at + 2));
  const nodes = Object.fromEntries(
    places.map(({ parameter: { name, type }, at }): [string, Node] => {
      if (type === 'color') return [name, vector(at)];
      return [name, type === 'bool' ? number(at).notEqual(0) : number(at)];
    }),
  );
  // As uniforms, or a compiler folds the constant frame in and computes something slightly different.
  const axis = (x: number, y: number, z: number) => vec3(uniform(x), uniform(y), uniform(z));
  const f = modelFunction(model, term, nodes)(
    vector(0),
    vector(3),
    axis(0, 0, 1),
    axis(1, 0, 0),
    axis(0, 1, 0),
  );
  return vec4(f, 1);
}
