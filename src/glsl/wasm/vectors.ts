import { componentCount, type ScalarName, scalarOf, type Type } from '../types.ts';
import type { Body } from './body.ts';
import { type Code, extractLane, f32, i32, op, replaceLane, shuffle, v128 } from './code.ts';
import { scalarCell } from './layout.ts';

/** Vectors as cells (layout.ts): taken apart, put together and widened. */

const wherefrom = new WeakMap<Code, { vector: Code; lane: number }>();

/** One component of a vector of four. The vector must be stable. */
function lane(vector: Code, index: number, name: ScalarName): Code {
  if (name === 'bool') return op('i32.and', extractLane('i32', vector, index), i32(1));
  const code = extractLane(scalarCell(name), vector, index);
  wherefrom.set(code, { vector, lane: index });
  return code;
}

/** The components of a scalar or vector, each to be used once. */
export function components(body: Body, cells: readonly Code[], type: Type): readonly Code[] {
  if (componentCount(type) !== 4) return cells;
  const vector = body.pin(cells[0] as Code);
  return [0, 1, 2, 3].map((k) => lane(vector, k, scalarOf(type) as ScalarName));
}

/** Components as the cells of a scalar or vector. */
export function compose(body: Body, parts: readonly Code[], name: ScalarName): readonly Code[] {
  if (parts.length < 4) return parts;
  const kind = scalarCell(name);
  const constants = parts.map((part) => part.constant);
  if (!constants.includes(null)) {
    const lanes = constants as readonly number[];
    return [v128(name === 'bool' ? lanes.map((x) => -x) : lanes, kind)];
  }
  if (name !== 'bool') {
    const shuffled = composeShuffle(parts);
    if (shuffled) return [shuffled];
  }
  const value = (part: Code) => (name === 'bool' ? op('i32.sub', i32(0), part) : part);
  const [first, ...rest] = parts as [Code, ...Code[]];
  if (rest.every((part) => part === first || (part.stable && sameBytes(part, first))))
    return [splat(body.pin(first), name)];
  // The parts stand in the order of their making, so that each is computed once.
  let vector = op(`${kind}x4.splat`, value(first));
  for (const [i, part] of rest.entries()) vector = replaceLane(kind, vector, i + 1, value(part));
  return [vector];
}

/** Lanes of at most two vectors as one shuffle, or as it plus one lane. */
function composeShuffle(parts: readonly Code[]): Code | null {
  const sources = parts.map((part) => wherefrom.get(part));
  const vectors: Code[] = [];
  for (const source of sources)
    if (source && !vectors.some((v) => sameBytes(v, source.vector))) vectors.push(source.vector);
  const [a, b] = vectors;
  if (!a || vectors.length > 2) return null;
  const indexOf = (source: { vector: Code; lane: number }) =>
    source.lane + (sameBytes(source.vector, a) ? 0 : 4);
  const strangers = parts.filter((_, i) => !sources[i]);
  if (strangers.length > 1) return null;
  const lanes = sources.map((source) => (source ? indexOf(source) : 0));
  const inPlace = vectors.length === 1 && sources.every((source, i) => !source || source.lane === i);
  let vector = inPlace ? a : shuffle(a, b ?? a, lanes);
  for (const [i, part] of parts.entries())
    if (!sources[i]) vector = replaceLane(part.type === 'f32' ? 'f32' : 'i32', vector, i, part);
  return vector;
}

function sameBytes(a: Code, b: Code): boolean {
  return a.bytes.length === b.bytes.length && a.bytes.every((byte, i) => byte === b.bytes[i]);
}

/** A scalar in all four lanes. */
export function splat(code: Code, name: ScalarName): Code {
  if (code.constant !== null) {
    const value = name === 'bool' ? -code.constant : code.constant;
    return v128([value, value, value, value], scalarCell(name));
  }
  return op(`${scalarCell(name)}x4.splat`, name === 'bool' ? op('i32.sub', i32(0), code) : code);
}

/** The cells of a scalar or vector of `type`, widened to vectors of `size` if it is a scalar. */
export function widen(body: Body, cells: readonly Code[], type: Type, size: number): readonly Code[] {
  if (componentCount(type) === size) return cells;
  const [cell] = cells as readonly [Code];
  if (size === 4) return [splat(cell, scalarOf(type) as ScalarName)];
  return new Array<Code>(size).fill(body.pin(cell));
}

/** A function of components, for each component. */
export function perComponent(
  body: Body,
  args: readonly (readonly Code[])[],
  types: readonly Type[],
  result: Type,
  f: (...args: Code[]) => Code,
): readonly Code[] {
  const size = componentCount(result);
  const parts = args.map((cells, i) =>
    components(body, widen(body, cells, types[i] as Type, size), withSize(types[i] as Type, size)),
  );
  const results = Array.from({ length: size }, (_, k) => f(...parts.map((list) => list[k] as Code)));
  return compose(body, results, scalarOf(result) as ScalarName);
}

/** A function of cells, for each cell: all arguments are vectors of one size. */
export function perCell(args: readonly (readonly Code[])[], f: (...args: Code[]) => Code): readonly Code[] {
  return (args[0] as readonly Code[]).map((_, k) => f(...args.map((list) => list[k] as Code)));
}

function withSize(type: Type, size: number): Type {
  return componentCount(type) === size ? type : ({ ...type, kind: 'vector', size } as Type);
}

/** The prefix of an operation's name on cells of this type: f32, f32x4, i32 or i32x4. */
export function prefixOf(cell: Code, name: ScalarName): string {
  return cell.type === 'v128' ? `${scalarCell(name)}x4` : scalarCell(name);
}

/** The sum of the components of floats, given as cells. */
export function sum(body: Body, cells: readonly Code[], type: Type): Code {
  const parts = components(body, cells, type);
  // Four in pairs: a shorter chain.
  if (parts.length === 4) {
    const [x, y, z, w] = parts as readonly [Code, Code, Code, Code];
    return op('f32.add', op('f32.add', x, y), op('f32.add', z, w));
  }
  return parts.reduce((total, part) => op('f32.add', total, part));
}

export function dot(body: Body, a: readonly Code[], b: readonly Code[], type: Type): Code {
  const products = perCell([a, b], (x, y) => op(`${prefixOf(x, 'float')}.mul`, x, y));
  return sum(body, products, type);
}

export function one(cell: Code, name: ScalarName): Code {
  const value = name === 'float' ? f32(1) : i32(1);
  return cell.type === 'v128' ? splat(value, name) : value;
}
