/** What is wrong with a document, and where. */
import type { z } from 'zod';

export type Path = readonly (string | number)[];

export interface DocumentIssue {
  /** `lights.key.position[1]`; empty when the whole document is meant. */
  path: string;
  message: string;
}

/** `['lights', 'key', 'position', 1]` as `lights.key.position[1]`. */
export function pathText(path: readonly PropertyKey[]): string {
  let text = '';
  for (const key of path) {
    if (typeof key === 'number') text += `[${key}]`;
    else if (typeof key === 'string' && /^[A-Za-z_][A-Za-z0-9_-]*$/.test(key))
      text += text === '' ? key : `.${key}`;
    else text += `[${JSON.stringify(shortened(String(key)))}]`;
  }
  return text;
}

/** Names from a stranger's file can be megabytes long; a message should not be. */
export function shortened(text: string, length = 80): string {
  return text.length <= length ? text : `${text.slice(0, length)}…`;
}

/** A schema's findings, in our words where zod's are for programmers. */
export function schemaIssues(error: z.ZodError, prefix: Path = []): DocumentIssue[] {
  return error.issues.map((issue) => {
    const path = [...prefix, ...issue.path];
    if (issue.code === 'unrecognized_keys') {
      const key = issue.keys[0] ?? '';
      return { path: pathText([...path, key]), message: 'there is no such field' };
    }
    if (issue.code === 'invalid_key') return { path: pathText(path), message: 'not a valid name or id here' };
    return { path: pathText(path), message: shortened(issue.message, 400) };
  });
}

/** A document that cannot be read or would become invalid. The message says file, path and fault. */
export class DocumentError extends Error {
  override readonly name = 'DocumentError';
  readonly file: string;
  /** Path of the first field that is wrong. */
  readonly path: string;
  readonly issues: readonly DocumentIssue[];

  constructor(file: string, issues: readonly DocumentIssue[], options?: ErrorOptions) {
    const first = issues[0] ?? { path: '', message: 'invalid' };
    const others = issues.length > 1 ? ` (and ${issues.length - 1} more)` : '';
    const place = first.path === '' ? '' : `${first.path}: `;
    super(`${file}: ${place}${first.message}${others}`, options);
    this.file = file;
    this.path = first.path;
    this.issues = issues;
  }
}
