import { bool, Fn, float, instancedArray, instanceIndex, uint, vec2, vec3 } from 'three/tsl';
import type { Node, WebGPURenderer } from 'three/webgpu';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValue, ParameterValues } from '../../src/brdf/model.ts';
import type { Model } from '../../src/glsl/model.ts';
import { modelFunction, modelPdf, modelSampler } from '../../src/glsl/tsl.ts';

/** Evaluates models in a compute shader, many points at once, in the frame N = +z, X = +x, Y = +y. */

export interface Point {
  readonly l: Vec3;
  readonly v: Vec3;
  readonly u: readonly [number, number];
  readonly parameters: ParameterValues;
}

/** The same point as the GPU will see it. */
export function roundToFloat32(point: Point): Point {
  const round = (v: Vec3): Vec3 => [Math.fround(v[0]), Math.fround(v[1]), Math.fround(v[2])];
  const roundValue = (value: ParameterValue): ParameterValue => {
    if (typeof value === 'boolean') return value;
    return typeof value === 'number' ? Math.fround(value) : round(value);
  };
  return {
    l: round(point.l),
    v: round(point.v),
    u: [Math.fround(point.u[0]), Math.fround(point.u[1])],
    parameters: Object.fromEntries(
      Object.entries(point.parameters).map(([name, value]) => [name, roundValue(value)]),
    ),
  };
}

/** The values of BRDF(), terms, `pdf` (three times the same number) and `sampleL`, by name and point. */
export async function evaluateOnGpu(
  renderer: WebGPURenderer,
  model: Model,
  functions: readonly string[],
  points: readonly Point[],
): Promise<Map<string, Vec3[]>> {
  const packed = points.map((point) => pack(model, point));
  const stride = packed[0]!.length;
  const input = instancedArray(new Float32Array(packed.flat()), 'float');
  const output = instancedArray(points.length * functions.length * 3, 'float');

  const kernel = Fn(() => {
    const first = instanceIndex.mul(uint(stride)).toVar();
    const at = (offset: number) => input.element(first.add(uint(offset)));
    const vector = (offset: number) => vec3(at(offset), at(offset + 1), at(offset + 2)).toVar();
    const [l, v, u] = [vector(0), vector(3), vec2(at(6), at(7)).toVar()];
    const [n, x, y] = [vec3(0, 0, 1).toVar(), vec3(1, 0, 0).toVar(), vec3(0, 1, 0).toVar()];
    let offset = 8;
    const nodes: Record<string, Node> = {};
    for (const { name, type } of model.parameters) {
      if (type === 'color') nodes[name] = vector(offset);
      else nodes[name] = type === 'bool' ? bool(at(offset).greaterThan(0.5)) : float(at(offset)).toVar();
      offset += type === 'color' ? 3 : 1;
    }
    for (const [i, name] of functions.entries()) {
      const value =
        name === 'pdf'
          ? vec3(modelPdf(model, nodes)(l, v, n, x, y))
          : name === 'sampleL'
            ? modelSampler(model, nodes)(u, v, n, x, y)
            : modelFunction(model, name, nodes)(l, v, n, x, y);
      const result = vec3(value).toVar();
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

function pack(model: Model, { l, v, u, parameters }: Point): number[] {
  const values = model.parameters.flatMap(({ name, default: fallback }) => {
    const value = parameters[name] ?? fallback;
    return typeof value === 'object' ? [...value] : [Number(value)];
  });
  return [...l, ...v, ...u, ...values];
}
