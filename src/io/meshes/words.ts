/** Lines of OBJ and MTL files. */

/** Statements whose rest is a name, which may have a # in it: 3ds Max numbers its materials so. */
const named = /^(newmtl|usemtl|mtllib|o|g|map_\w+|norm|bump|disp|decal|refl)\s/i;

/** The words of a line, without its comment; none of a line that is one. */
export function wordsOf(line: string): string[] {
  const text = line.includes('#') && !named.test(line) ? line.replace(/#.*$/, '').trim() : line;
  return text.split(/\s+/);
}

export const withoutComment = (name: string): string => name.replace(/\s+#.*$/, '');
