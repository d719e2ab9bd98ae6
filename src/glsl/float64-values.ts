import type { ArithmeticOperator, Value } from './ir.ts';
import { componentCount, type ScalarName, scalarOf, type Type } from './types.ts';

/** What an uninitialised variable holds: zero, on every back end. */
export function zeroOf(type: Type): Value {
  switch (type.kind) {
    case 'void':
      return 0;
    case 'table':
      return new Float32Array(3);
    case 'scalar':
      return type.scalar === 'bool' ? false : 0;
    case 'vector':
      return new Array<Value>(type.size).fill(type.scalar === 'bool' ? false : 0);
    case 'matrix':
      return new Array<Value>(type.columns * type.rows).fill(0);
    case 'array':
      return Array.from({ length: type.length }, () => zeroOf(type.element));
    case 'struct':
      return type.fields.map((field) => zeroOf(field.type));
  }
}

type Scalar2 = (a: number, b: number) => number;
type Three = readonly [number, number, number];

const FLOAT_OPERATORS: Partial<Record<ArithmeticOperator, Scalar2>> = {
  '+': (a, b) => a + b,
  '-': (a, b) => a - b,
  '*': (a, b) => a * b,
  '/': (a, b) => a / b,
};
/** 32 bit two's complement; division by zero, undefined in GLSL, gives what WGSL defines: the dividend. */
const INT_OPERATORS: Record<ArithmeticOperator, Scalar2> = {
  '+': (a, b) => (a + b) | 0,
  '-': (a, b) => (a - b) | 0,
  '*': Math.imul,
  '/': (a, b) => (b === 0 ? a : (a / b) | 0),
  '%': (a, b) => (b === 0 ? 0 : (a % b) | 0),
  '&': (a, b) => a & b,
  '|': (a, b) => a | b,
  '^': (a, b) => a ^ b,
  '<<': (a, b) => a << b,
  '>>': (a, b) => a >> b,
};
const UINT_OPERATORS: Record<ArithmeticOperator, Scalar2> = {
  ...INT_OPERATORS,
  '/': (a, b) => (b === 0 ? a : a / b),
  '%': (a, b) => (b === 0 ? 0 : a % b),
  '>>': (a, b) => a >>> b,
};

/** The function of an arithmetic operator between operands of these types. */
export function arithmetic(
  operator: ArithmeticOperator,
  left: Type,
  right: Type,
): (a: Value, b: Value) => Value {
  if (operator === '*' && (left.kind === 'matrix' || right.kind === 'matrix')) {
    if (left.kind !== 'scalar' && right.kind !== 'scalar') return matrixProduct(left, right);
  }
  const base = scalarOf(left);
  const f =
    base === 'float'
      ? (FLOAT_OPERATORS[operator] as Scalar2)
      : base === 'uint'
        ? (a: number, b: number) => UINT_OPERATORS[operator](a, b) >>> 0
        : INT_OPERATORS[operator];
  if (left.kind === 'scalar' && right.kind === 'scalar') return f as (a: Value, b: Value) => Value;
  if (componentCount(left) === 3 || componentCount(right) === 3) {
    const kind = left.kind === 'scalar' ? 'ofScalar' : right.kind === 'scalar' ? 'byScalar' : 'each';
    const known = base === 'float' ? THREE_FLOATS[operator]?.[kind] : undefined;
    return (known as ((a: Value, b: Value) => Value) | undefined) ?? ofThree(f, left, right);
  }
  if (left.kind === 'scalar') return (a, b) => (b as readonly number[]).map((x) => f(a as number, x));
  if (right.kind === 'scalar') return (a, b) => (a as readonly number[]).map((x) => f(x, b as number));
  return (a, b) => (a as readonly number[]).map((x, i) => f(x, (b as readonly number[])[i] as number));
}

interface OfThreeFloats {
  /** Two vectors, component by component. */
  readonly each: (a: Three, b: Three) => Three;
  readonly ofScalar: (s: number, v: Three) => Three;
  readonly byScalar: (v: Three, s: number) => Three;
}

/** A function for each operator: engines make little of one function that calls any of four. */
const THREE_FLOATS: Partial<Record<ArithmeticOperator, OfThreeFloats>> = {
  '+': {
    each: (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
    ofScalar: (s, v) => [s + v[0], s + v[1], s + v[2]],
    byScalar: (v, s) => [v[0] + s, v[1] + s, v[2] + s],
  },
  '-': {
    each: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
    ofScalar: (s, v) => [s - v[0], s - v[1], s - v[2]],
    byScalar: (v, s) => [v[0] - s, v[1] - s, v[2] - s],
  },
  '*': {
    each: (a, b) => [a[0] * b[0], a[1] * b[1], a[2] * b[2]],
    ofScalar: (s, v) => [s * v[0], s * v[1], s * v[2]],
    byScalar: (v, s) => [v[0] * s, v[1] * s, v[2] * s],
  },
  '/': {
    each: (a, b) => [a[0] / b[0], a[1] / b[1], a[2] / b[2]],
    ofScalar: (s, v) => [s / v[0], s / v[1], s / v[2]],
    byScalar: (v, s) => [v[0] / s, v[1] / s, v[2] / s],
  },
};

/** Directions and colours are most of what a BRDF computes with; written out they take less time than by map(). */
function ofThree(f: Scalar2, left: Type, right: Type): (a: Value, b: Value) => Value {
  if (left.kind === 'scalar') {
    return (a, b) => {
      const [s, v] = [a as number, b as unknown as Three];
      return [f(s, v[0]), f(s, v[1]), f(s, v[2])];
    };
  }
  if (right.kind === 'scalar') {
    return (a, b) => {
      const [u, s] = [a as unknown as Three, b as number];
      return [f(u[0], s), f(u[1], s), f(u[2], s)];
    };
  }
  return (a, b) => {
    const [u, v] = [a as unknown as Three, b as unknown as Three];
    return [f(u[0], v[0]), f(u[1], v[1]), f(u[2], v[2])];
  };
}

/** matrix * matrix, matrix * vector (a column) or vector (a row) * matrix. */
function matrixProduct(left: Type, right: Type): (a: Value, b: Value) => Value {
  const [rows, inner] = left.kind === 'matrix' ? [left.rows, left.columns] : [1, componentCount(left)];
  const columns = right.kind === 'matrix' ? right.columns : 1;
  return (a, b) => {
    const [x, y] = [a as readonly number[], b as readonly number[]];
    const result: number[] = [];
    for (let c = 0; c < columns; c++) {
      for (let r = 0; r < rows; r++) {
        let sum = 0;
        for (let k = 0; k < inner; k++) sum += (x[k * rows + r] as number) * (y[c * inner + k] as number);
        result.push(sum);
      }
    }
    return result;
  };
}

function convertScalar(from: ScalarName, to: ScalarName): (x: Value) => Value {
  if (from === to) return (x) => x;
  if (to === 'bool') return (x) => x !== 0;
  const whole = (x: number) => (to === 'int' ? Math.trunc(x) | 0 : to === 'uint' ? Math.trunc(x) >>> 0 : x);
  return from === 'bool' ? (x) => (x ? 1 : 0) : (x) => whole(x as number);
}

/** The function that makes a value of a type from constructor arguments of these types. */
export function constructFloat64(type: Type, args: readonly Type[]): (values: readonly Value[]) => Value {
  const [first] = args as [Type, ...Type[]];
  if (type.kind === 'struct' || type.kind === 'array') return (values) => values;
  const cast = convertScalar(scalarOf(first) as ScalarName, scalarOf(type) as ScalarName);
  if (type.kind === 'scalar') return ([value]) => cast(Array.isArray(value) ? value[0] : (value as Value));
  if (type.kind === 'matrix') {
    const { columns, rows } = type;
    const fromMatrix = first.kind === 'matrix' ? first : null;
    if (args.length === 1 && (fromMatrix || first.kind === 'scalar')) {
      return ([value]) =>
        Array.from({ length: columns * rows }, (_, i) => {
          const [c, r] = [Math.floor(i / rows), i % rows];
          const inside = fromMatrix && c < fromMatrix.columns && r < fromMatrix.rows;
          if (inside) return (value as readonly Value[])[c * fromMatrix.rows + r] as Value;
          return c === r ? (fromMatrix ? 1 : (value as Value)) : 0;
        });
    }
    return (values) => inOneRow(values).slice(0, columns * rows);
  }
  const size = componentCount(type);
  if (args.length === 1 && first.kind === 'scalar')
    return ([value]) => new Array<Value>(size).fill(cast(value as Value));
  if (args.length === 1) return ([value]) => (value as readonly Value[]).slice(0, size).map(cast);
  if (args.every(({ kind }) => kind === 'scalar')) return (values) => values;
  return (values) => inOneRow(values).slice(0, size);
}

/** The components of scalars, vectors and matrices. The built-in flat() takes many times as long. */
function inOneRow(values: readonly Value[]): Value[] {
  const row: Value[] = [];
  for (const value of values) {
    if (Array.isArray(value)) for (const component of value as readonly Value[]) row.push(component);
    else row.push(value);
  }
  return row;
}
