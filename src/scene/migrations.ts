/**
 * Documents of older versions become documents of this version, one version at a time, as
 * plain JSON: a migration knows the shapes of its own two versions and nothing of today's.
 */
import { DocumentError } from './error.ts';
import { documentVersion } from './schema.ts';

export type PlainObject = Record<string, unknown>;

/** `migrations[n]` turns a document of version n into one of version n + 1. */
const migrations: Readonly<Record<number, (document: PlainObject) => PlainObject>> = {};

export function migrate(document: PlainObject, fileName: string): PlainObject {
  const { version } = document;
  const fail = (message: string) => new DocumentError(fileName, [{ path: 'version', message }]);
  if (typeof version !== 'number' || !Number.isSafeInteger(version) || version < 1)
    throw fail('expected the version of the document format, a whole number from 1');
  if (version > documentVersion)
    throw fail(
      `the document has version ${version}, this Irradia reads up to ${documentVersion}; open it with a newer one`,
    );
  let migrated = document;
  for (let from = version; from < documentVersion; from += 1) {
    const step = migrations[from];
    if (step === undefined) throw fail(`version ${from} can no longer be read`);
    migrated = { ...step(migrated), version: from + 1 };
  }
  return migrated;
}
