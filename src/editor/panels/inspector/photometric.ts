import type { Bound } from './field.ts';
export function photometricUnits(_type: string, _field: string): undefined | string[] {
  return undefined;
}
export function photometricRow(..._: unknown[]): Bound | undefined {
  return undefined;
}
