import { type Bytes, type Code, globalGet, localGet } from './code.ts';
import {
  BLOCK,
  BR,
  BR_IF,
  ELSE,
  EMPTY,
  END,
  GLOBAL_SET,
  I32_CONST,
  IF,
  LOCAL_SET,
  LOOP,
  opcode,
  signed,
  unsigned,
  type WasmType,
} from './opcodes.ts';

/** A place to branch to: how many constructs were open inside it. */
export type Label = number;

/** The body of one function while it is written: instructions, locals and the frame of its arrays. */
export class Body {
  /** The instructions of the innermost construct that is being written. */
  private bytes: number[] = [];
  private readonly types: WasmType[];
  private readonly parameters: number;
  private readonly free: Record<WasmType, number[]> = { i32: [], f32: [], f64: [], v128: [] };
  private scope: number[] = [];
  private depth = 0;
  private frameTop = 0;
  private frameSize = 0;
  private frameLocals: { base: number; saved: number } | null = null;

  constructor(parameters: readonly WasmType[]) {
    this.types = [...parameters];
    this.parameters = parameters.length;
  }

  push(bytes: Bytes): void {
    for (const byte of bytes) {
      if (typeof byte === 'number') this.bytes.push(byte);
      else this.push(byte);
    }
  }

  /** A local that is free until the present scope ends. */
  local(type: WasmType): number {
    const index = this.free[type].pop() ?? this.types.push(type) - 1;
    this.scope.push(index);
    return index;
  }

  /** Locals and room in the frame that `write` takes are free again after it. */
  scoped(write: () => void): void {
    const [outer, top] = [this.scope, this.frameTop];
    this.scope = [];
    write();
    for (const index of this.scope) this.free[this.types[index] as WasmType].push(index);
    this.scope = outer;
    this.frameTop = top;
  }

  set(index: number): void {
    this.push([LOCAL_SET, ...unsigned(index)]);
  }

  /** The value in a local of its own, computed here. */
  temporary(code: Code): Code {
    const index = this.local(code.type);
    this.push(code.bytes);
    this.set(index);
    return localGet(index, code.type, true);
  }

  /** The value, computed here if what it reads could change. */
  pin(code: Code): Code {
    return code.stable ? code : this.temporary(code);
  }

  pinAll(codes: readonly Code[]): Code[] {
    return codes.map((code) => this.pin(code));
  }

  /** Instructions that `write` writes, apart from the others; they will stand inside one more construct. */
  apart(write: () => void): readonly number[] {
    const outer = this.bytes;
    this.bytes = [];
    this.depth++;
    write();
    this.depth--;
    const inner = this.bytes;
    this.bytes = outer;
    return inner;
  }

  if(test: Code, yes: readonly number[], no: readonly number[]): void {
    if (yes.length === 0 && no.length === 0) return;
    this.push(test.bytes);
    if (yes.length === 0) this.push(opcode('i32.eqz'));
    this.push([IF, EMPTY]);
    this.push(yes.length === 0 ? no : yes);
    if (yes.length > 0 && no.length > 0) {
      this.push([ELSE]);
      this.push(no);
    }
    this.push([END]);
  }

  /** A block; its label is left by branching to it. */
  block(write: (end: Label) => void): void {
    this.construct(BLOCK, write);
  }

  /** A loop; branching to its label starts it again. */
  loop(write: (start: Label) => void): void {
    this.construct(LOOP, write);
  }

  private construct(opening: number, write: (label: Label) => void): void {
    this.push([opening, EMPTY]);
    this.depth++;
    write(this.depth);
    this.depth--;
    this.push([END]);
  }

  branch(label: Label): void {
    this.push([BR, ...unsigned(this.depth - label)]);
  }

  branchIf(test: Code, label: Label): void {
    this.push(test.bytes);
    this.push([BR_IF, ...unsigned(this.depth - label)]);
  }

  /** Room in the function's frame on the stack in memory, free until the present scope ends. */
  reserve(size: number): { base: Code; offset: number } {
    this.frameLocals ??= { base: this.types.push('i32') - 1, saved: this.types.push('i32') - 1 };
    const offset = this.frameTop;
    this.frameTop += Math.ceil(size / 16) * 16;
    this.frameSize = Math.max(this.frameSize, this.frameTop);
    return { base: localGet(this.frameLocals.base, 'i32', true), offset };
  }

  /**
   * The finished function: its locals beyond the parameters, and its instructions.
   *
   * @param stack the global that holds the stack's end
   */
  finish(results: readonly Code[], stack: number): { locals: readonly WasmType[]; bytes: number[] } {
    const written = this.bytes;
    this.bytes = [];
    const set = [GLOBAL_SET, ...unsigned(stack)];
    if (this.frameLocals) {
      const { base, saved } = this.frameLocals;
      this.push([globalGet(stack, 'i32').bytes, LOCAL_SET, unsigned(saved)]);
      this.push([localGet(saved, 'i32', true).bytes, I32_CONST, signed(this.frameSize), opcode('i32.sub')]);
      this.push([LOCAL_SET, unsigned(base), localGet(base, 'i32', true).bytes, set]);
    }
    this.push(written);
    this.push(results.map(({ bytes }) => bytes));
    if (this.frameLocals) this.push([localGet(this.frameLocals.saved, 'i32', true).bytes, set]);
    this.push([END]);
    return { locals: this.types.slice(this.parameters), bytes: this.bytes };
  }
}
