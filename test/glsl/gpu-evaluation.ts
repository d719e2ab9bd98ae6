import { Fn, instancedArray, instanceIndex, uint } from 'three/tsl';
import type { WebGPURenderer } from 'three/webgpu';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { Model } from '../../src/glsl/model.ts';
import { type Point, packPoint } from './comparison.ts';
import { modelCalls } from './model-calls.ts';

/** The values of a model's functions (see modelCalls) by name and point, computed in one compute shader. */
export async function evaluateOnGpu(
  renderer: WebGPURenderer,
  model: Model,
  functions: readonly string[],
  points: readonly Point[],
): Promise<Map<string, Vec3[]>> {
  const packed = points.map((point) => packPoint(model, point));
  const stride = packed[0]!.length;
  const input = instancedArray(new Float32Array(packed.flat()), 'float');
  const output = instancedArray(points.length * functions.length * 3, 'float');

  const kernel = Fn(() => {
    const first = instanceIndex.mul(uint(stride)).toVar();
    const at = (offset: number) => input.element(first.add(uint(offset)));
    const call = modelCalls(model, at);
    for (const [i, name] of functions.entries()) {
      const result = call(name).toVar();
      const target = instanceIndex.mul(uint(functions.length)).add(uint(i)).mul(uint(3)).toVar();
      for (const [c, component] of [result.x, result.y, result.z].entries()) {
        output.element(target.add(uint(c))).assign(component);
      }
    }
  })().compute(points.length);

  await renderer.computeAsync(kernel);
  const values = new Float32Array(await renderer.getArrayBufferAsync(output.value));
  return new Map(
    functions.map((name, f) => [
      name,
      points.map((_, i): Vec3 => {
        const first = (i * functions.length + f) * 3;
        return [values[first]!, values[first + 1]!, values[first + 2]!];
      }),
    ]),
  );
}
