/** What the editor's workers bring with them. */
import { posix } from 'node:path';
import { isNode, literalOf, type SourceFile, type SyntaxNode, walk } from './source-texts.ts';

/** The editor's modules that its workers import, directly or not. */
export function workerImports(files: readonly SourceFile[]): string[] {
  const byPath = new Map(files.map((file) => [file.path, file]));
  const reached = new Set<string>();
  const visit = (path: string) => {
    if (reached.has(path)) return;
    reached.add(path);
    const file = byPath.get(path);
    if (!file) return;
    for (const module of importsOf(file)) visit(posix.join(posix.dirname(path), module));
  };
  for (const { path } of files) if (/worker\.ts$/.test(path)) visit(path);
  return [...reached];
}

/** Modules of relative addresses, those of types apart. */
function importsOf({ root }: SourceFile): string[] {
  const found: string[] = [];
  for (const node of walk(root)) {
    if (!/^(Import(Declaration|Expression)|Export(Named|All)Declaration)$/.test(node.type)) continue;
    if (node.importKind === 'type' || node.exportKind === 'type' || onlyTypes(node)) continue;
    const module = isNode(node.source) ? literalOf(node.source) : null;
    if (module?.startsWith('.')) found.push(module);
  }
  return found;
}

function onlyTypes({ specifiers }: SyntaxNode): boolean {
  const kinds = Array.isArray(specifiers) ? specifiers.map((one) => (one as SyntaxNode).importKind) : [];
  return kinds.length > 0 && kinds.every((kind) => kind === 'type');
}
