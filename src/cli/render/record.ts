/** What files say that they were made of, read again and compared. */

import { parseRanges } from '../../pathtracer/ranges.ts';
import { PREFIX, type RenderIdentity, type RenderRecord } from '../../pathtracer/record.ts';
import { CliError } from '../command.ts';

type Attributes = Readonly<Record<string, string | number>>;

/** @throws CliError naming the file and the attribute that is missing or wrong */
export function fromAttributes(attributes: Attributes, fileName: string): RenderRecord {
  const text = (name: string): string => {
    const value = attributes[PREFIX + name];
    if (value === undefined)
      throw new CliError(
        `${fileName}: the header has no ${PREFIX}${name}; expected a file by \`irradia render\``,
      );
    return String(value);
  };
  const number = (name: string): number => {
    const value = Number(text(name));
    if (!Number.isFinite(value))
      throw new CliError(`${fileName}: ${PREFIX}${name} is '${text(name)}'; expected a number`);
    return value;
  };
  const samples = parseRanges(text('samples'));
  if (samples === null)
    throw new CliError(`${fileName}: ${PREFIX}samples is '${text('samples')}'; expected ranges such as 0:64`);
  return {
    renderer: text('renderer') as RenderRecord['renderer'],
    version: text('version'),
    document: text('document'),
    camera: text('camera'),
    seed: number('seed'),
    maxDepth: number('maxDepth'),
    clamp: number('clamp'),
    strategy: text('strategy') as RenderRecord['strategy'],
    name: text('name'),
    samples,
    until: text('until'),
    device: text('device'),
    exposure: number('exposure'),
    toneMapping: text('toneMapping') as RenderRecord['toneMapping'],
    denoised: attributes[`${PREFIX}denoised`] === 'yes',
  };
}

/** What the fields of RenderIdentity are called in messages. */
const FIELDS: Readonly<Record<keyof RenderIdentity, string>> = {
  renderer: 'renderer',
  version: 'version of Irradia',
  document: 'document',
  camera: 'camera',
  seed: 'seed',
  maxDepth: 'maximal depth',
  clamp: 'clamp',
  strategy: 'strategy',
};

/** The first field in which two renderings differ, with both values; null if they are parts of one. */
export function difference(a: RenderIdentity, b: RenderIdentity): string | null {
  for (const [field, what] of Object.entries(FIELDS) as [keyof RenderIdentity, string][]) {
    if (a[field] === b[field]) continue;
    return field === 'camera' ? what : `${what}: ${shown(field, a[field])}, not ${shown(field, b[field])}`;
  }
  return null;
}

const shown = (field: keyof RenderIdentity, value: string | number): string =>
  field === 'document' ? `SHA-256 ${String(value).slice(0, 12)}…` : String(value);
