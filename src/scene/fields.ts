/**
 * The building blocks of the document's schema. Every field is built here once, with its
 * bounds for the parser and, beside them, what a person needs to edit it: a description,
 * a unit and the range that a slider should cover. The editor's inspector, the JSON Schema
 * and the error messages all read these.
 */
import { z } from 'zod';

export type Unit = 'm' | 'mm' | 's' | 'ms' | 'h' | '°' | 'nt' | 'lx' | 'cd' | 'K' | 'EV' | '×';

export type FieldKind =
  | 'number'
  | 'integer'
  | 'boolean'
  | 'color'
  | 'vector2'
  | 'vector3'
  | 'choice'
  | 'text'
  | 'reference'
  | 'group';

export interface FieldInfo {
  kind: FieldKind;
  /** One sentence for a tooltip. */
  description: string;
  unit?: Unit;
  /** The bounds that the parser enforces. */
  min?: number;
  max?: number;
  /** The range that is useful to drag through; any value within the bounds may be typed. */
  slider?: readonly [number, number];
  step?: number;
  /** The values of a 'choice'. */
  choices?: readonly string[];
  /** What a 'reference' names. */
  target?: 'materials' | 'assets' | 'groups';
  /** The field may also be null: switched off. */
  nullable?: boolean;
}

const registry = z.registry<FieldInfo>();

/** How to show and edit a field, for any schema built in this file. */
export function fieldInfo(schema: z.ZodType): FieldInfo | undefined {
  return registry.get(schema);
}

function field<S extends z.ZodType>(schema: S, info: FieldInfo): S {
  const unit = info.unit === undefined || info.unit === '×' ? '' : ` [${info.unit}]`;
  const described = schema.describe(`${info.description}${unit}`);
  registry.add(described, info);
  return described;
}

type Range = readonly [min: number, max: number];
type NumberOptions = { range: Range; unit?: Unit; slider?: Range; step?: number };

export const number = (description: string, { range: [min, max], ...rest }: NumberOptions) =>
  field(z.number().min(min).max(max), { kind: 'number', description, min, max, ...rest });

export const integer = (description: string, { range: [min, max], ...rest }: NumberOptions) =>
  field(z.int().min(min).max(max), { kind: 'integer', description, min, max, step: 1, ...rest });

export const numberOrNull = (description: string, { range: [min, max], ...rest }: NumberOptions) =>
  field(z.number().min(min).max(max).nullable(), {
    kind: 'number',
    description,
    min,
    max,
    nullable: true,
    ...rest,
  });

export const integerOrNull = (description: string, { range: [min, max], ...rest }: NumberOptions) =>
  field(z.int().min(min).max(max).nullable(), {
    kind: 'integer',
    description,
    min,
    max,
    step: 1,
    nullable: true,
    ...rest,
  });

export const boolean = (description: string) => field(z.boolean(), { kind: 'boolean', description });

export const choice = <const T extends readonly [string, ...string[]]>(description: string, choices: T) =>
  field(z.enum(choices), { kind: 'choice', description, choices });

export const choiceOrNull = <const T extends readonly [string, ...string[]]>(
  description: string,
  choices: T,
) => field(z.enum(choices).nullable(), { kind: 'choice', description, choices, nullable: true });

export const text = (description: string, maxLength: number) =>
  field(z.string().max(maxLength), { kind: 'text', description });

/** Tuples of numbers are mutable types here: a recipe assigns `light.position[1] = 2`. */
export const vector2 = (description: string, { range: [min, max], ...rest }: NumberOptions) => {
  const component = z.number().min(min).max(max);
  return field(z.tuple([component, component]), {
    kind: 'vector2',
    description,
    min,
    max,
    ...rest,
  });
};

export const vector3 = (description: string, { range: [min, max], ...rest }: NumberOptions) => {
  const component = z.number().min(min).max(max);
  return field(z.tuple([component, component, component]), {
    kind: 'vector3',
    description,
    min,
    max,
    ...rest,
  });
};

const unitComponent = z.number().min(0).max(1);

/** Linear Rec. 709. Brightness has a field of its own, so components stay within 0..1. */
export const color = (description: string) =>
  field(z.tuple([unitComponent, unitComponent, unitComponent]), {
    kind: 'color',
    description,
    min: 0,
    max: 1,
  });

/**
 * Ids begin with a letter: integer-like keys would be reordered by JavaScript objects,
 * whose order is the order of the outliner, and `__proto__` is not an id.
 */
export const idPattern = /^[A-Za-z][A-Za-z0-9_-]{0,63}$/;

export const id = z.string().regex(idPattern);

export const reference = (description: string, target: 'materials' | 'assets') =>
  field(id, { kind: 'reference', description, target });

export const referenceOrNull = (description: string, target: 'groups') =>
  field(id.nullable(), { kind: 'reference', description, target, nullable: true });

/** A field that is itself an object or a union; its own fields carry their own info. */
export const group = <S extends z.ZodType>(schema: S, description: string): S =>
  field(schema, { kind: 'group', description });

type Defaults<S extends z.ZodRawShape> = {
  readonly [K in keyof S]?: Readonly<z.output<S[K] & z.ZodType>> | undefined;
};

/**
 * The same object as it may stand in a file: fields that have a default may be left out,
 * except for literals, which say what the object is. The output is the complete object,
 * which is what the returned type says.
 */
export function withDefaults<S extends z.ZodRawShape>(
  shape: S,
  defaults: Defaults<S>,
): z.ZodObject<S, z.core.$strict> {
  const fields: Record<string, z.core.SomeType> = {};
  for (const [name, schema] of Object.entries(shape)) {
    const value: unknown = (defaults as Record<string, unknown>)[name];
    fields[name] =
      value === undefined || schema instanceof z.ZodLiteral
        ? schema
        : z._default(schema, () => structuredClone(value));
  }
  return z.strictObject(fields) as unknown as z.ZodObject<S, z.core.$strict>;
}
