/** Finds the texts in source files: what calls are given, with `{holes}` where a template has expressions. */
import { readdirSync, readFileSync } from 'node:fs';
import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync } from 'vite';

export const repository = fileURLToPath(new URL('../../../', import.meta.url));

/** A node of the ESTree syntax tree; what is read of it is checked where it is read. */
export interface SyntaxNode {
  readonly type: string;
  readonly start: number;
  readonly end: number;
  readonly [key: string]: unknown;
}

export interface SourceFile {
  /** From the repository's root. */
  readonly path: string;
  readonly text: string;
  readonly root: SyntaxNode;
}

/** All TypeScript files of a folder of the repository. */
export function sourceFiles(folder: string): SourceFile[] {
  return readdirSync(`${repository}${folder}`, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile() && entry.name.endsWith('.ts'))
    .map((entry) => `${entry.parentPath}/${entry.name}`)
    .toSorted()
    .map((file) => {
      const source = parsed.get(file) ?? parse(file);
      parsed.set(file, source);
      return source;
    });
}

/** Several rules look at the same folders. */
const parsed = new Map<string, SourceFile>();

function parse(file: string): SourceFile {
  const text = readFileSync(file, 'utf8');
  const { program, errors } = parseSync(file, text);
  if (errors.length > 0) throw new Error(`${file}: ${errors[0]?.message}`);
  return { path: relative(repository, file), text, root: program as unknown as SyntaxNode };
}

export const isNode = (value: unknown): value is SyntaxNode =>
  typeof value === 'object' && value !== null && typeof (value as SyntaxNode).type === 'string';

const nodesOf = (value: unknown): SyntaxNode[] =>
  Array.isArray(value) ? value.filter(isNode) : isNode(value) ? [value] : [];

/** This node and every one below it, outer ones first. Types have no texts. */
export function walk(root: SyntaxNode): readonly SyntaxNode[] {
  const found: SyntaxNode[] = [];
  const visit = (node: SyntaxNode): void => {
    if (/^TS(Type|Interface|Literal|Union)/.test(node.type)) return;
    found.push(node);
    for (const value of Object.values(node)) for (const child of nodesOf(value)) visit(child);
  };
  visit(root);
  return found;
}

/** `t`, `toast`; of a method `.edit`; of a class its name. */
export function calleeOf(call: SyntaxNode): string {
  const callee = call.callee as SyntaxNode;
  if (callee.type === 'Identifier') return String(callee.name);
  const property = callee.property as SyntaxNode | undefined;
  return property?.type === 'Identifier' || property?.type === 'PrivateIdentifier' ? `.${property.name}` : '';
}

export const argumentsOf = (call: SyntaxNode): readonly SyntaxNode[] => nodesOf(call.arguments);

export const lineOf = ({ text }: SourceFile, node: SyntaxNode): number =>
  text.slice(0, node.start).split('\n').length;

/** The string that a literal is, null for anything else. */
export function literalOf(node: SyntaxNode | undefined): string | null {
  if (node?.type === 'Literal' && typeof node.value === 'string') return node.value;
  if (node?.type === 'TemplateLiteral' && nodesOf(node.expressions).length === 0)
    return textsOf(node)[0] ?? '';
  return null;
}

/**
 * The texts that an expression can be: of both branches of a condition, joined where they are added. What is not
 * written there is a hole; an expression without a word of its own gives none.
 */
export function textsOf(node: SyntaxNode): string[] {
  return alternatives(node)
    .filter((text) => /[A-Za-z]{2,}/.test(text.replace(/\{\w+\}/g, '')))
    .map(numbered);
}

/** Two holes of one name become `{name}` and `{name2}`. */
function numbered(text: string): string {
  const seen = new Map<string, number>();
  return text.replace(/\{(\w+)\}/g, (_, name: string) => {
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    return `{${name}${count === 1 ? '' : count}}`;
  });
}

function alternatives(node: SyntaxNode): string[] {
  switch (node.type) {
    case 'Literal':
      return [typeof node.value === 'string' ? node.value : holeOf(node)];
    case 'TemplateLiteral': {
      const words = nodesOf(node.quasis).map(({ value }) => String((value as { cooked: string }).cooked));
      const holes = nodesOf(node.expressions).map(holeOf);
      return [words.map((word, i) => word + (holes[i] ?? '')).join('')];
    }
    case 'BinaryExpression':
      if (node.operator !== '+') break;
      return alternatives(node.left as SyntaxNode).flatMap((left) =>
        alternatives(node.right as SyntaxNode).map((right) => left + right),
      );
    case 'ConditionalExpression':
      return [...alternatives(node.consequent as SyntaxNode), ...alternatives(node.alternate as SyntaxNode)];
    case 'LogicalExpression':
      return [...alternatives(node.left as SyntaxNode), ...alternatives(node.right as SyntaxNode)];
  }
  return [holeOf(node)];
}

/** What functions give that is no name: texts of the catalogue, or figures. */
const HOLES: Readonly<Record<string, string>> = {
  '.toLowerCase': 'label',
  fieldLabel: 'label',
  placeOf: 'where',
  '.join': 'list',
  describeEntities: 'name',
};

/** A hole is named after what is put into it, the last name in its expression. */
function holeOf(node: SyntaxNode): string {
  if (node.type === 'CallExpression') {
    const known = HOLES[calleeOf(node)];
    if (known) return `{${known}}`;
    const callee = node.callee as SyntaxNode;
    if (callee.type === 'MemberExpression' && /^\.(slice|toFixed|trim|replace)$/.test(calleeOf(node)))
      return holeOf(callee.object as SyntaxNode);
  }
  let name = 'value';
  for (const inner of walk(node)) if (inner.type === 'Identifier') name = String(inner.name);
  return `{${name}}`;
}
