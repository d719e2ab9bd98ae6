import { componentCount, type Type } from '../types.ts';
import type { Body } from './body.ts';
import { type Code, f32, op, select } from './code.ts';
import { dot, perCell, prefixOf, splat } from './vectors.ts';

type Cells = readonly Code[];

const times = (x: Code, y: Code) => op(`${prefixOf(x, 'float')}.mul`, x, y);
const minus = (x: Code, y: Code) => op(`${prefixOf(x, 'float')}.sub`, x, y);

/** Lengths, products and directions of vectors of one type (or scalars as vectors of one); null for others. */
export function geometric(body: Body, name: string, args: readonly Cells[], type: Type): Cells | null {
  const [a, b, c] = args as readonly [Cells, Cells, Cells];
  const product = (x: Cells, y: Cells) => dot(body, x, y, type);
  const scaled = (x: Cells, factor: Code): Cells => {
    const fixed = body.pin(factor);
    const wide = componentCount(type) === 4 ? body.pin(splat(fixed, 'float')) : fixed;
    return x.map((cell) => times(cell, wide));
  };
  const length = (x: Cells): Code => {
    if (componentCount(type) === 1) return op('f32.abs', x[0] as Code);
    const pinned = body.pinAll(x);
    return op('f32.sqrt', product(pinned, pinned));
  };
  switch (name) {
    case 'length':
      return [length(a)];
    case 'distance':
      return [length(perCell([a, b], minus))];
    case 'dot':
      return [product(a, b)];
    case 'normalize': {
      const pinned = body.pinAll(a);
      return scaled(pinned, op('f32.div', f32(1), length(pinned)));
    }
    case 'cross': {
      const [ax, ay, az] = body.pinAll(a) as [Code, Code, Code];
      const [bx, by, bz] = body.pinAll(b) as [Code, Code, Code];
      const difference = (p: Code, q: Code, r: Code, s: Code) => minus(times(p, q), times(r, s));
      return [difference(ay, bz, az, by), difference(az, bx, ax, bz), difference(ax, by, ay, bx)];
    }
    case 'reflect': {
      const [i, n] = [body.pinAll(a), body.pinAll(b)];
      return perCell([i, scaled(n, op('f32.mul', f32(2), product(n, i)))], minus);
    }
    case 'faceforward': {
      const test = body.pin(op('f32.lt', product(c, b), f32(0)));
      return body.pinAll(a).map((n) => select(test, n, op(`${prefixOf(n, 'float')}.neg`, n)));
    }
    case 'refract': {
      const [i, n] = [body.pinAll(a), body.pinAll(b)];
      const eta = body.pin(c[0] as Code);
      const d = body.pin(product(n, i));
      const rest = op('f32.sub', f32(1), op('f32.mul', d, d));
      const k = body.pin(op('f32.sub', f32(1), op('f32.mul', op('f32.mul', eta, eta), rest)));
      const along = op('f32.add', op('f32.mul', eta, d), op('f32.sqrt', k));
      const refracted = perCell([scaled(i, eta), scaled(n, along)], minus);
      const total = body.pin(op('f32.lt', k, f32(0)));
      const zero = componentCount(type) === 4 ? splat(f32(0), 'float') : f32(0);
      return refracted.map((cell) => select(total, zero, cell));
    }
    default:
      return null;
  }
}
