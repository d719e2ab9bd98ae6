import { Fn, instanceIndex, storage, uniform, vec3 } from 'three/tsl';
import { type Node, StorageBufferAttribute } from 'three/webgpu';
import type { Parameter, Rgb } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';
import { modelFunction } from '../../glsl/tsl.ts';
import type { NodeRenderer } from '../node-renderer.ts';
import type { Backend, Query } from './query.ts';

/** Queries for one run of the shader; more are done in several runs. */
const BATCH = 4096;

/**
 * The model's TSL node in a compute shader, in float32. Each query is a row of numbers in one buffer: l, v,
 * then the parameters, a colour as three numbers and a switch as one.
 */
export function gpuBackend(model: Model, term: string, { renderer }: NodeRenderer): Backend {
  const layout = layoutOf(model.parameters);
  const input = new StorageBufferAttribute(new Float32Array(BATCH * layout.stride), 1);
  const output = new StorageBufferAttribute(new Float32Array(BATCH * 3), 1);
  const kernel = createKernel(model, term, layout, input, output);

  const runBatch = async (queries: readonly Query[]): Promise<Rgb[]> => {
    const rows = input.array as Float32Array;
    queries.forEach((query, i) => {
      rows.set(rowOf(query, layout), i * layout.stride);
    });
    input.needsUpdate = true;
    await renderer.computeAsync(kernel);
    const values = new Float32Array(await renderer.getArrayBufferAsync(output));
    return queries.map((_, i) => [values[i * 3]!, values[i * 3 + 1]!, values[i * 3 + 2]!]);
  };

  return async (queries) => {
    const results: Rgb[] = [];
    for (let at = 0; at < queries.length; at += BATCH) {
      results.push(...(await runBatch(queries.slice(at, at + BATCH))));
    }
    return results;
  };
}

interface Layout {
  /** Numbers in a row. */
  stride: number;
  columns: readonly { parameter: Parameter; at: number }[];
}

function layoutOf(parameters: readonly Parameter[]): Layout {
  let stride = 6;
  const columns = parameters.map((parameter) => {
    const at = stride;
    stride += parameter.type === 'color' ? 3 : 1;
    return { parameter, at };
  });
  return { stride, columns };
}

function rowOf({ l, v, parameters }: Query, { columns }: Layout): number[] {
  return [
    ...l,
    ...v,
    ...columns.flatMap(({ parameter }) => parameters[parameter.name] as number | Rgb).map(Number),
  ];
}

function createKernel(
  model: Model,
  term: string,
  { stride, columns }: Layout,
  input: StorageBufferAttribute,
  output: StorageBufferAttribute,
) {
  const rows = storage(input, 'float', input.count).toReadOnly();
  const results = storage(output, 'float', output.count);
  return Fn(() => {
    const number = (at: number) =>
      rows.element(instanceIndex.mul(stride).add(at)) as unknown as Node<'float'>;
    const vector = (at: number) => vec3(number(at), number(at + 1), number(at + 2));
    const parameterNode = (type: Parameter['type'], at: number): Node => {
      if (type === 'color') return vector(at).toVar();
      return type === 'bool' ? number(at).notEqual(0).toVar() : number(at).toVar();
    };
    const nodes = Object.fromEntries(
      columns.map(({ parameter, at }) => [parameter.name, parameterNode(parameter.type, at)]),
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
    const value = f.toVar();
    const result = instanceIndex.mul(3);
    results.element(result).assign(value.x);
    results.element(result.add(1)).assign(value.y);
    results.element(result.add(2)).assign(value.z);
  })().compute(BATCH);
}
