/** The types of GLSL that a BRDF may use. Types are interned: two equal types are the same object. */
export type ScalarName = 'float' | 'int' | 'uint' | 'bool';

export interface VoidType {
  readonly kind: 'void';
  readonly name: 'void';
}
export interface ScalarType {
  readonly kind: 'scalar';
  readonly name: ScalarName;
  readonly scalar: ScalarName;
}
export interface VectorType {
  readonly kind: 'vector';
  readonly name: string;
  readonly scalar: ScalarName;
  readonly size: 2 | 3 | 4;
}
/** Columns of floats, as in GLSL: matCxR has C columns of R rows. */
export interface MatrixType {
  readonly kind: 'matrix';
  readonly name: string;
  readonly columns: 2 | 3 | 4;
  readonly rows: 2 | 3 | 4;
}
export interface StructType {
  readonly kind: 'struct';
  readonly name: string;
  readonly fields: readonly { readonly name: string; readonly type: Type }[];
}
export interface ArrayType {
  readonly kind: 'array';
  readonly name: string;
  readonly element: Type;
  readonly length: number;
}
/** A model's measured data: RGB triples, read by fetchData(). Nothing in a file can name this type. */
export interface TableType {
  readonly kind: 'table';
  readonly name: 'table';
}
export type Type = TableType | VoidType | ScalarType | VectorType | MatrixType | StructType | ArrayType;

export const VOID: VoidType = { kind: 'void', name: 'void' };
export const TABLE: TableType = { kind: 'table', name: 'table' };

const scalars = new Map<ScalarName, ScalarType>(
  (['float', 'int', 'uint', 'bool'] as const).map((name) => [name, { kind: 'scalar', name, scalar: name }]),
);
export const FLOAT = scalar('float');
export const INT = scalar('int');
export const UINT = scalar('uint');
export const BOOL = scalar('bool');

const VECTOR_PREFIX: Record<ScalarName, string> = { float: 'vec', int: 'ivec', uint: 'uvec', bool: 'bvec' };
const builtIn = new Map<string, Type>([
  ['void', VOID],
  ...[...scalars].map(([n, t]) => [n as string, t as Type] as const),
]);
const SIZES = [2, 3, 4] as const;
for (const [name, prefix] of Object.entries(VECTOR_PREFIX)) {
  for (const size of SIZES) {
    builtIn.set(`${prefix}${size}`, {
      kind: 'vector',
      name: `${prefix}${size}`,
      scalar: name as ScalarName,
      size,
    });
  }
}
for (const columns of SIZES) {
  for (const rows of SIZES) {
    const name = columns === rows ? `mat${columns}` : `mat${columns}x${rows}`;
    const matrix: MatrixType = { kind: 'matrix', name, columns, rows };
    builtIn.set(name, matrix);
    if (columns === rows) builtIn.set(`mat${columns}x${rows}`, matrix);
  }
}
const arrays = new Map<Type, Map<number, ArrayType>>();

/** The built-in type of this name. */
export function typeNamed(name: string): Type | undefined {
  return builtIn.get(name);
}

export function scalar(name: ScalarName): ScalarType {
  return scalars.get(name) as ScalarType;
}

/** A vector of `size` components, or the scalar if size is 1. */
export function vector(name: ScalarName, size: number): ScalarType | VectorType {
  return size === 1 ? scalar(name) : (builtIn.get(`${VECTOR_PREFIX[name]}${size}`) as VectorType);
}

export function matrix(columns: number, rows: number): MatrixType {
  return builtIn.get(columns === rows ? `mat${columns}` : `mat${columns}x${rows}`) as MatrixType;
}

export function arrayOf(element: Type, length: number): ArrayType {
  const lengths = arrays.get(element) ?? new Map<number, ArrayType>();
  arrays.set(element, lengths);
  const type = lengths.get(length) ?? { kind: 'array', name: `${element.name}[${length}]`, element, length };
  lengths.set(length, type);
  return type;
}

/** Number of components of a scalar (1) or vector; 0 for every other type. */
export function componentCount(type: Type): number {
  return type.kind === 'scalar' ? 1 : type.kind === 'vector' ? type.size : 0;
}

/** The component type of scalars, vectors and matrices. */
export function scalarOf(type: Type): ScalarName | null {
  return type.kind === 'scalar' || type.kind === 'vector'
    ? type.scalar
    : type.kind === 'matrix'
      ? 'float'
      : null;
}

export function isNumeric(type: Type): boolean {
  const base = scalarOf(type);
  return base !== null && base !== 'bool';
}

const RANK: Record<ScalarName, number> = { bool: -1, int: 0, uint: 1, float: 2 };

/** GLSL's implicit conversions: int to uint to float, component by component; never bool. */
export function convertsImplicitly(from: Type, to: Type): boolean {
  if (from === to) return true;
  const a = componentCount(from);
  if (a === 0 || a !== componentCount(to)) return false;
  const [f, t] = [RANK[scalarOf(from) as ScalarName], RANK[scalarOf(to) as ScalarName]];
  return f >= 0 && t >= 0 && f <= t;
}

/** The wider of two component types (float over uint over int). */
export function widerScalar(a: ScalarName, b: ScalarName): ScalarName {
  return RANK[a] >= RANK[b] ? a : b;
}
