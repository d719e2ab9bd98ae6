import type { Value } from '../ir.ts';
import type { ScalarName, Type } from '../types.ts';
import { type Code, f32, i32, v128 } from './code.ts';
import { SIZES, type WasmType } from './opcodes.ts';

/**
 * How values lie in WebAssembly: as a list of cells. A scalar is one cell, vec2 and vec3 two and three, and a
 * vector of four is one of 128 bits, whose lanes hold 0 and -1 where its components are bools. Matrices are
 * their columns, structs their fields and arrays their elements, one after the other. A table of measured
 * data is the word of the scene's memory where it starts, and the number of its triples.
 */

export function scalarCell(name: ScalarName): 'f32' | 'i32' {
  return name === 'float' ? 'f32' : 'i32';
}

const known = new WeakMap<Type, readonly WasmType[]>();

export function cellsOf(type: Type): readonly WasmType[] {
  const cells = known.get(type) ?? computeCells(type);
  known.set(type, cells);
  return cells;
}

function vectorCells(name: ScalarName, size: number): WasmType[] {
  return size === 4 ? ['v128'] : new Array<WasmType>(size).fill(scalarCell(name));
}

function computeCells(type: Type): WasmType[] {
  switch (type.kind) {
    case 'void':
      return [];
    case 'table':
      return ['i32', 'i32'];
    case 'scalar':
      return [scalarCell(type.scalar)];
    case 'vector':
      return vectorCells(type.scalar, type.size);
    case 'matrix':
      return Array.from({ length: type.columns }, () => vectorCells('float', type.rows)).flat();
    case 'struct':
      return type.fields.flatMap((field) => cellsOf(field.type));
    case 'array': {
      const element = cellsOf(type.element);
      return Array.from({ length: type.length }, () => element).flat();
    }
  }
}

/** Where the field of a struct starts, in cells. */
export function fieldStart(type: Extract<Type, { kind: 'struct' }>, field: number): number {
  return type.fields.slice(0, field).reduce((sum, { type: t }) => sum + cellsOf(t).length, 0);
}

/** Bytes of cells in memory, one after the other. */
export function sizeOf(cells: readonly WasmType[]): number {
  return cells.reduce((sum, cell) => sum + SIZES[cell], 0);
}

/** A known value as cells. */
export function constantCells(value: Value, type: Type): Code[] {
  switch (type.kind) {
    case 'void':
    case 'table':
      return [];
    case 'scalar':
      return [scalarConstant(value as number | boolean, type.scalar)];
    case 'vector':
      return vectorConstant(value as readonly Value[], type.scalar);
    case 'matrix':
      return Array.from({ length: type.columns }, (_, c) =>
        vectorConstant((value as readonly Value[]).slice(c * type.rows, (c + 1) * type.rows), 'float'),
      ).flat();
    case 'struct':
      return type.fields.flatMap((field, i) =>
        constantCells((value as readonly Value[])[i] as Value, field.type),
      );
    case 'array':
      return (value as readonly Value[]).flatMap((element) => constantCells(element, type.element));
  }
}

function scalarConstant(value: number | boolean, name: ScalarName): Code {
  return name === 'float' ? f32(value as number) : i32(Number(value));
}

function vectorConstant(values: readonly Value[], name: ScalarName): Code[] {
  if (values.length < 4) return values.map((value) => scalarConstant(value as number | boolean, name));
  const lanes = values.map((value) => (name === 'bool' ? -Number(value) : Number(value)));
  return [v128(lanes, scalarCell(name))];
}

/** What an uninitialised variable holds. */
export function zeroCells(type: Type): Code[] {
  return cellsOf(type).map((cell) =>
    cell === 'v128' ? v128([0, 0, 0, 0], 'i32') : cell === 'f32' ? f32(0) : i32(0),
  );
}
