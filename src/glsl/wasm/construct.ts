import { componentCount, type MatrixType, type ScalarName, scalarOf, type Type, vector } from '../types.ts';
import type { Body } from './body.ts';
import { type Code, f32, op } from './code.ts';
import { cellsOf } from './layout.ts';
import { components, compose, one, splat } from './vectors.ts';

/** Constructors and conversions: T(args). */
export function construct(
  body: Body,
  type: Type,
  args: readonly (readonly Code[])[],
  types: readonly Type[],
): readonly Code[] {
  if (type.kind === 'struct' || type.kind === 'array') return args.flat();
  if (type.kind === 'matrix') return constructMatrix(body, type, args, types);
  const [cells, from] = [args[0] as readonly Code[], types[0] as Type];
  const [base, target] = [scalarOf(from) as ScalarName, scalarOf(type) as ScalarName];
  const size = componentCount(type);
  if (args.length > 1) {
    const parts = args.flatMap((arg, i) => [...components(body, arg, types[i] as Type)]);
    return compose(body, parts.slice(0, size), target);
  }
  const fromSize = componentCount(from);
  if (fromSize === size) return cells.map((cell) => convert(cell, base, target));
  if (fromSize === 1) {
    const value = body.pin(convert(cells[0] as Code, base, target));
    return size === 4 ? [splat(value, target)] : new Array<Code>(size).fill(value);
  }
  const parts = components(body, cells, from).slice(0, size);
  return compose(
    body,
    parts.map((part) => convert(part, base, target)),
    target,
  );
}

/** One cell from one component type to another. */
function convert(cell: Code, from: ScalarName, to: ScalarName): Code {
  if (from === to || (from !== 'float' && to !== 'float' && from !== 'bool' && to !== 'bool')) return cell;
  const wide = cell.type === 'v128';
  if (from === 'bool') {
    if (wide) return op('v128.and', cell, one(cell, to));
    return to === 'float' ? op('f32.convert_i32_u', cell) : cell;
  }
  if (to === 'bool') {
    const [prefix, zero] = from === 'float' ? ['f32', f32(0)] : ['i32', null];
    if (!wide) return zero ? op('f32.ne', cell, zero) : op('i32.eqz', op('i32.eqz', cell));
    return op(`${prefix}x4.ne`, cell, splat(f32(0), 'float'));
  }
  // Out of range, GLSL leaves the result open; saturating never traps.
  if (from === 'float') {
    const sign = to === 'int' ? 's' : 'u';
    return op(wide ? `i32x4.trunc_sat_f32x4_${sign}` : `i32.trunc_sat_f32_${sign}`, cell);
  }
  const sign = from === 'int' ? 's' : 'u';
  return op(wide ? `f32x4.convert_i32x4_${sign}` : `f32.convert_i32_${sign}`, cell);
}

function constructMatrix(
  body: Body,
  type: MatrixType,
  args: readonly (readonly Code[])[],
  types: readonly Type[],
): readonly Code[] {
  const [cells, from] = [args[0] as readonly Code[], types[0] as Type];
  const columns = (at: (column: number, row: number) => Code): readonly Code[] =>
    Array.from({ length: type.columns }, (_, c) =>
      compose(
        body,
        Array.from({ length: type.rows }, (__, r) => at(c, r)),
        'float',
      ),
    ).flat();
  if (args.length === 1 && from.kind === 'scalar') {
    const value = body.pin(cells[0] as Code);
    return columns((c, r) => (c === r ? value : f32(0)));
  }
  if (args.length === 1 && from.kind === 'matrix') {
    const parts = matrixComponents(body, cells, from);
    return columns((c, r) => parts[c]?.[r] ?? f32(c === r ? 1 : 0));
  }
  const parts = args.flatMap((arg, i) => [...components(body, arg, types[i] as Type)]);
  return columns((c, r) => parts[c * type.rows + r] as Code);
}

/** The components of a matrix, by column and row. */
export function matrixComponents(
  body: Body,
  cells: readonly Code[],
  type: MatrixType,
): readonly (readonly Code[])[] {
  const column = vector('float', type.rows);
  const count = cellsOf(column).length;
  return Array.from({ length: type.columns }, (_, c) =>
    components(body, cells.slice(c * count, (c + 1) * count), column),
  );
}
