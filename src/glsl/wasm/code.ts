import {
  F32_CONST,
  GLOBAL_GET,
  I32_CONST,
  LOAD,
  LOCAL_GET,
  opcode,
  SELECT,
  signed,
  unsigned,
  type WasmType,
} from './opcodes.ts';

/** Instructions, those of parts as lists of their own. A negative number -k is the function with symbol k - 1. */
export type Bytes = readonly (number | Bytes)[];

/**
 * Instructions that push one value and change nothing. They may be written later than they were made, once;
 * whoever needs the value twice, or before something changes what they read, puts it into a local (body.ts).
 */
export interface Code {
  readonly type: WasmType;
  readonly bytes: Bytes;
  /** About the number of instructions; infinite if it must run only where the program says so. */
  readonly cost: number;
  /** A single instruction whose value stays the same: a constant, or a local that nothing assigns. */
  readonly stable: boolean;
  /** The value of a scalar constant. */
  readonly constant: number | null;
}

const bits = new DataView(new ArrayBuffer(4));

function float32Bytes(value: number): number[] {
  bits.setFloat32(0, value, true);
  return [bits.getUint8(0), bits.getUint8(1), bits.getUint8(2), bits.getUint8(3)];
}

function int32Bytes(value: number): number[] {
  return [value & 0xff, (value >> 8) & 0xff, (value >> 16) & 0xff, (value >> 24) & 0xff];
}

export function f32(value: number): Code {
  return {
    type: 'f32',
    bytes: [F32_CONST, ...float32Bytes(value)],
    cost: 0,
    stable: true,
    constant: Math.fround(value),
  };
}

export function i32(value: number): Code {
  return {
    type: 'i32',
    bytes: [I32_CONST, ...signed(value)],
    cost: 0,
    stable: true,
    constant: value | 0,
  };
}

/** Four lanes of 32 bits. */
export function v128(lanes: readonly number[], kind: 'f32' | 'i32'): Code {
  const bytes = lanes.flatMap(kind === 'f32' ? float32Bytes : int32Bytes);
  return { type: 'v128', bytes: [0xfd, 0x0c, ...bytes], cost: 0, stable: true, constant: null };
}

/** A constant as it lies in memory. */
export function constantBytes(code: Code): readonly number[] {
  // That of a whole number is written with a varying length.
  if (code.type === 'i32') return int32Bytes(code.constant as number);
  return code.bytes.slice(code.type === 'v128' ? 2 : 1) as readonly number[];
}

export function localGet(index: number, type: WasmType, stable: boolean): Code {
  return { type, bytes: [LOCAL_GET, ...unsigned(index)], cost: 0, stable, constant: null };
}

export function globalGet(index: number, type: WasmType): Code {
  return { type, bytes: [GLOBAL_GET, ...unsigned(index)], cost: 1, stable: false, constant: null };
}

const COMPARISON = /^[if]32\.(eqz?|ne|lt|gt|le|ge)(_[su])?$/;

function resultOf(name: string): WasmType {
  if (COMPARISON.test(name) || name.endsWith('_true')) return 'i32';
  const prefix = name.slice(0, name.indexOf('.'));
  if (name.endsWith('extract_lane')) return prefix === 'f32x4' ? 'f32' : 'i32';
  return prefix.includes('x') || prefix === 'v128' ? 'v128' : (prefix as WasmType);
}

/** Instructions that take several times as long as others; and those that take no time. */
const DEAR = /div|rem|sqrt/;
const DEAR_COST = 6;
const FREE = /reinterpret|splat|extract_lane/;

/** An instruction on the values of its arguments. */
export function op(name: string, ...args: readonly Code[]): Code {
  return withImmediate(name, [], args);
}

function withImmediate(name: string, immediate: readonly number[], args: readonly Code[]): Code {
  const bytes = [...args.map((arg) => arg.bytes), opcode(name), immediate];
  const cost = args.reduce(
    (sum, arg) => sum + arg.cost,
    DEAR.test(name) ? DEAR_COST : FREE.test(name) ? 0 : 1,
  );
  return { type: resultOf(name), bytes, cost, stable: false, constant: null };
}

export function extractLane(kind: 'f32' | 'i32', vector: Code, lane: number): Code {
  return withImmediate(`${kind}x4.extract_lane`, [lane], [vector]);
}

export function replaceLane(kind: 'f32' | 'i32', vector: Code, lane: number, value: Code): Code {
  return withImmediate(`${kind}x4.replace_lane`, [lane], [vector, value]);
}

/** The lanes of two vectors, numbered 0 to 3 and 4 to 7, in a new order. */
export function shuffle(a: Code, b: Code, lanes: readonly number[]): Code {
  const bytes = lanes.flatMap((lane) => [4 * lane, 4 * lane + 1, 4 * lane + 2, 4 * lane + 3]);
  return {
    type: 'v128',
    bytes: [a.bytes, b.bytes, 0xfd, 0x0d, ...bytes],
    cost: a.cost + b.cost + 1,
    stable: false,
    constant: null,
  };
}

/**
 * test ? yes : no, where both are computed. Only whole numbers have an instruction for it in V8, others a
 * branch: so floats are chosen by their bits, and vectors by a mask.
 */
export function select(test: Code, yes: Code, no: Code): Code {
  if (test.constant !== null) return test.constant !== 0 ? yes : no;
  if (yes.type === 'v128')
    return op('v128.bitselect', yes, no, op('i32x4.splat', op('i32.sub', i32(0), test)));
  if (yes.type === 'f32') {
    const [a, b] = [op('i32.reinterpret_f32', yes), op('i32.reinterpret_f32', no)];
    return op('f32.reinterpret_i32', select(test, a, b));
  }
  return {
    type: yes.type,
    bytes: [yes.bytes, no.bytes, test.bytes, SELECT],
    cost: yes.cost + no.cost + test.cost + 1,
    stable: false,
    constant: null,
  };
}

/** @param cost infinite where the address may lie outside the memory if the program did not ask for it */
export function load(type: WasmType, address: Code, offset: number, cost: number): Code {
  return {
    type,
    bytes: [address.bytes, ...LOAD[type], ...unsigned(offset)],
    cost: address.cost + cost,
    stable: false,
    constant: null,
  };
}
