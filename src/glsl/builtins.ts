import {
  BOOL,
  componentCount,
  convertsImplicitly,
  FLOAT,
  INT,
  isNumeric,
  matrix,
  type ScalarName,
  scalarOf,
  type Type,
  VOID,
  vector,
  widerScalar,
} from './types.ts';

/**
 * GLSL's built-in functions (GLSL 4.60, chapter 8) as far as a BRDF needs them, described by patterns:
 * one letter an argument, then the result.
 *
 *   g  a scalar or vector; all g of a call have one size
 *   s  as g, or a scalar that serves every component
 *   f  a scalar      3  a vector of three      b  a bool per component of g
 */
interface Pattern {
  readonly args: string;
  readonly result: 'g' | 'f' | 'b' | 'bool' | '3';
  /** float: arguments become floats; numeric: they take their widest type; bool: bool vectors only. */
  readonly family: 'float' | 'numeric' | 'bool';
  /** Vectors only. */
  readonly vectors?: true;
}

function table(): Map<string, Pattern[]> {
  const patterns = new Map<string, Pattern[]>();
  const add = (
    names: string,
    args: string,
    result: Pattern['result'],
    family: Pattern['family'],
    vectors?: true,
  ) => {
    for (const name of names.split(' ')) {
      const list = patterns.get(name) ?? [];
      list.push(vectors ? { args, result, family, vectors } : { args, result, family });
      patterns.set(name, list);
    }
  };
  add('radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh', 'g', 'g', 'float');
  add(
    'exp log exp2 log2 sqrt inversesqrt floor trunc round roundEven ceil fract normalize',
    'g',
    'g',
    'float',
  );
  add('abs sign', 'g', 'g', 'numeric');
  add('pow atan', 'gg', 'g', 'float');
  add('reflect', 'gg', 'g', 'float', true);
  add('mod', 'gs', 'g', 'float');
  add('min max', 'ss', 'g', 'numeric');
  add('clamp', 'sss', 'g', 'numeric');
  add('mix', 'ggs', 'g', 'float');
  add('mix', 'ggb', 'g', 'numeric');
  add('step', 'sg', 'g', 'float');
  add('smoothstep', 'ssg', 'g', 'float');
  add('fma', 'ggg', 'g', 'float');
  add('faceforward', 'ggg', 'g', 'float', true);
  add('refract', 'ggf', 'g', 'float', true);
  add('length', 'g', 'f', 'float');
  add('distance dot', 'gg', 'f', 'float');
  add('cross', '33', '3', 'float');
  add('isnan isinf', 'g', 'b', 'float');
  add('any all', 'g', 'bool', 'bool', true);
  add('not', 'g', 'b', 'bool', true);
  add('lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual', 'gg', 'b', 'numeric', true);
  add('equal notEqual', 'gg', 'b', 'bool', true);
  return patterns;
}

const PATTERNS = table();

export interface ResolvedBuiltin {
  /** The types that the arguments must be converted to. */
  readonly args: readonly Type[];
  readonly result: Type;
}

/** The names of all of them, for who writes a model. */
export function builtinNames(): string[] {
  return [...PATTERNS.keys(), 'transpose', 'determinant'];
}

export function isBuiltin(name: string): boolean {
  return PATTERNS.has(name) || name === 'transpose' || name === 'determinant';
}

/** What only kernels may call: the scene's memory, the film and the bits of numbers (docs/decisions/path-tracer.md). */
const MEMORY: Record<string, ResolvedBuiltin> = {
  loadUint4: { args: [INT], result: vector('uint', 4) },
  loadFloat4: { args: [INT], result: vector('float', 4) },
  loadUint: { args: [INT], result: vector('uint', 1) },
  loadFloat: { args: [INT], result: FLOAT },
  filmLoad: { args: [INT], result: vector('float', 4) },
  filmStore: { args: [INT, vector('float', 4)], result: VOID },
};
const BITS: Record<string, { from: ScalarName; to: ScalarName }> = {
  floatBitsToUint: { from: 'float', to: 'uint' },
  floatBitsToInt: { from: 'float', to: 'int' },
  uintBitsToFloat: { from: 'uint', to: 'float' },
  intBitsToFloat: { from: 'int', to: 'float' },
  bitfieldReverse: { from: 'uint', to: 'uint' },
};

/** As resolveBuiltin(), for what a kernel may call beyond GLSL's own. */
export function resolveKernelBuiltin(name: string, args: readonly Type[]): ResolvedBuiltin | null {
  const memory = MEMORY[name];
  if (memory) {
    const fits = args.length === memory.args.length && args.every((type, i) => type === memory.args[i]);
    return fits ? memory : null;
  }
  const bits = BITS[name];
  const [type] = args;
  if (!bits || !type || args.length !== 1 || scalarOf(type) !== bits.from) return null;
  return { args: [type], result: vector(bits.to, componentCount(type)) };
}

/** By call: models call the same few hundred some thousand times, and a third of their parsing was choosing among patterns. */
const resolved = new Map<string, ResolvedBuiltin>();

/** The overload of a built-in function that these arguments choose, or null if there is none. */
export function resolveBuiltin(name: string, args: readonly Type[]): ResolvedBuiltin | null {
  let call = name;
  for (const type of args) call += ` ${type.name}`;
  const known = resolved.get(call);
  if (known) return known;
  const builtin = choosePattern(name, args);
  // What fits has scalars, vectors and matrices alone, which are known by their names; a name of a struct is each program's own.
  if (builtin) resolved.set(call, builtin);
  return builtin;
}

function choosePattern(name: string, args: readonly Type[]): ResolvedBuiltin | null {
  const [first] = args;
  if (first?.kind === 'matrix') {
    if (name === 'transpose' && args.length === 1) return { args, result: matrix(first.rows, first.columns) };
    if (name === 'determinant' && args.length === 1 && first.columns === first.rows)
      return { args, result: FLOAT };
    return null;
  }
  for (const pattern of PATTERNS.get(name) ?? []) {
    const builtin = match(pattern, args);
    if (builtin) return builtin;
  }
  return null;
}

function match(pattern: Pattern, args: readonly Type[]): ResolvedBuiltin | null {
  if (args.length !== pattern.args.length) return null;
  let size = 0;
  let base: ScalarName = pattern.family === 'float' ? 'float' : pattern.family === 'bool' ? 'bool' : 'int';
  for (const [i, type] of args.entries()) {
    const letter = pattern.args[i];
    const count = componentCount(type);
    const scalarName = scalarOf(type);
    if (count === 0 || scalarName === null) return null;
    if (letter === 'b') {
      if (scalarName !== 'bool') return null;
    } else {
      if (pattern.family === 'bool' ? scalarName !== 'bool' : !isNumeric(type)) return null;
      if (pattern.family === 'numeric') base = widerScalar(base, scalarName);
    }
    if (letter === 'f') {
      if (count !== 1) return null;
    } else if (letter === '3') {
      if (count !== 3) return null;
    } else if (letter === 's') {
      if (count > 1 && size > 1 && count !== size) return null;
      size = Math.max(size, count);
    } else if (size === 0 || pattern.args.slice(0, i).includes('s')) {
      if (size > 1 && count !== size) return null;
      size = Math.max(size, count);
    } else if (count !== size) return null;
  }
  if (
    size > 1 &&
    [...pattern.args].some((letter, i) => letter === 'g' && componentCount(args[i] as Type) !== size)
  )
    return null;
  if (pattern.vectors && size < 2) return null;
  const typeOf = (letter: string): Type =>
    letter === 'f'
      ? FLOAT
      : letter === '3'
        ? vector(base, 3)
        : letter === 'b'
          ? vector('bool', size)
          : letter === 'bool'
            ? BOOL
            : vector(base, size);
  const wanted = [...pattern.args].map(typeOf);
  const fits = wanted.every((type, i) => {
    const from = args[i] as Type;
    return (
      convertsImplicitly(from, type) ||
      (componentCount(from) === 1 &&
        pattern.args[i] === 's' &&
        convertsImplicitly(vector(scalarOf(from) as ScalarName, size), type))
    );
  });
  return fits ? { args: wanted, result: typeOf(pattern.result) } : null;
}
