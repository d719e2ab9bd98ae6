import { componentCount, type ScalarName, scalarOf, type Type, vector } from '../types.ts';
import type { Body } from './body.ts';
import { type Bytes, type Code, i32, load, localGet, op, replaceLane, select } from './code.ts';
import { cellsOf, scalarCell, sizeOf } from './layout.ts';
import { LOCAL_SET, SIZES, STORE, unsigned } from './opcodes.ts';
import { components, compose } from './vectors.ts';

/** Where one cell of a variable is kept. */
export interface Ref {
  readonly get: Code;
  /** The instructions before and after those of a value that is stored. */
  readonly before: Bytes;
  readonly after: Bytes;
}

/** Where a variable or a part of it is kept: cell by cell, or in memory. */
export type Place =
  | { readonly kind: 'cells'; readonly refs: readonly Ref[] }
  | { readonly kind: 'memory'; readonly base: Code; readonly offset: number };

/** What is assigned to: a place, and which components of the vector there. */
export interface Target {
  readonly place: Place;
  readonly type: Type;
  readonly components: readonly number[] | null;
  /** One of `components`, or of all, chosen while the function runs. */
  readonly choice: Code | null;
}

export function localRef(index: number, code: Code): Ref {
  return { get: code, before: [], after: [LOCAL_SET, ...unsigned(index)] };
}

/** A place in locals that are free until the present scope ends. */
export function localPlace(body: Body, type: Type, stable: boolean): Place {
  const refs = cellsOf(type).map((cell) => {
    const index = body.local(cell);
    return localRef(index, localGet(index, cell, stable));
  });
  return { kind: 'cells', refs };
}

/** A place that holds what is known already and is never assigned. */
export function valuePlace(codes: readonly Code[]): Place {
  return { kind: 'cells', refs: codes.map((get) => ({ get, before: [], after: [] })) };
}

/** What a read of the stack costs. */
const READ_COST = 3;

/** The cells of a place that holds a value of this type. */
function refsOf(body: Body, place: Place, type: Type): readonly Ref[] {
  if (place.kind === 'cells') return place.refs;
  const base = body.pin(place.base);
  let { offset } = place;
  return cellsOf(type).map((cell): Ref => {
    const at = offset;
    offset += SIZES[cell];
    return {
      get: load(cell, base, at, READ_COST),
      before: base.bytes,
      after: [...STORE[cell], ...unsigned(at)],
    };
  });
}

/** The part of a place that starts at this cell. */
export function partOf(place: Place, whole: Type, start: number, part: Type): Place {
  if (place.kind === 'cells')
    return { kind: 'cells', refs: place.refs.slice(start, start + cellsOf(part).length) };
  return { ...place, offset: place.offset + sizeOf(cellsOf(whole).slice(0, start)) };
}

export function readPlace(body: Body, place: Place, type: Type): readonly Code[] {
  return refsOf(body, place, type).map(({ get }) => get);
}

export function writePlace(body: Body, place: Place, type: Type, codes: readonly Code[]): void {
  storeRefs(body, refsOf(body, place, type), codes);
}

function storeRefs(body: Body, refs: readonly Ref[], codes: readonly Code[]): void {
  const inMemory = refs.some(({ before }) => before.length > 0);
  // Every value before the first store: a later one may read what an earlier store changes.
  const values = inMemory && codes.length > 1 ? body.pinAll(codes) : codes;
  if (inMemory) {
    for (const [i, { before, after }] of refs.entries()) {
      body.push(before);
      body.push((values[i] as Code).bytes);
      body.push(after);
    }
    return;
  }
  for (const value of values) body.push(value.bytes);
  for (const { after } of refs.toReversed()) body.push(after);
}

export function readTarget(body: Body, target: Target): readonly Code[] {
  const cells = readPlace(body, target.place, target.type);
  if (target.components === null && target.choice === null) return cells;
  const parts = components(body, cells, target.type);
  const chosen = target.components?.map((k) => parts[k] as Code) ?? parts;
  if (target.choice) return [choose(target.choice, chosen)];
  return compose(body, chosen, scalarOf(target.type) as ScalarName);
}

/** The component of this number. */
export function choose(choice: Code, parts: readonly Code[]): Code {
  const [first, ...rest] = parts as [Code, ...Code[]];
  return rest.reduce((found, part, i) => select(op('i32.eq', choice, i32(i + 1)), part, found), first);
}

export function writeTarget(body: Body, target: Target, codes: readonly Code[]): void {
  const { place, type } = target;
  if (target.components === null && target.choice === null) {
    writePlace(body, place, type, codes);
    return;
  }
  const name = scalarOf(type) as ScalarName;
  const lanes = target.components ?? Array.from({ length: componentCount(type) }, (_, k) => k);
  const refs = refsOf(body, place, type);
  const { choice } = target;
  if (choice) {
    const value = body.pin(codes[0] as Code);
    const before = components(
      body,
      refs.map(({ get }) => get),
      type,
    );
    const after = before.map((part, k) =>
      lanes.includes(k) ? select(op('i32.eq', choice, i32(lanes.indexOf(k))), value, part) : part,
    );
    storeRefs(body, refs, compose(body, after, name));
    return;
  }
  const values = components(body, codes, vector(name, lanes.length));
  if (componentCount(type) < 4) {
    storeRefs(
      body,
      lanes.map((k) => refs[k] as Ref),
      values,
    );
    return;
  }
  const [ref] = refs as readonly [Ref];
  const kind = scalarCell(name);
  const changed = values.reduce(
    (whole, value, i) =>
      replaceLane(kind, whole, lanes[i] as number, name === 'bool' ? op('i32.sub', i32(0), value) : value),
    ref.get,
  );
  storeRefs(body, [ref], lanes.length === 4 ? composed(body, lanes, values, name) : [changed]);
}

/** All four components at once, given in the order of `lanes`. */
function composed(
  body: Body,
  lanes: readonly number[],
  values: readonly Code[],
  name: ScalarName,
): readonly Code[] {
  return compose(
    body,
    [0, 1, 2, 3].map((k) => values[lanes.indexOf(k)] as Code),
    name,
  );
}

/** An index kept from 0 to length - 1; out of range is undefined in GLSL, and must not reach other memory. */
export function clampIndex(body: Body, index: Code, isSigned: boolean, length: Code): Code {
  let i = body.pin(index);
  if (isSigned) i = body.temporary(select(op('i32.lt_s', i, i32(0)), i32(0), i));
  const last = length.constant === null ? op('i32.sub', length, i32(1)) : i32(length.constant - 1);
  return body.temporary(select(op('i32.lt_u', i, length), i, last));
}
