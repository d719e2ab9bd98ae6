/** Patterns as text: what a document has of them, checked. */
import { z } from 'zod';
import { decodeBase64 } from '../base64.ts';
import { DocumentError, schemaIssues } from '../error.ts';
import { withDefaults } from '../fields.ts';
import type { Asset } from '../schema.ts';
import { PATTERN_TYPE, type PatternName, patternNames } from './asset.ts';
import { brushed } from './brushed.ts';
import { concrete } from './concrete.ts';
import { granite } from './granite.ts';
import { type Common, commonDefaults, commonShape, type Kind } from './kind.ts';
import { leather } from './leather.ts';
import { marble } from './marble.ts';
import { weave } from './weave.ts';
import { wood } from './wood.ts';

const kinds = { wood, marble, granite, concrete, weave, leather, brushed } satisfies Record<
  PatternName,
  unknown
>;

/** A kind without the types of its own settings: those have been checked when one gets them. */
export const kindOf = (name: PatternName): Kind => kinds[name] as unknown as Kind;

/** All settings of a kind, in the order in which they are shown. */
export const shapeOf = (name: PatternName): z.ZodRawShape => {
  const { size, seed, color, relief } = commonShape;
  return { color, ...kindOf(name).shape, relief, seed, size };
};

export type PatternValue = number | readonly [number, number, number];
export type Pattern = Common & { readonly pattern: PatternName } & Readonly<
    Record<string, PatternValue | string>
  >;

const schemas = Object.fromEntries(
  patternNames.map((name) => [
    name,
    withDefaults({ pattern: z.literal(name), ...shapeOf(name) }, {
      ...commonDefaults,
      ...kindOf(name).defaults,
    } as unknown as Record<string, never>),
  ]),
) as unknown as Readonly<Record<PatternName, z.ZodType<Pattern>>>;

export const defaultPattern = (name: PatternName): Pattern => schemas[name].parse({ pattern: name });

/** Longer is no pattern. */
const MOST_BYTES = 4096;

/** @throws DocumentError with the field that is wrong */
export function readPattern(bytes: Uint8Array, name: string): Pattern {
  const fail = (path: string, message: string) => new DocumentError(name, [{ path, message }]);
  if (bytes.length > MOST_BYTES)
    throw new DocumentError(name, [
      { path: '', message: `too long for a pattern: at most ${MOST_BYTES} bytes` },
    ]);
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch {
    throw fail('', 'not JSON');
  }
  if (typeof json !== 'object' || json === null || Array.isArray(json))
    throw fail('', 'expected a JSON object');
  const { pattern } = json as { pattern?: unknown };
  if (typeof pattern !== 'string' || !Object.hasOwn(kinds, pattern))
    throw fail('pattern', `expected ${patternNames.join(', ')}`);
  const result = schemas[pattern as PatternName].safeParse(json);
  if (!result.success) throw new DocumentError(name, schemaIssues(result.error));
  return result.data;
}

/** @throws DocumentError with the field that is wrong */
export const readPatternAsset = ({ data, name }: Asset): Pattern => readPattern(decodeBase64(data), name);

/** @throws DocumentError with the field that is wrong */
export function patternAsset(
  pattern: { readonly pattern: PatternName } & Readonly<Record<string, unknown>>,
): Asset {
  const name = kindOf(pattern.pattern).title;
  const bytes = new TextEncoder().encode(JSON.stringify(pattern));
  readPattern(bytes, name);
  return { name, mediaType: PATTERN_TYPE, data: btoa(String.fromCharCode(...bytes)) };
}
