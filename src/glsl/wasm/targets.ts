import { evaluateExpression } from '../float64.ts';
import type { Expr, Variable } from '../ir.ts';
import { componentCount, INT, type ScalarName, scalarOf, type Type } from '../types.ts';
import { type Code, i32, op } from './code.ts';
import { hasEffects } from './effects.ts';
import { ExpressionWriter } from './expression.ts';
import { cellsOf, fieldStart, sizeOf } from './layout.ts';
import { arithmetic } from './operators.ts';
import {
  choose,
  clampIndex,
  type Place,
  partOf,
  readTarget,
  type Target,
  writePlace,
  writeTarget,
} from './places.ts';
import { components, one } from './vectors.ts';

/** More elements than this are put into memory to choose one of them. */
const MAX_CHOSEN = 4;

type Index = Extract<Expr, { kind: 'index' }>;

/** Writes assignments: where variables and their parts are kept. */
export abstract class TargetWriter extends ExpressionWriter {
  protected placeOf(variable: Variable): Place {
    const place = this.places.get(variable) ?? this.unit.place(variable);
    if (!place) throw new Error(`unreachable: ${variable.name} is read before it is declared`);
    return place;
  }

  protected target(e: Expr): Target {
    switch (e.kind) {
      case 'variable':
        return { place: this.placeOf(e.variable), type: e.type, components: null, choice: null };
      case 'field': {
        const { place, type } = this.target(e.object);
        const start = fieldStart(type as Extract<Type, { kind: 'struct' }>, e.field);
        return { place: partOf(place, type, start, e.type), type: e.type, components: null, choice: null };
      }
      case 'swizzle': {
        const object = this.target(e.object);
        const chosen = object.components;
        return {
          ...object,
          components: chosen ? e.components.map((k) => chosen[k] as number) : e.components,
        };
      }
      case 'index':
        return this.indexTarget(e);
      default:
        throw new Error('unreachable: the checker refuses this target');
    }
  }

  private indexTarget(e: Index): Target {
    const object = this.target(e.object);
    const { type } = e.object;
    if (type.kind === 'vector') return { ...object, choice: this.index(e, type.size) };
    const length = lengthOf(type);
    const count = cellsOf(e.type).length;
    const whole = { type: e.type, components: null, choice: null };
    if (e.index.constant) {
      const i = Math.max(0, Math.min(evaluateExpression(e.index) as number, length - 1));
      return { ...whole, place: partOf(object.place, type, i * count, e.type) };
    }
    if (object.place.kind !== 'memory') throw new Error('unreachable: what is indexed lies in memory');
    const { base, offset } = object.place;
    const distance = op('i32.mul', this.index(e, length), i32(sizeOf(cellsOf(e.type))));
    return {
      ...whole,
      place: { kind: 'memory', base: this.body.temporary(op('i32.add', base, distance)), offset },
    };
  }

  private index(e: Index, length: number): Code {
    return clampIndex(this.body, this.scalar(e.index), e.index.type === INT, i32(length));
  }

  protected element(e: Index): readonly Code[] {
    const { type } = e.object;
    const object = this.body.pinAll(this.expression(e.object));
    if (type.kind === 'vector')
      return [choose(this.index(e, type.size), components(this.body, object, type))];
    const count = cellsOf(e.type).length;
    const length = lengthOf(type);
    const part = (i: number) => object.slice(i * count, (i + 1) * count);
    if (e.index.constant) {
      const i = evaluateExpression(e.index) as number;
      return part(Math.max(0, Math.min(i, length - 1)));
    }
    const index = this.index(e, length);
    if (length <= MAX_CHOSEN) {
      const parts = Array.from({ length }, (_, i) => part(i));
      return part(0).map((_, k) =>
        choose(
          index,
          parts.map((cells) => cells[k] as Code),
        ),
      );
    }
    const { base, offset } = this.body.reserve(sizeOf(cellsOf(type)));
    writePlace(this.body, { kind: 'memory', base, offset }, type, object);
    const address = op('i32.add', base, op('i32.mul', index, i32(sizeOf(cellsOf(e.type)))));
    const place: Place = { kind: 'memory', base: this.body.temporary(address), offset };
    return readTarget(this.body, { place, type: e.type, components: null, choice: null });
  }

  protected assign(e: Extract<Expr, { kind: 'assign' }>, wanted: boolean): readonly Code[] {
    let value: readonly Code[];
    let target: Target;
    if (e.operator === null) {
      value = this.expression(e.value);
      if (hasEffects(e.target)) value = this.body.pinAll(value);
      target = this.target(e.target);
    } else {
      target = this.target(e.target);
      const before = readTarget(this.body, target);
      const left = hasEffects(e.value) ? this.body.pinAll(before) : before;
      const right = this.expression(e.value);
      value = arithmetic(this.body, e.operator, left, right, e.target.type, e.value.type);
    }
    if (wanted) value = this.body.pinAll(value);
    writeTarget(this.body, target, value);
    return value;
  }

  protected step(e: Extract<Expr, { kind: 'step' }>, wanted: boolean): readonly Code[] {
    const target = this.target(e.target);
    const name = scalarOf(e.type) as ScalarName;
    let before = readTarget(this.body, target);
    if (wanted && !e.prefix) before = this.body.pinAll(before);
    const operator = e.operator === '++' ? '+' : '-';
    let after = arithmetic(
      this.body,
      operator,
      before,
      before.map((cell) => one(cell, name)),
      e.type,
      e.type,
    );
    if (wanted && e.prefix) after = this.body.pinAll(after);
    writeTarget(this.body, target, after);
    return e.prefix ? after : before;
  }
}

function lengthOf(type: Type): number {
  return type.kind === 'array' ? type.length : type.kind === 'matrix' ? type.columns : componentCount(type);
}
