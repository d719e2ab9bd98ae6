/** A document without what its defaults say anyway: for links, where every character counts. */
import type { z } from 'zod';
import { type Document, documentFileSchema } from './schema.ts';

/** Plain JSON, which parses to the same document. */
export function compactDocument(document: Document): object {
  return compacted(documentFileSchema, document) as object;
}

/** The schema itself says what may be left out, so a new field needs nothing here. */
function compacted(schema: z.core.$ZodType, value: unknown): unknown {
  const { def } = schema._zod as { def: z.core.$ZodTypes['_zod']['def'] };
  switch (def.type) {
    case 'default':
      return isSame(value, def.defaultValue) ? undefined : compacted(def.innerType, value);
    case 'object':
      return mapped(value, (key, part) => {
        const field = def.shape[key];
        return field ? compacted(field, part) : part;
      });
    case 'record':
      return mapped(value, (_, part) => compacted(def.valueType, part));
    case 'union': {
      const option = 'discriminator' in def ? optionFor(def as Discriminated, value) : undefined;
      return option ? compacted(option, value) : value;
    }
    default:
      return value;
  }
}

type Discriminated = z.core.$ZodDiscriminatedUnionDef;

function optionFor({ options, discriminator }: Discriminated, value: unknown): z.core.$ZodType | undefined {
  const kind = (value as Record<string, unknown>)[discriminator];
  return options.find((option) => {
    const { def } = option._zod as { def: Partial<z.core.$ZodObjectDef> };
    const literal = def.shape?.[discriminator]?._zod.def as
      | Partial<z.core.$ZodLiteralDef<string>>
      | undefined;
    return literal?.values?.includes(String(kind));
  });
}

function mapped(value: unknown, map: (key: string, part: unknown) => unknown): unknown {
  const parts = Object.entries(value as object).map(([key, part]) => [key, map(key, part)] as const);
  return Object.fromEntries(parts.filter(([, part]) => part !== undefined));
}

/** Of JSON values. */
export function isSame(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (Array.isArray(a) !== Array.isArray(b)) return false;
  const [left, right] = [Object.entries(a), Object.entries(b)];
  return (
    left.length === right.length &&
    left.every(([key, value]) => Object.hasOwn(b, key) && isSame(value, (b as Record<string, unknown>)[key]))
  );
}
