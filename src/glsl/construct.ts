import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import { evaluateExpression } from './float64.ts';
import type { Expr } from './ir.ts';
import {
  componentCount,
  convertsImplicitly,
  matrix,
  type ScalarName,
  type ScalarType,
  scalarOf,
  type Type,
  vector,
} from './types.ts';

export function literal(place: SourcePlace, type: ScalarType, value: number | boolean): Expr {
  return { kind: 'literal', place, type, constant: true, value };
}

/** Replaces a constant scalar expression by its value; anything else stays. */
export function fold(e: Expr): Expr {
  if (!e.constant || e.kind === 'literal' || e.type.kind !== 'scalar') return e;
  return literal(e.place, e.type, evaluateExpression(e) as number | boolean);
}

/** To a type of the same shape, or from a scalar to a vector of equal components. */
export function convert(e: Expr, type: Type): Expr {
  if (e.type === type) return e;
  return fold({ kind: 'construct', place: e.place, type, constant: e.constant, args: [e] });
}

/** To another component type; the shape stays. */
export function convertBase(e: Expr, base: ScalarName): Expr {
  if (scalarOf(e.type) === base) return e;
  return convert(
    e,
    e.type.kind === 'matrix' ? matrix(e.type.columns, e.type.rows) : vector(base, componentCount(e.type)),
  );
}

/** A constructor call: T(args). @throws BrdfError if the arguments do not make a T */
export function checkConstruct(type: Type, args: readonly Expr[], place: SourcePlace): Expr {
  const constant = args.every((arg) => arg.constant);
  const wrong = (expected: string): never => {
    throw new BrdfError(place, `${type.name}(${args.map((arg) => arg.type.name).join(', ')})`, expected);
  };
  const make = (converted: readonly Expr[]): Expr =>
    fold({ kind: 'construct', place, type, constant, args: converted });
  const members = (types: readonly Type[]): Expr => {
    if (
      args.length !== types.length ||
      !args.every((arg, i) => convertsImplicitly(arg.type, types[i] as Type))
    )
      wrong(types.map((t) => t.name).join(', '));
    return make(args.map((arg, i) => convert(arg, types[i] as Type)));
  };
  switch (type.kind) {
    case 'void':
      return wrong('a type with values');
    case 'struct':
      return members(type.fields.map((field) => field.type));
    case 'array':
      return members(Array.from({ length: type.length }, () => type.element));
    default: {
      const base = scalarOf(type) as ScalarName;
      const [first] = args;
      if (!first) return wrong('at least one value');
      if (args.length === 1 && first.type.kind === 'matrix') {
        if (type.kind !== 'matrix') return wrong('numbers or vectors');
        return first.type === type ? first : make(args);
      }
      const counts = args.map((arg) => componentCount(arg.type));
      if (counts.includes(0)) return wrong('numbers, bools or vectors');
      const converted = args.map((arg) => convertBase(arg, base));
      const total = counts.reduce((sum, count) => sum + count, 0);
      const needed = type.kind === 'matrix' ? type.columns * type.rows : componentCount(type);
      if (args.length === 1 && counts[0] === 1)
        return (converted[0] as Expr).type === type ? (converted[0] as Expr) : make(converted);
      // The last argument may be cut short, but none may be left over entirely (GLSL 4.60, section 5.4.2).
      if (total < needed || total - (counts.at(-1) as number) >= needed) return wrong(`${needed} components`);
      if (args.length === 1 && (converted[0] as Expr).type === type) return converted[0] as Expr;
      return make(converted);
    }
  }
}
