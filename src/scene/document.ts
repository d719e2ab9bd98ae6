/** Documents from and to text. */
import { freeze } from 'immer';
import { DocumentError, type Path, pathText, schemaIssues } from './error.ts';
import { findJsonFault } from './json-position.ts';
import { migrate, type PlainObject } from './migrations.ts';
import { type Document, documentFileSchema } from './schema.ts';
import { documentIssues } from './validate.ts';

/** No document is nested this deep, nor has this many values: what is, is not a document. */
const maxDepth = 16;
const maxValues = 4_000_000;
const maxIssues = 20;

/**
 * A document from the text of a file or from its parsed JSON; fields that were left out have
 * their defaults. Throws DocumentError and nothing else, whatever the input is.
 */
export function parseDocument(input: unknown, fileName: string): Document {
  const json = typeof input === 'string' ? parseJson(input, fileName) : input;
  if (typeof json !== 'object' || json === null || Array.isArray(json))
    throw whole(fileName, 'not an Irradia document: expected a JSON object');
  const { format } = json as PlainObject;
  if (format !== 'irradia')
    throw new DocumentError(fileName, [
      { path: 'format', message: 'not an Irradia document: expected "irradia"' },
    ]);
  checkExtent(json, fileName);
  const result = documentFileSchema.safeParse(migrate(json as PlainObject, fileName));
  const issues = result.success ? documentIssues(result.data) : schemaIssues(result.error);
  if (!result.success || issues.length > 0) throw new DocumentError(fileName, issues.slice(0, maxIssues));
  return freeze(result.data, true);
}

/** An empty scene. */
export function createDocument(name = 'Untitled'): Document {
  return parseDocument({ format: 'irradia', version: 1, name }, 'new document');
}

/** The text of a document: every field, in the order of the schema, each collection in its own. */
export function serializeDocument(document: Document): string {
  // Parsing puts the fields in order, wherever commands and imports added theirs.
  return `${JSON.stringify(documentFileSchema.parse(document), null, 2)}\n`;
}

const whole = (fileName: string, message: string): DocumentError =>
  new DocumentError(fileName, [{ path: '', message }]);

function parseJson(text: string, fileName: string): unknown {
  // A byte order mark is not JSON, yet some editors write one.
  const json = text.startsWith('\uFEFF') ? text.slice(1) : text;
  try {
    return JSON.parse(json);
  } catch (cause) {
    const fault = findJsonFault(json);
    const place = fault === null ? '' : ` at line ${fault.line}, column ${fault.column}: ${fault.message}`;
    throw new DocumentError(fileName, [{ path: '', message: `not JSON${place}` }], { cause });
  }
}

/** Refuses what is too deep or too big before a validator walks it. Works without recursion. */
function checkExtent(json: object, fileName: string): void {
  let values = 0;
  const pending: [path: Path, value: object][] = [[[], json]];
  for (let next = pending.pop(); next !== undefined; next = pending.pop()) {
    const [path, value] = next;
    if (path.length > maxDepth)
      throw new DocumentError(fileName, [
        { path: pathText(path), message: `nested more than ${maxDepth} levels deep` },
      ]);
    for (const [key, child] of Object.entries(value)) {
      values += 1;
      // Validators pass over it in silence.
      if (key === '__proto__')
        throw new DocumentError(fileName, [
          { path: pathText([...path, key]), message: 'not a name or an id' },
        ]);
      if (values > maxValues) throw whole(fileName, `more than ${maxValues} values`);
      if (typeof child === 'object' && child !== null)
        pending.push([[...path, Array.isArray(value) ? Number(key) : key], child]);
    }
  }
}
