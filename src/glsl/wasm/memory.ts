import type { Expr } from '../ir.ts';
import type { Body } from './body.ts';
import { type Code, globalGet, i32, load, op } from './code.ts';
import { STORE, unsigned, type WasmType } from './opcodes.ts';
import { clampIndex } from './places.ts';
import type { Unit } from './unit.ts';

type Cells = readonly Code[];

/** An address may lie beyond the memory where the program did not mean to read: never in advance. */
const NEVER_EARLY = Number.POSITIVE_INFINITY;

const LOADS: Record<string, { from: 'scene' | 'film'; shift: number; type: WasmType }> = {
  loadUint4: { from: 'scene', shift: 4, type: 'v128' },
  loadFloat4: { from: 'scene', shift: 4, type: 'v128' },
  loadUint: { from: 'scene', shift: 2, type: 'i32' },
  loadFloat: { from: 'scene', shift: 2, type: 'f32' },
  filmLoad: { from: 'film', shift: 4, type: 'v128' },
};

/** Whether this reads 4 or 16 bytes at an index, and nothing else. */
export function isLoad(name: string): boolean {
  return name in LOADS;
}

/**
 * A read at `index + constant`. The constant becomes a part of the instruction, so that neighbours have one
 * address, which V8 computes once.
 */
export function loadAt(unit: Unit, name: string, index: Code | null, constant: number): Code {
  const { from, shift, type } = LOADS[name] as (typeof LOADS)[string];
  const start = index ? address(unit, from, index, shift) : globalGet(unit[from], 'i32');
  return load(type, start, constant << shift, NEVER_EARLY);
}

/** An index as what varies, if anything does, and a constant that is not negative. */
export function splitIndex(index: Expr): { readonly varying: Expr | null; readonly constant: number } {
  const parts = split(index);
  return parts.constant < 0 ? { varying: index, constant: 0 } : parts;
}

function split(e: Expr): { varying: Expr | null; constant: number } {
  if (e.kind === 'literal') return { varying: null, constant: e.value as number };
  if (e.kind !== 'binary' || (e.operator !== '+' && e.operator !== '-')) return { varying: e, constant: 0 };
  const [left, right] = [split(e.left), split(e.right)];
  const sign = e.operator === '+' ? 1 : -1;
  const constant = left.constant + sign * right.constant;
  if (right.varying === null) return { varying: left.varying, constant };
  if (left.varying !== null) return { varying: { ...e, left: left.varying, right: right.varying }, constant };
  return sign > 0 ? { varying: right.varying, constant } : { varying: e, constant: 0 };
}

/** Other functions that read and write memory and look at numbers as bits; null for others. */
export function memoryBuiltin(
  unit: Unit,
  body: Body,
  e: Extract<Expr, { kind: 'builtin' }>,
  args: readonly Cells[],
): Cells | null {
  const [a, b] = args as readonly [Cells, Cells];
  switch (e.name) {
    case 'filmStore':
      body.push(address(unit, 'film', a[0] as Code, 4).bytes);
      body.push((b[0] as Code).bytes);
      body.push([...STORE.v128, ...unsigned(0)]);
      return [];
    case 'fetchData': {
      const [word, count] = body.pinAll(a) as [Code, Code];
      const i = clampIndex(body, b[0] as Code, true, count);
      const first = op('i32.add', word, op('i32.mul', i, i32(3)));
      const base = body.pin(address(unit, 'scene', first, 2));
      return [0, 4, 8].map((offset) => load('f32', base, offset, NEVER_EARLY));
    }
    case 'floatBitsToUint':
    case 'floatBitsToInt':
      return a.map((cell) => (cell.type === 'v128' ? cell : op('i32.reinterpret_f32', cell)));
    case 'uintBitsToFloat':
    case 'intBitsToFloat':
      return a.map((cell) => (cell.type === 'v128' ? cell : op('f32.reinterpret_i32', cell)));
    case 'bitfieldReverse':
      return a.map((cell) => reverseBits(body, cell));
    default:
      return null;
  }
}

function address(unit: Unit, from: 'scene' | 'film', index: Code, shift: number): Code {
  return op('i32.add', globalGet(unit[from], 'i32'), op('i32.shl', index, i32(shift)));
}

/** Neighbours change places: bits, then pairs, ..., then halves. */
function reverseBits(body: Body, cell: Code): Code {
  const wide = cell.type === 'v128';
  const shift = (which: 'shl' | 'shr_u', x: Code, by: number) =>
    op(`${wide ? 'i32x4' : 'i32'}.${which}`, x, i32(by));
  const both = (which: 'and' | 'or', x: Code, y: Code) => op(`${wide ? 'v128' : 'i32'}.${which}`, x, y);
  const masks = [0x55555555, 0x33333333, 0x0f0f0f0f, 0x00ff00ff, 0x0000ffff];
  return masks.reduce((value, mask, i) => {
    const x = body.pin(value);
    const pattern = wide ? op('i32x4.splat', i32(mask)) : i32(mask);
    const [low, high] = [both('and', x, pattern), both('and', shift('shr_u', x, 1 << i), pattern)];
    return both('or', shift('shl', low, 1 << i), high);
  }, cell);
}
