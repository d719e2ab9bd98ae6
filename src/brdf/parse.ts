import { parseDeclarations } from './declarations.ts';
import { BrdfError, type SourcePlace } from './error.ts';
import { BRDF_LIMITS, clip } from './limits.ts';
import type { BrdfFile, SourceLine } from './model.ts';
import { parseParameters } from './parameters.ts';
import { parseTransmission } from './transmission.ts';

export interface ParseOptions {
  /** The text of an included file, by the path written in `::include`; undefined if there is none. */
  include?: (path: string) => string | undefined;
}

const SECTIONS = ['parameters', 'shader', 'sampling'] as const;
type Section = (typeof SECTIONS)[number];

/**
 * Parses a `.brdf` file: the analytic format of Disney's BRDF Explorer with `::include` and a
 * `::begin sampling` section added.
 *
 * The GLSL itself is not looked at here (src/glsl does that).
 *
 * @param text the file's text
 * @param fileName its name, for messages and for the model's name
 * @throws BrdfError naming file, line and what was expected
 */
export function parseBrdf(text: string, fileName: string, options: ParseOptions = {}): BrdfFile {
  if (text.length > BRDF_LIMITS.characters) {
    throw new BrdfError(
      { file: fileName, line: 1 },
      `the file has ${text.length} characters`,
      `at most ${BRDF_LIMITS.characters}`,
    );
  }
  const lines = text.replace(/^\uFEFF/, '').split(/\r\n|\r|\n/);
  const sections = new Map<Section, { first: number; lines: SourceLine[] }>();
  const header: SourceLine[] = [];
  let kindSeen = false;
  let open: { section: Section; line: number } | null = null;

  for (const [index, raw] of lines.entries()) {
    const place: SourcePlace = { file: fileName, line: index + 1 };
    const line = raw.trim();
    const begin = /^::begin\b\s*(.*)$/.exec(line);
    const end = /^::end\b\s*(.*)$/.exec(line);
    if (begin) {
      const section = sectionNamed(begin[1] ?? '', place);
      if (!kindSeen)
        throw new BrdfError(place, `'${line}' before the kind of file`, "'analytic' on the first line");
      if (open)
        throw new BrdfError(place, `'${line}' inside section '${open.section}'`, `'::end ${open.section}'`);
      if (sections.has(section)) throw new BrdfError(place, `a second section '${section}'`, 'one of each');
      open = { section, line: index + 1 };
      sections.set(section, { first: index + 1, lines: [] });
    } else if (end) {
      const section = sectionNamed(end[1] ?? '', place);
      if (open?.section !== section) {
        throw new BrdfError(
          place,
          `'${line}' without its begin`,
          open ? `'::end ${open.section}'` : undefined,
        );
      }
      open = null;
    } else if (open) {
      sections.get(open.section)?.lines.push({ text: raw, file: fileName, line: index + 1 });
    } else if (line.startsWith('#')) {
      const text = line.replace(/^#+ ?/, '');
      if (!sections.has('parameters')) header.push({ text, ...place });
    } else if (line !== '') {
      if (kindSeen || sections.size > 0)
        throw new BrdfError(place, `'${clip(line)}' outside any section`, 'a comment or ::begin');
      if (line !== 'analytic') {
        throw new BrdfError(place, `'${clip(line)}' is no kind of BRDF file`, "'analytic' on the first line");
      }
      kindSeen = true;
    }
  }
  const last: SourcePlace = { file: fileName, line: lines.length };
  if (open) {
    throw new BrdfError(
      last,
      `section '${open.section}' of line ${open.line} does not end`,
      `'::end ${open.section}'`,
    );
  }
  if (!kindSeen)
    throw new BrdfError({ file: fileName, line: 1 }, 'not a BRDF file', "'analytic' on the first line");
  const parameters = parseParameters(sections.get('parameters')?.lines ?? []);
  const shader = sections.get('shader');
  if (!shader) throw new BrdfError(last, 'the file has no shader', "a section '::begin shader'");
  // One set for both sections: sampling code sees what the shader included.
  const included = new Set<string>();
  const shaderText = spliceIncludes(shader.lines, options, included, []);
  const sampling = sections.get('sampling');
  const samplingText = sampling ? spliceIncludes(sampling.lines, options, included, []) : null;

  const name = (fileName.split(/[\\/]/).pop() ?? fileName).replace(/\.brdf$/i, '') || 'model';
  const documentation = trimBlankLines(header.map(({ text }) => text)).join('\n');
  return {
    name,
    fileName,
    title: firstSentence(documentation) || name,
    documentation,
    declarations: parseDeclarations(header, parameters),
    transmission: parseTransmission(header, parameters),
    parameters,
    shader: { lines: shaderText },
    sampling: samplingText && { lines: samplingText },
  };
}

function sectionNamed(name: string, place: SourcePlace): Section {
  const found = SECTIONS.find((section) => section === name.trim());
  if (!found) throw new BrdfError(place, `no section is named '${clip(name)}'`, SECTIONS.join(', '));
  return found;
}

/** Replaces `::include PATH` by the file's lines; a file that is already in is skipped. */
function spliceIncludes(
  lines: readonly SourceLine[],
  options: ParseOptions,
  included: Set<string>,
  within: readonly string[],
): SourceLine[] {
  const result: SourceLine[] = [];
  for (const source of lines) {
    const directive = /^\s*::include\b\s*(.*?)\s*$/.exec(source.text);
    if (!directive) {
      if (/^\s*::/.test(source.text))
        throw new BrdfError(source, `unknown directive '${clip(source.text.trim())}'`, '::include or ::end');
      result.push(source);
      continue;
    }
    const path = directive[1] ?? '';
    if (path === '') throw new BrdfError(source, '::include names no file', '::include lib/NAME.glsl');
    if (within.includes(path))
      throw new BrdfError(source, `${clip(path)} includes itself`, 'no circle of includes');
    if (included.has(path)) continue;
    if (within.length >= BRDF_LIMITS.includeDepth) {
      throw new BrdfError(
        source,
        'includes are nested too deep',
        `at most ${BRDF_LIMITS.includeDepth} levels`,
      );
    }
    const text = options.include?.(path);
    if (text === undefined)
      throw new BrdfError(source, `there is no file '${clip(path)}' to include`, 'a file of models/');
    included.add(path);
    const inner = text
      .split(/\r\n|\r|\n/)
      .map((line, index) => ({ text: line, file: path, line: index + 1 }));
    for (const line of spliceIncludes(inner, options, included, [...within, path])) result.push(line);
    if (result.length > BRDF_LIMITS.includedLines) {
      throw new BrdfError(source, 'too many lines with all includes', `at most ${BRDF_LIMITS.includedLines}`);
    }
  }
  return result;
}

function trimBlankLines(lines: readonly string[]): string[] {
  const first = lines.findIndex((line) => line.trim() !== '');
  if (first < 0) return [];
  const last = lines.findLastIndex((line) => line.trim() !== '');
  return lines.slice(first, last + 1).map((line) => line.trimEnd());
}

function firstSentence(documentation: string): string {
  const paragraph = documentation.split(/\n\s*\n/)[0] ?? '';
  return (/^.*?[.!?](?=\s|$)/s.exec(paragraph)?.[0] ?? paragraph)
    .replace(/\s+/g, ' ')
    .replace(/\.$/, '')
    .trim();
}
