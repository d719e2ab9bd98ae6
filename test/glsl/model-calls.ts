import { bool, vec2, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Model } from '../../src/glsl/model.ts';
import { modelFunction, modelPdf, modelSampler } from '../../src/glsl/tsl.ts';

/**
 * The functions of a model as nodes, their arguments read from numbers that packPoint() has laid out, in the
 * frame N = +z, X = +x, Y = +y. A density comes three times, so that all are vectors.
 */
export function modelCalls(
  model: Model,
  at: (offset: number) => Node<'float'>,
): (name: string) => Node<'vec3'> {
  const vector = (offset: number) => vec3(at(offset), at(offset + 1), at(offset + 2)).toVar();
  const [l, v, u] = [vector(0), vector(3), vec2(at(6), at(7)).toVar()];
  const frame = [vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)] as const;
  const nodes: Record<string, Node> = {};
  let offset = 8;
  for (const { name, type } of model.parameters) {
    if (type === 'color') nodes[name] = vector(offset);
    else nodes[name] = type === 'bool' ? bool(at(offset).greaterThan(0.5)) : at(offset).toVar();
    offset += type === 'color' ? 3 : 1;
  }
  return (name) => {
    if (name === 'pdf') return vec3(modelPdf(model, nodes)(l, v, ...frame));
    if (name === 'sampleL') return modelSampler(model, nodes)(u, v, ...frame);
    return modelFunction(model, name, nodes)(l, v, ...frame);
  };
}
