import { wholeExponent } from '../emit.ts';
import type { Expr } from '../ir.ts';
import { componentCount, type ScalarName, scalarOf, type Type } from '../types.ts';
import type { Body } from './body.ts';
import { type Code, extractLane, f32, i32, op, select } from './code.ts';
import { matrixComponents } from './construct.ts';
import { geometric } from './geometric.ts';
import { memoryBuiltin } from './memory.ts';
import { CALL } from './opcodes.ts';
import { all, any, compareCells } from './operators.ts';
import type { Unit } from './unit.ts';
import { compose, perCell, perComponent, prefixOf, splat, widen } from './vectors.ts';

/** GLSL's built-in functions on cells. */

type Builtin = Extract<Expr, { kind: 'builtin' }>;
type Cells = readonly Code[];

const RELATIONAL: Record<string, string> = {
  lessThan: '<',
  lessThanEqual: '<=',
  greaterThan: '>',
  greaterThanEqual: '>=',
  equal: '==',
  notEqual: '!=',
};
/** Functions that are one instruction. */
const INSTRUCTION: Record<string, string> = {
  floor: 'floor',
  ceil: 'ceil',
  trunc: 'trunc',
  round: 'nearest',
  roundEven: 'nearest',
  sqrt: 'sqrt',
};
/** Rare functions, which JavaScript's Math computes; for the others see math.ts. */
const MATH = new Set(['sinh', 'cosh', 'tanh', 'asinh', 'acosh', 'atanh']);

export function builtin(unit: Unit, body: Body, e: Builtin, args: readonly Cells[]): Cells {
  const types = e.args.map((arg) => arg.type);
  const [a, b, c] = args as readonly [Cells, Cells, Cells];
  const [first] = types as [Type];
  const name = scalarOf(e.type) as ScalarName;
  if (first.kind === 'matrix') return matrixFunction(body, e.name, a, first);
  const stored = memoryBuiltin(unit, body, e, args);
  if (stored) return stored;
  const size = componentCount(first);
  const relation = RELATIONAL[e.name];
  if (relation) return compareCells(relation, a, b, scalarOf(first) as ScalarName);
  if (INSTRUCTION[e.name]) return a.map((x) => float(x, INSTRUCTION[e.name] as string, x));
  const exponent = wholeExponent(e);
  if (exponent !== null) return a.map((x) => power(body, x, exponent));
  const found = geometric(body, e.name, args, first);
  if (found) return found;
  if (MATH.has(e.name)) return perComponent(body, args, types, e.type, (x) => callMath(unit, e.name, x));
  switch (e.name) {
    case 'radians':
    case 'degrees': {
      const factor = f32(e.name === 'radians' ? Math.PI / 180 : 180 / Math.PI);
      return a.map((x) => float(x, 'mul', x, like(x, factor)));
    }
    case 'inversesqrt':
      return a.map((x) => float(x, 'div', like(x, f32(1)), float(x, 'sqrt', x)));
    case 'fract':
      return body.pinAll(a).map((x) => float(x, 'sub', x, float(x, 'floor', x)));
    case 'abs':
      return a.map((x) => absolute(body, x, name));
    case 'sign':
      return body.pinAll(a).map((x) => sign(x, name));
    case 'mod': {
      const y = body.pinAll(widen(body, b, types[1] as Type, size));
      return perCell([body.pinAll(a), y], (p, q) =>
        float(p, 'sub', p, float(p, 'mul', q, float(p, 'floor', float(p, 'div', p, q)))),
      );
    }
    case 'min':
    case 'max': {
      const wide = args.map((cells, i) => widen(body, cells, types[i] as Type, componentCount(e.type)));
      return perCell(wide, (x, y) => extreme(body, e.name as 'min', name, x, y));
    }
    case 'clamp': {
      const wide = args.map((cells, i) => widen(body, cells, types[i] as Type, componentCount(e.type)));
      return perCell(wide, (x, low, high) =>
        extreme(body, 'min', name, extreme(body, 'max', name, x, low), high),
      );
    }
    case 'mix': {
      if (scalarOf(types[2] as Type) === 'bool')
        return perCell(args, (x, y, test) =>
          x.type === 'v128' ? op('v128.bitselect', y, x, test) : select(test, y, x),
        );
      const t = body.pinAll(widen(body, c, types[2] as Type, size));
      return perCell([a, b, t], (x, y, w) =>
        float(x, 'add', float(x, 'mul', x, float(x, 'sub', like(x, f32(1)), w)), float(x, 'mul', y, w)),
      );
    }
    case 'step': {
      const result = componentCount(e.type);
      const edge = widen(body, a, first, result);
      return perCell([edge, b], (low, x) =>
        x.type === 'v128'
          ? op('v128.andnot', splat(f32(1), 'float'), op('f32x4.lt', x, low))
          : op('f32.convert_i32_u', op('i32.eqz', op('f32.lt', x, low))),
      );
    }
    case 'smoothstep': {
      const wide = args.map((cells, i) => widen(body, cells, types[i] as Type, componentCount(e.type)));
      return perCell(
        wide.map((cells) => body.pinAll(cells)),
        (low, high, x) => {
          const ratio = float(x, 'div', float(x, 'sub', x, low), float(x, 'sub', high, low));
          const above = extreme(body, 'max', 'float', ratio, like(x, f32(0)));
          const t = body.pin(extreme(body, 'min', 'float', above, like(x, f32(1))));
          const slope = float(x, 'sub', like(x, f32(3)), float(x, 'add', t, t));
          return float(x, 'mul', float(x, 'mul', t, t), slope);
        },
      );
    }
    case 'fma':
      return perCell([a, b, c], (x, y, z) => float(x, 'add', float(x, 'mul', x, y), z));
    case 'isnan':
      return body.pinAll(a).map((x) => float(x, 'ne', x, x));
    case 'isinf':
      return a.map((x) => float(x, 'eq', float(x, 'abs', x), like(x, f32(Number.POSITIVE_INFINITY))));
    case 'any':
      return [any(a)];
    case 'all':
      return [all(a)];
    case 'not':
      return a.map((x) => (x.type === 'v128' ? op('v128.not', x) : op('i32.eqz', x)));
  }
  throw new Error(`unreachable: the checker knows no function ${e.name}()`);
}

/** An operation on floats, in one or four lanes as `like` has them. */
function float(like: Code, operation: string, ...args: readonly Code[]): Code {
  return op(`${prefixOf(like, 'float')}.${operation}`, ...args);
}

/** A float in as many lanes as another cell. */
function like(cell: Code, value: Code): Code {
  return cell.type === 'v128' ? splat(value, 'float') : value;
}

/** min and max as GLSL defines them, by a comparison (where one is not a number, the first). */
function extreme(body: Body, which: 'min' | 'max', name: ScalarName, a: Code, b: Code): Code {
  const wide = a.type === 'v128';
  if (name === 'float') {
    if (wide) return op(`f32x4.p${which}`, a, b);
    // One instruction that needs no branch, unlike f32.min and select on floats in V8 (7 times as fast).
    const [x, y] = [op('f32x4.splat', a), op('f32x4.splat', b)];
    return extractLane('f32', op(`f32x4.p${which}`, x, y), 0);
  }
  const sign = name === 'int' ? 's' : 'u';
  if (wide) return op(`i32x4.${which}_${sign}`, a, b);
  const [x, y] = body.pinAll([a, b]) as [Code, Code];
  return select(op(`i32.${which === 'min' ? 'lt' : 'gt'}_${sign}`, y, x), y, x);
}

function absolute(body: Body, cell: Code, name: ScalarName): Code {
  if (name === 'float') return float(cell, 'abs', cell);
  if (name === 'uint') return cell;
  if (cell.type === 'v128') return op('i32x4.abs', cell);
  const x = body.pin(cell);
  return select(op('i32.lt_s', x, i32(0)), op('i32.sub', i32(0), x), x);
}

function sign(x: Code, name: ScalarName): Code {
  const wide = x.type === 'v128';
  const prefix = prefixOf(x, name);
  const zero = wide ? splat(i32(0), 'int') : name === 'float' ? f32(0) : i32(0);
  const suffix = name === 'float' ? '' : name === 'int' ? '_s' : '_u';
  const above = op(`${prefix}.gt${suffix}`, x, zero);
  const below = op(`${prefix}.lt${suffix}`, x, zero);
  // In four lanes, true is -1.
  const whole = wide ? op('i32x4.sub', below, above) : op('i32.sub', above, below);
  if (name !== 'float') return whole;
  return op(wide ? 'f32x4.convert_i32x4_s' : 'f32.convert_i32_s', whole);
}

/** x^n for a whole n from 2 to 8, by squaring. */
function power(body: Body, cell: Code, n: number): Code {
  const x = body.pin(cell);
  const times = (p: Code, q: Code) => body.pin(float(x, 'mul', p, q));
  const square = times(x, x);
  const half = n < 4 ? square : times(square, square);
  const even = n < 4 ? square : n < 6 ? half : n < 8 ? times(half, square) : times(half, half);
  return n % 2 === 0 ? even : times(even, x);
}

/** A function of JavaScript's Math. */
function callMath(unit: Unit, name: string, arg: Code): Code {
  const call: Code = {
    type: 'f64',
    bytes: [op('f64.promote_f32', arg).bytes, CALL, -1 - unit.math(name)],
    cost: Number.POSITIVE_INFINITY,
    stable: false,
    constant: null,
  };
  return op('f32.demote_f64', call);
}

function matrixFunction(
  body: Body,
  name: string,
  cells: Cells,
  type: Extract<Type, { kind: 'matrix' }>,
): Cells {
  const parts = matrixComponents(body, body.pinAll(cells), type).map((column) => body.pinAll(column));
  if (name === 'transpose')
    return Array.from({ length: type.rows }, (_, r) =>
      compose(
        body,
        parts.map((column) => column[r] as Code),
        'float',
      ),
    ).flat();
  return [determinant(parts)];
}

/** By expansion along the first column. */
function determinant(columns: readonly (readonly Code[])[]): Code {
  const [first, ...rest] = columns as [readonly Code[], ...(readonly Code[])[]];
  if (rest.length === 0) return first[0] as Code;
  return first
    .map((factor, r) => {
      const minor = determinant(rest.map((column) => column.filter((_, i) => i !== r)));
      return op('f32.mul', factor, minor);
    })
    .reduce((sum, term, r) => op(r % 2 === 0 ? 'f32.add' : 'f32.sub', sum, term));
}
