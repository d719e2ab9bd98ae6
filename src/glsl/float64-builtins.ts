import type { Value } from './ir.ts';
import type { Type } from './types.ts';

type Builtin = (a: Value, b?: Value, c?: Value) => Value;
type Vector = readonly number[];

const fract = (x: number) => x - Math.floor(x);
/** Halfway cases go to the even neighbour, as in WGSL's round(). */
const roundEven = (x: number) =>
  Math.abs(fract(x) - 0.5) < Number.EPSILON ? 2 * Math.round(x / 2) : Math.round(x);
const clamp01 = (x: number) => Math.min(Math.max(x, 0), 1);

const COMPONENTWISE: Record<string, (a: number, b: number, c: number) => number> = {
  radians: (x) => (x * Math.PI) / 180,
  degrees: (x) => (x * 180) / Math.PI,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  asin: Math.asin,
  acos: Math.acos,
  atan: Math.atan,
  sinh: Math.sinh,
  cosh: Math.cosh,
  tanh: Math.tanh,
  asinh: Math.asinh,
  acosh: Math.acosh,
  atanh: Math.atanh,
  exp: Math.exp,
  log: Math.log,
  exp2: (x) => 2 ** x,
  log2: Math.log2,
  sqrt: Math.sqrt,
  inversesqrt: (x) => 1 / Math.sqrt(x),
  abs: Math.abs,
  sign: Math.sign,
  floor: Math.floor,
  trunc: Math.trunc,
  round: roundEven,
  roundEven,
  ceil: Math.ceil,
  fract,
  pow: (x, y) => x ** y,
  mod: (x, y) => x - y * Math.floor(x / y),
  min: Math.min,
  max: Math.max,
  clamp: (x, low, high) => Math.min(Math.max(x, low), high),
  step: (edge, x) => (x < edge ? 0 : 1),
  smoothstep: (low, high, x) => {
    const t = clamp01((x - low) / (high - low));
    return t * t * (3 - 2 * t);
  },
  fma: (a, b, c) => a * b + c,
};

const COMPARISONS: Record<string, (a: Value, b: Value) => boolean> = {
  lessThan: (a, b) => a < b,
  lessThanEqual: (a, b) => a <= b,
  greaterThan: (a, b) => a > b,
  greaterThanEqual: (a, b) => a >= b,
  equal: (a, b) => a === b,
  notEqual: (a, b) => a !== b,
};

const list = (value: Value | undefined): Vector => (Array.isArray(value) ? value : [value]) as Vector;
function dot(a: Vector, b: Vector): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] as number) * (b[i] as number);
  return sum;
}

/** A vector's function; scalars pass through it as vectors of one component. */
function vectors(f: (a: Vector, b: Vector, c: Vector) => Vector): Builtin {
  return (a, b, c) => {
    const result = f(list(a), list(b), list(c));
    return Array.isArray(a) ? result : (result[0] as number);
  };
}

const GEOMETRIC: Record<string, Builtin> = {
  length: (a) => Math.hypot(...list(a)),
  distance: (a, b) => Math.hypot(...list(a).map((x, i) => x - (list(b)[i] as number))),
  dot: (a, b) => dot(list(a), list(b)),
  normalize: (a) => {
    if (!Array.isArray(a)) return (a as number) / Math.hypot(a as number);
    const vector = a as Vector;
    const [x, y, z] = vector as [number, number, number];
    const length = vector.length === 3 ? Math.hypot(x, y, z) : Math.hypot(...vector);
    return vector.length === 3 ? [x / length, y / length, z / length] : vector.map((c) => c / length);
  },
  cross: (a, b) => {
    const [ax, ay, az] = a as unknown as [number, number, number];
    const [bx, by, bz] = b as unknown as [number, number, number];
    return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
  },
  reflect: vectors((i, n) => {
    const d = 2 * dot(n, i);
    return i.map((x, k) => x - d * (n[k] as number));
  }),
  refract: vectors((i, n, [eta = 1]) => {
    const d = dot(n, i);
    const k = 1 - eta * eta * (1 - d * d);
    return i.map((x, c) => (k < 0 ? 0 : eta * x - (eta * d + Math.sqrt(k)) * (n[c] as number)));
  }),
  faceforward: vectors((n, i, reference) => (dot(reference, i) < 0 ? n : n.map((x) => -x))),
  any: (a) => (a as readonly Value[]).includes(true),
  all: (a) => !(a as readonly Value[]).includes(false),
  not: (a) => (a as readonly boolean[]).map((x) => !x),
};

/** A built-in function for arguments of these types (all vectors of a call have one size). */
export function builtinFloat64(name: string, types: readonly Type[]): Builtin {
  const [first] = types as [Type, ...Type[]];
  const isList = first.kind === 'vector';
  const geometric = GEOMETRIC[name];
  if (geometric) return geometric;
  if (name === 'isnan' || name === 'isinf') {
    const test = name === 'isnan' ? Number.isNaN : (x: number) => Math.abs(x) === Number.POSITIVE_INFINITY;
    return (a) => (isList ? (a as Vector).map(test) : test(a as number));
  }
  if (name === 'fetchData') return fetchData;
  const bits = BITS[name];
  if (bits) return (a) => (isList ? (a as Vector).map(bits) : bits(a as number));
  if (name === 'mix') return mix(types);
  if (first.kind === 'matrix') return matrixFunction(name, first.columns, first.rows);
  const comparison = COMPARISONS[name];
  if (comparison)
    return (a, b) =>
      (a as readonly Value[]).map((x, i) => comparison(x, (b as readonly Value[])[i] as Value));
  const f = (name === 'atan' && types.length === 2 ? Math.atan2 : COMPONENTWISE[name]) as (
    a: number,
    b?: number,
    c?: number,
  ) => number;
  if (!isList) return f as Builtin;
  if (types.length === 1) return (a) => (a as Vector).map((x) => f(x));
  if (types.length === 2) return (a, b) => (a as Vector).map((x, i) => f(x, (b as Vector)[i]));
  return (a, b, c) => (a as Vector).map((x, i) => f(x, (b as Vector)[i], (c as Vector)[i]));
}

function mix(types: readonly Type[]): Builtin {
  const third = types[2] as Type;
  const isBool = third.kind === 'scalar' || third.kind === 'vector' ? third.scalar === 'bool' : false;
  const one = (x: number, y: number, t: Value) =>
    isBool ? (t ? y : x) : x * (1 - (t as number)) + y * (t as number);
  if (types[0]?.kind === 'scalar') return (a, b, t) => one(a as number, b as number, t as Value);
  return (a, b, t) =>
    (a as Vector).map((x, i) => one(x, (b as Vector)[i] as number, (t as readonly Value[])[i] as Value));
}

function matrixFunction(name: string, columns: number, rows: number): Builtin {
  if (name === 'transpose') {
    return (a) =>
      Array.from(
        { length: columns * rows },
        (_, i) => (a as Vector)[(i % columns) * rows + Math.floor(i / columns)] as number,
      );
  }
  return (a) => determinant(a as Vector, columns);
}

/** By expansion along the first column; sizes are 2 to 4. */
function determinant(m: Vector, n: number): number {
  if (n === 1) return m[0] as number;
  let sum = 0;
  for (let r = 0; r < n; r++) {
    const minor = m.filter((_, i) => i >= n && i % n !== r);
    sum += (r % 2 === 0 ? 1 : -1) * (m[r] as number) * determinant(minor, n - 1);
  }
  return sum;
}

const word = new DataView(new ArrayBuffer(4));
const floatToUint = (x: number) => {
  word.setFloat32(0, x);
  return word.getUint32(0);
};
const bitsToFloat = (bits: number) => {
  word.setUint32(0, bits);
  return word.getFloat32(0);
};
/** The bits are those of the number as float32, as on a GPU. */
const BITS: Record<string, (x: number) => number> = {
  floatBitsToUint: floatToUint,
  floatBitsToInt: (x) => floatToUint(x) | 0,
  uintBitsToFloat: bitsToFloat,
  intBitsToFloat: bitsToFloat,
  bitfieldReverse: (x) => {
    let reversed = 0;
    for (let i = 0; i < 32; i++) reversed = (reversed << 1) | ((x >>> i) & 1);
    return reversed >>> 0;
  },
};

/** Out of range reads the nearest triple, as on the GPU. */
function fetchData(table: Value, index: Value | undefined): Value {
  const data = table as Float32Array;
  const i = 3 * Math.max(0, Math.min(index as number, data.length / 3 - 1));
  return [data[i] as number, data[i + 1] as number, data[i + 2] as number];
}
