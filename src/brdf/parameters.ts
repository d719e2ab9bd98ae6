import { BrdfError, type SourcePlace } from './error.ts';
import { BRDF_LIMITS, clip } from './limits.ts';
import type { Parameter, Rgb, SourceLine } from './model.ts';

/** GLSL keywords and names that the file format gives a meaning of its own. */
const RESERVED = new Set(
  'const uniform varying attribute in out inout void bool int uint float vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 if else for while do return break continue discard struct switch case default true false BRDF sampleL pdf main'.split(
    ' ',
  ),
);

/** The table of a file's section of parameters: one a line, in the order of the file. @throws BrdfError */
export function parseParameters(lines: readonly SourceLine[]): Parameter[] {
  const parameters: Parameter[] = [];
  const names = new Set<string>();
  for (const { text, file, line } of lines) {
    const place: SourcePlace = { file, line };
    const comment = text.indexOf('#');
    const fields = (comment < 0 ? text : text.slice(0, comment)).trim().split(/\s+/);
    if (fields[0] === '') continue;
    const description = comment < 0 ? '' : text.slice(comment + 1).trim();
    const parameter = parseParameter(fields, description, place);
    if (names.has(parameter.name))
      throw new BrdfError(place, `a second parameter '${parameter.name}'`, 'different names');
    if (parameters.length === BRDF_LIMITS.parameters) {
      throw new BrdfError(place, 'too many parameters', `at most ${BRDF_LIMITS.parameters}`);
    }
    names.add(parameter.name);
    parameters.push(parameter);
  }
  return parameters;
}

function parseParameter(fields: readonly string[], description: string, place: SourcePlace): Parameter {
  const [type, name = ''] = fields;
  if (type !== 'float' && type !== 'color' && type !== 'bool') {
    throw new BrdfError(place, `'${clip(type ?? '')}' is no type of parameter`, 'float, color or bool');
  }
  if (!/^[A-Za-z_][A-Za-z0-9_]{0,63}$/.test(name) || RESERVED.has(name) || /^gl_|__/.test(name)) {
    throw new BrdfError(
      place,
      `'${clip(name)}' cannot name a parameter`,
      'an identifier that GLSL does not reserve',
    );
  }
  const values = fields.slice(2).map((field) => {
    if (!/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?f?$/.test(field)) {
      throw new BrdfError(place, `parameter ${name}: '${clip(field)}' is no number`, 'a decimal number');
    }
    const value = Number(field.replace(/f$/, ''));
    if (!Number.isFinite(value))
      throw new BrdfError(place, `parameter ${name}: ${clip(field)} is too large`, 'a finite number');
    return value;
  });
  const expectCount = (count: number, what: string) => {
    if (values.length !== count) {
      throw new BrdfError(place, `parameter ${name} has ${values.length} numbers`, `${type} ${name} ${what}`);
    }
  };
  if (type === 'float') {
    expectCount(3, 'MIN MAX DEFAULT');
    const [min, max, value] = values as [number, number, number];
    if (!(min < max))
      throw new BrdfError(place, `parameter ${name}: its range ${min} to ${max} is empty`, 'MIN < MAX');
    if (value < min || value > max) {
      throw new BrdfError(
        place,
        `parameter ${name}: its default ${value} is outside its range`,
        `${min} to ${max}`,
      );
    }
    return { type, name, min, max, default: value, description };
  }
  if (type === 'color') {
    expectCount(3, 'R G B');
    return { type, name, default: values as unknown as Rgb, description };
  }
  expectCount(1, '0 or 1');
  if (values[0] !== 0 && values[0] !== 1)
    throw new BrdfError(place, `parameter ${name}: its default is ${values[0]}`, '0 or 1');
  return { type, name, default: values[0] === 1, description };
}
