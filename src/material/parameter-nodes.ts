import { materialReference } from 'three/tsl';
import type { Node, Texture } from 'three/webgpu';
import type { Parameter } from '../brdf/model.ts';
import { derivedQuantities } from '../glsl/derived.ts';
import type { Model } from '../glsl/model.ts';
import type { ParameterNodes } from '../glsl/tsl.ts';

/** Which component of a texture a number or switch is read from. */
export type Channel = 'r' | 'g' | 'b' | 'a';

export interface ParameterMap {
  readonly texture: Texture;
  readonly channel: Channel;
}

/**
 * A node for each parameter: the uniform, times the texel where there is a map.
 *
 * The nodes refer to the material by the path of a property, not by object: three.js then shares the
 * compiled shader among all materials of the model, and a changed value is a changed uniform.
 *
 * @param tint multiplies the model's first colour
 */
export function parameterNodes(
  model: Model,
  maps: Readonly<Record<string, ParameterMap>>,
  tint: Node<'vec3'> | null = null,
): ParameterNodes {
  const nodes = Object.fromEntries(
    model.parameters.map((parameter) => [parameter.name, parameterNode(parameter, maps[parameter.name])]),
  );
  const tinted = model.parameters.find(({ type }) => type === 'color');
  if (tint && tinted) nodes[tinted.name] = (nodes[tinted.name] as Node<'vec3'>).mul(tint);
  return nodes;
}

/** Nodes for what the material derives from its parameters (BrdfMaterial.derived), in its order. */
export function derivedNodes(model: Model, term: string): Node[] {
  const types = ['float', 'vec2', 'vec3', 'vec4'];
  return derivedQuantities(model, term).sizes.map(
    (size, i) => materialReference(`derived.${i}`, types[size - 1] as 'float') as unknown as Node,
  );
}

function parameterNode(parameter: Parameter, map: ParameterMap | undefined): Node {
  const { name, type } = parameter;
  const texel = map && (materialReference(`sampled.${name}`, 'texture') as unknown as Node<'vec4'>);
  if (type === 'color') {
    const value = materialReference(`values.${name}`, 'color') as unknown as Node<'vec3'>;
    return texel ? value.mul(texel.rgb) : value;
  }
  const value = materialReference(`values.${name}`, 'float') as unknown as Node<'float'>;
  const scaled = texel ? value.mul(texel[map.channel] as Node<'float'>) : value;
  return type === 'bool' ? scaled.greaterThan(0.5) : scaled;
}
