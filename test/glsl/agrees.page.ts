import { float, int, ivec2, screenCoordinate, textureLoad, vec4 } from 'three/tsl';
import {
  DataTexture,
  FloatType,
  type Node,
  NodeMaterial,
  QuadMesh,
  RenderTarget,
  RGBAFormat,
  WebGPURenderer,
} from 'three/webgpu';
import { shippedModels } from '../../models/index.ts';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { Model } from '../../src/glsl/model.ts';
import { type Comparison, compare, functionsOf, type Point, packPoint, randomPoints } from './comparison.ts';
import { modelCalls } from './model-calls.ts';

/** Evaluates every model on WebGL 2, a pixel for each point, and compares it with float64. */
export default async function agreement(side: number): Promise<Record<string, Comparison>> {
  const renderer = new WebGPURenderer({ forceWebGL: true });
  await renderer.init();
  const comparisons: Record<string, Comparison> = {};
  for (const [name, model] of shippedModels) {
    const points = randomPoints(model, side * side);
    comparisons[name] = compare(model, points, await evaluate(renderer, model, points, side));
  }
  renderer.dispose();
  return comparisons;
}

async function evaluate(renderer: WebGPURenderer, model: Model, points: readonly Point[], side: number) {
  // A point is a row of texels; the row's number is the pixel's.
  const packed = points.map((point) => packPoint(model, point));
  const texels = Math.ceil(packed[0]!.length / 4);
  const data = new Float32Array(side * texels * side * 4);
  for (const [i, row] of packed.entries()) data.set(row, i * texels * 4);
  const input = new DataTexture(data, side * texels, side, RGBAFormat, FloatType);
  input.needsUpdate = true;
  const target = new RenderTarget(side, side, { type: FloatType, depthBuffer: false });

  const pixel = ivec2(screenCoordinate.xy);
  const at = (offset: number): Node<'float'> => {
    const texel = textureLoad(input, ivec2(pixel.x.mul(int(texels)).add(int(offset >> 2)), pixel.y));
    return [texel.x, texel.y, texel.z, texel.w][offset & 3] as unknown as Node<'float'>;
  };
  const call = modelCalls(model, at);

  const results = new Map<string, Vec3[]>();
  for (const name of functionsOf(model)) {
    const material = new NodeMaterial();
    // The number of the point goes along: rows may come back in either order.
    const index = float(pixel.y.mul(int(side)).add(pixel.x));
    material.fragmentNode = vec4(call(name), index);
    renderer.setRenderTarget(target);
    new QuadMesh(material).render(renderer);
    const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, side, side);
    const values: Vec3[] = [];
    for (let i = 0; i < side * side * 4; i += 4) {
      values[pixels[i + 3] as number] = [pixels[i]!, pixels[i + 1]!, pixels[i + 2]!] as Vec3;
    }
    results.set(name, values);
    material.dispose();
  }
  target.dispose();
  input.dispose();
  return results;
}
