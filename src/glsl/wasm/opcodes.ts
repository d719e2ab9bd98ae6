/** Instructions of WebAssembly by the names of its text format (WebAssembly 2.0, section 5.4). */

const names = new Map<string, readonly number[]>();

function consecutive(first: number, list: string): void {
  for (const [i, name] of list.split(' ').entries()) names.set(name, [first + i]);
}

function simd(first: number, list: string): void {
  for (const [i, name] of list.split(' ').entries()) names.set(name, [0xfd, ...unsigned(first + i)]);
}

consecutive(
  0x45,
  'i32.eqz i32.eq i32.ne i32.lt_s i32.lt_u i32.gt_s i32.gt_u i32.le_s i32.le_u i32.ge_s i32.ge_u',
);
consecutive(0x5b, 'f32.eq f32.ne f32.lt f32.gt f32.le f32.ge');
consecutive(
  0x67,
  'i32.clz i32.ctz i32.popcnt i32.add i32.sub i32.mul i32.div_s i32.div_u i32.rem_s i32.rem_u i32.and i32.or i32.xor i32.shl i32.shr_s i32.shr_u',
);
consecutive(
  0x8b,
  'f32.abs f32.neg f32.ceil f32.floor f32.trunc f32.nearest f32.sqrt f32.add f32.sub f32.mul f32.div f32.min f32.max f32.copysign',
);
consecutive(0xb2, 'f32.convert_i32_s f32.convert_i32_u');
consecutive(0xb6, 'f32.demote_f64');
consecutive(0xbb, 'f64.promote_f32 i32.reinterpret_f32');
consecutive(0xbe, 'f32.reinterpret_i32');
names.set('i32.trunc_sat_f32_s', [0xfc, 0]);
names.set('i32.trunc_sat_f32_u', [0xfc, 1]);
simd(0x11, 'i32x4.splat');
simd(0x13, 'f32x4.splat');
simd(0x1b, 'i32x4.extract_lane i32x4.replace_lane');
simd(0x1f, 'f32x4.extract_lane f32x4.replace_lane');
simd(
  0x37,
  'i32x4.eq i32x4.ne i32x4.lt_s i32x4.lt_u i32x4.gt_s i32x4.gt_u i32x4.le_s i32x4.le_u i32x4.ge_s i32x4.ge_u f32x4.eq f32x4.ne f32x4.lt f32x4.gt f32x4.le f32x4.ge',
);
simd(0x4d, 'v128.not v128.and v128.andnot v128.or v128.xor v128.bitselect v128.any_true');
simd(0x67, 'f32x4.ceil f32x4.floor f32x4.trunc f32x4.nearest');
simd(0xa0, 'i32x4.abs i32x4.neg');
simd(0xa3, 'i32x4.all_true');
simd(0xab, 'i32x4.shl i32x4.shr_s i32x4.shr_u i32x4.add');
simd(0xb1, 'i32x4.sub');
simd(0xb5, 'i32x4.mul i32x4.min_s i32x4.min_u i32x4.max_s i32x4.max_u');
simd(0xe0, 'f32x4.abs f32x4.neg');
simd(0xe3, 'f32x4.sqrt f32x4.add f32x4.sub f32x4.mul f32x4.div f32x4.min f32x4.max f32x4.pmin f32x4.pmax');
simd(0xf8, 'i32x4.trunc_sat_f32x4_s i32x4.trunc_sat_f32x4_u f32x4.convert_i32x4_s f32x4.convert_i32x4_u');

/** The bytes of an instruction without immediates. */
export function opcode(name: string): readonly number[] {
  const bytes = names.get(name);
  if (!bytes) throw new Error(`no instruction ${name}`);
  return bytes;
}

export const BLOCK = 0x02;
export const LOOP = 0x03;
export const IF = 0x04;
export const ELSE = 0x05;
export const END = 0x0b;
export const BR = 0x0c;
export const BR_IF = 0x0d;
export const CALL = 0x10;
export const SELECT = 0x1b;
export const LOCAL_GET = 0x20;
export const LOCAL_SET = 0x21;
export const GLOBAL_GET = 0x23;
export const GLOBAL_SET = 0x24;
export const I32_CONST = 0x41;
export const F32_CONST = 0x43;
/** Copies from the first data segment into memory. */
export const MEMORY_INIT = [0xfc, 8, 0, 0];
/** The type of a block without a value. */
export const EMPTY = 0x40;

export type WasmType = 'i32' | 'f32' | 'f64' | 'v128';
export const TYPE_CODES: Record<WasmType, number> = { i32: 0x7f, f32: 0x7d, f64: 0x7c, v128: 0x7b };
export const SIZES: Record<WasmType, number> = { i32: 4, f32: 4, f64: 8, v128: 16 };
export const LOAD: Record<WasmType, readonly number[]> = {
  i32: [0x28, 2],
  f32: [0x2a, 2],
  f64: [0x2b, 3],
  v128: [0xfd, 0, 4],
};
export const STORE: Record<WasmType, readonly number[]> = {
  i32: [0x36, 2],
  f32: [0x38, 2],
  f64: [0x39, 3],
  v128: [0xfd, 0x0b, 4],
};

/** LEB128 of a number from 0 to 2^32 - 1. */
export function unsigned(value: number): number[] {
  const bytes: number[] = [];
  let rest = value >>> 0;
  do {
    const low = rest & 0x7f;
    rest >>>= 7;
    bytes.push(rest === 0 ? low : low | 0x80);
  } while (rest !== 0);
  return bytes;
}

/** LEB128 of a number from -2^31 to 2^31 - 1. */
export function signed(value: number): number[] {
  const bytes: number[] = [];
  let rest = value | 0;
  for (;;) {
    const low = rest & 0x7f;
    rest >>= 7;
    if ((rest === 0 && (low & 0x40) === 0) || (rest === -1 && (low & 0x40) !== 0)) {
      bytes.push(low);
      return bytes;
    }
    bytes.push(low | 0x80);
  }
}
