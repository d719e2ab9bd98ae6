import { texture } from 'three/tsl';
import { CodeNode, DataTexture, FloatType, Node, type NodeBuilder, RGBAFormat } from 'three/webgpu';
import { checkProgram } from './check.ts';
import { DATA_WIDTH } from './emit.ts';
import { splitByLight } from './hoist.ts';
import type { FunctionIR, Variable } from './ir.ts';
import { findFunction, type Model } from './model.ts';
import { parseGlsl } from './parser.ts';
import { emitFunction, type ShadingLanguage, shaderPrefix, textPrefix } from './shader-text.ts';
import { tokenize } from './tokens.ts';
import { TABLE } from './types.ts';

/**
 * Models as TSL nodes. A call of a model is one node; the function's text, in the language of the builder
 * that asks, is emitted once per shader. Text rather than a node per operation: see
 * docs/decisions/glsl-front-end.md.
 */

type FloatNode = Node<'float'>;
type Vector2Node = Node<'vec2'>;
type Vector3Node = Node<'vec3'>;

/** A node for each parameter of a model: uniforms, texels, or any other. */
export type ParameterNodes = Readonly<Record<string, Node>>;

/** What @types/three leaves out of NodeBuilder. */
interface BuilderFormat {
  format(snippet: string, fromType: string, toType: string): string;
}

function languageOf(builder: NodeBuilder): ShadingLanguage {
  // The class name does not survive minification; this flag does.
  const { backend } = builder.renderer as unknown as { backend: { isWebGPUBackend?: boolean } };
  return backend.isWebGPUBackend === true ? 'wgsl' : 'glsl';
}

/** Global code in both languages. */
class TextNode extends CodeNode {
  private readonly text: (language: ShadingLanguage) => string;

  constructor(text: (language: ShadingLanguage) => string, includes: CodeNode[] = []) {
    super('', includes);
    this.text = text;
  }

  override generate(builder: NodeBuilder): string {
    this.code = this.text(languageOf(builder));
    return super.generate(builder) as string;
  }
}

/** Helpers that several functions need: one node for each text, so that a shader has each once. */
const helpers = new Map<string, TextNode>();

class FunctionTextNode extends TextNode {
  private readonly prefix: string;
  private readonly f: FunctionIR;

  constructor(prefix: string, f: FunctionIR, includes: CodeNode[]) {
    super((language) => emitFunction(prefix, f, language).code, includes);
    this.prefix = prefix;
    this.f = f;
  }

  /** Structs and helpers differ by language, so they are known only now. */
  override generate(builder: NodeBuilder): string {
    const language = languageOf(builder);
    for (const include of this.getIncludes(builder)) include.build(builder);
    for (const code of emitFunction(this.prefix, this.f, language).needs.values()) {
      // Not by name: variables of the same name differ between a model with textures and without.
      const key = `${language} ${code}`;
      let node = helpers.get(key);
      if (!node) {
        node = new TextNode(() => code);
        helpers.set(key, node);
      }
      (node as Node).build(builder, 'void');
    }
    return super.generate(builder);
  }

  functionName(builder: NodeBuilder): string {
    return emitFunction(this.prefix, this.f, languageOf(builder)).name;
  }
}

const functionNodes = new WeakMap<FunctionIR, FunctionTextNode>();

function functionNode(prefix: string, f: FunctionIR): FunctionTextNode {
  let node = functionNodes.get(f);
  if (!node) {
    const callees = f.calls.map((callee) => functionNode(prefix, callee));
    node = new FunctionTextNode(prefix, f, callees);
    functionNodes.set(f, node);
  }
  return node;
}

class FunctionCallTextNode extends Node {
  static get type(): string {
    return 'FunctionCallTextNode';
  }

  private readonly callee: FunctionTextNode;
  private readonly args: readonly { readonly node: Node; readonly type: string }[];

  constructor(callee: FunctionTextNode, type: string, args: readonly { node: Node; type: string }[]) {
    super(type as never);
    this.callee = callee;
    this.args = args;
  }

  override generate(builder: NodeBuilder, output?: string | null): string {
    (this.callee as Node).build(builder, 'void');
    const args = this.args.map(({ node, type }) => node.build(builder, type) as string);
    const call = `${this.callee.functionName(builder)}( ${args.join(', ')} )`;
    const { format } = builder as unknown as BuilderFormat;
    return format.call(builder, call, this.getNodeType(builder) as string, output ?? '');
  }
}

function functionNamed(model: Model, name: string): FunctionIR {
  const f = findFunction(model, name);
  if (f) return f;
  throw new RangeError(`${model.name} has no function ${name}(); its terms are ${model.terms.join(', ')}`);
}

const dataNodes = new WeakMap<Model, Node>();

/** A texture with a model's measured data, row by row. */
function dataNode(model: Model): Node {
  let node = dataNodes.get(model);
  if (!node) {
    const triples = model.data ?? new Float32Array(3);
    const height = Math.ceil(triples.length / 3 / DATA_WIDTH);
    const texels = new Float32Array(DATA_WIDTH * height * 4);
    // Texels past the end repeat the last triple, which is what reading out of range gives.
    const last = triples.length / 3 - 1;
    for (let i = 0; i < texels.length / 4; i++) {
      const k = 3 * Math.min(i, last);
      texels.set(triples.subarray(k, k + 3), 4 * i);
    }
    const data = new DataTexture(texels, DATA_WIDTH, height, RGBAFormat, FloatType);
    data.needsUpdate = true;
    node = texture(data) as unknown as Node;
    dataNodes.set(model, node);
  }
  return node;
}

function callOf(
  model: Model,
  f: FunctionIR,
  parameters: ParameterNodes,
  derived: ReadonlyMap<Variable, Node> = new Map(),
): (...args: Node[]) => Node {
  const callee = functionNode(shaderPrefix(model), f);
  const types = f.arguments.map(({ variable }) => variable.type.name);
  const uses = f.uses.map((variable) => {
    // Three.js takes 'texture' for the name of the binding, which is what a function is given.
    if (variable.type === TABLE) return { node: dataNode(model), type: 'texture' };
    const node = variable.role === 'derived' ? derived.get(variable) : parameters[variable.name];
    if (!node) throw new RangeError(`${model.name}: no node was given for parameter ${variable.name}`);
    return { node, type: variable.type.name };
  });
  return (...args) =>
    new FunctionCallTextNode(callee, f.result.name, [
      ...args.map((node, i) => ({ node, type: types[i] as string })),
      ...uses,
    ]);
}

export type BrdfCall = (
  L: Vector3Node,
  V: Vector3Node,
  N: Vector3Node,
  X: Vector3Node,
  Y: Vector3Node,
) => Vector3Node;
/** A BRDF in two parts (hoist.ts), as TSL functions. */
export interface SplitCall {
  /** To be put on the stack before the first light; its value (1) says nothing. */
  readonly perView: (V: Vector3Node, N: Vector3Node, X: Vector3Node, Y: Vector3Node) => FloatNode;
  readonly perLight: BrdfCall;
}

export type SamplerCall = (
  u: Vector2Node,
  V: Vector3Node,
  N: Vector3Node,
  X: Vector3Node,
  Y: Vector3Node,
) => Vector3Node;
export type PdfCall = (...directions: Parameters<BrdfCall>) => FloatNode;

/**
 * BRDF() or a term of a model as a TSL function; its value is in 1/sr, without the cosine.
 *
 * @param name the term
 * @param parameters a node for each parameter that the term reads
 * @throws RangeError if there is no such term, or no node for a parameter
 */
export function modelFunction(model: Model, name: string, parameters: ParameterNodes): BrdfCall {
  return callOf(model, functionNamed(model, name), parameters) as unknown as BrdfCall;
}

/**
 * As modelFunction(), for many lights at one point: what does not depend on L is computed once.
 *
 * @param derived nodes for the quantities of derivedQuantities(), in its order, if the parameters are the
 *   same all over the surface; null if they vary
 * @throws RangeError if there is no such term, or no node for a parameter
 */
export function modelFunctionByLight(
  model: Model,
  name: string,
  parameters: ParameterNodes,
  derived: readonly Node[] | null,
): SplitCall {
  const split = splitByLight(functionNamed(model, name), model.program, derived !== null);
  const nodes = new Map(split.derived.map(({ variable }, i) => [variable, derived?.[i] as Node]));
  return {
    perView: callOf(model, split.perView, parameters, nodes) as unknown as SplitCall['perView'],
    perLight: callOf(model, split.perLight, parameters, nodes) as unknown as BrdfCall,
  };
}

/** sampleL() of a model's sampling section as a TSL function; vec3(0) where it gives no direction. */
export function modelSampler(model: Model, parameters: ParameterNodes): SamplerCall {
  return callOf(model, functionNamed(model, 'sampleL'), parameters) as unknown as SamplerCall;
}

/** pdf() of a model's sampling section as a TSL function, in 1/sr. */
export function modelPdf(model: Model, parameters: ParameterNodes): PdfCall {
  return callOf(model, functionNamed(model, 'pdf'), parameters) as unknown as PdfCall;
}

/**
 * A function of our own, written in GLSL, as a TSL function: where a node per operation would be longer,
 * or slower (TSL's select() is a branch, GLSL's ?: is not).
 *
 * @param source GLSL that defines one function, and those that it calls before it
 */
export function glslFunction(source: string): (...args: Node[]) => Node {
  const lines = source.split('\n').map((text, i) => ({ text, file: 'glslFunction', line: i + 1 }));
  const { functions } = checkProgram(parseGlsl(tokenize({ lines })), []);
  const f = functions.at(-1) as FunctionIR;
  const callee = functionNode(textPrefix(source), f);
  const types = f.arguments.map(({ variable }) => variable.type.name);
  return (...args) =>
    new FunctionCallTextNode(
      callee,
      f.result.name,
      args.map((node, i) => ({ node, type: types[i] as string })),
    );
}
